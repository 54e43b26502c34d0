//! What must hold in every build: long runs and single precision. CI runs these without the standard library too, and optimised with a hundred
//! thousand steps of every method.

mod conservation;
mod single;
mod trajectories;
