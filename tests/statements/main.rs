//! Statements of two documents that no other test carries: a thesis on ODE solvers that preserve first integrals (T. Aung, 2000) and a talk on
//! contact integrators. T48 is statement 48 of the thesis, S24 is statement 24 of the talk; `tests/STATEMENTS.md` lists all of them. Expected
//! numbers were computed beforehand by another program from the formulas of the documents.

#![allow(clippy::excessive_precision, reason = "digits as another program printed them")]

mod costs;
mod derivative;
mod energy_method;
mod entropy;
mod factors;
mod fields;
mod herglotz;
mod impacts;
mod leapfrog;
mod measure;
mod mechanics;
mod neurons;
mod sampling;
mod satellite;
mod singular;
mod velocities;
mod waves;
