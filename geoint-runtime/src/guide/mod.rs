//! A guide in nineteen pages. Each page opens with one sentence and a program that runs.
//!
//! | page | subject |
//! |---|---|
//! | [First picture](_01_first_picture) | add the crate, run a pendulum, plot it |
//! | [Which attribute](_02_which_attribute) | energy, Lagrangian, contact energy or field; three ways to write friction |
//! | [Which method](_03_which_method) | a table by question, with measured errors |
//! | [The language of energies](_04_language) | types, loops, branches and functions that an energy may use |
//! | [The report, line by line](_05_report) | how to read what was derived and proven |
//! | [A run in practice](_06_runs) | step size, output, parameters, sweeps, saving |
//! | [Energy kept exactly](_07_energy) | discrete gradients, projections, your own invariants |
//! | [Friction, heat, driving](_08_friction) | contact systems, damping and forces |
//! | [Planets](_09_planets) | Kepler flows, adaptive steps, close encounters |
//! | [Lagrangians, mechanisms, constraints](_10_mechanisms) | arms, linkages and closed chains |
//! | [Fields with integrals, rigid bodies](_11_fields) | first integrals, Poisson structures, attitudes |
//! | [Events, sections, states between steps](_12_events) | impacts, Poincaré sections, dense output |
//! | [Games and real time](_13_real_time) | `f32`, fixed frames, no allocation, `no_std` |
//! | [When the macro cannot help](_14_by_hand) | sizes read at run time, tables, functions of other crates |
//! | [Coming from other libraries](_15_coming_from) | REBOUND, heyoka, DifferentialEquations.jl, GeometricIntegrators.jl, odeint, SciPy |
//! | [Errors and remedies](_16_errors) | messages, their meaning, repairs that compile |
//! | [Evidence](_17_evidence) | which claims are proven, checked or measured |
//! | [Limits](_18_limits) | sizes, compile times, missed pulses |
//! | [Glossary](_19_glossary) | fifty words of the field |

// Blocks with `standalone_crate` are the slowest to compile. They compile side by side, and the other blocks in one piece.
pub mod _01_first_picture;
pub mod _02_which_attribute;
pub mod _03_which_method;
pub mod _04_language;
pub mod _05_report;
pub mod _06_runs;
pub mod _07_energy;
pub mod _08_friction;
pub mod _09_planets;
pub mod _10_mechanisms;
pub mod _11_fields;
pub mod _12_events;
pub mod _13_real_time;
pub mod _14_by_hand;
pub mod _15_coming_from;
pub mod _16_errors;
pub mod _17_evidence;
pub mod _18_limits;
pub mod _19_glossary;
