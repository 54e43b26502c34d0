//! Taylor series of solutions: coefficients, steps, what is between them.

mod dense;
mod edges;
mod recurrences;
mod solutions;
