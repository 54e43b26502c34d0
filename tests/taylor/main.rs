//! Taylor series of solutions: coefficients, steps, what is between them.

#![allow(clippy::excessive_precision, reason = "digits as they are published")]

mod conditions;
mod dense;
mod edges;
mod events;
mod going_on;
mod output;
mod recurrences;
mod rest;
mod scales;
mod solutions;
