//! Taylor series of solutions: coefficients, steps, what is between them.

mod edges;
mod recurrences;
mod solutions;
