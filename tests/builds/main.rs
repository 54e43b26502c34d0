//! What must hold in every build: long runs, equal bits, single precision. CI runs these without the standard library, with fused operations, and
//! optimised.

mod conservation;
mod same_bits;
mod single;
mod trajectories;
