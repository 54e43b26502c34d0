//! What must hold in every build: long runs and single precision. CI runs these without the standard library too. Optimised
//! (`cargo test --release --test builds`) every method takes a hundred thousand steps.

mod conservation;
mod single;
mod trajectories;
