//! Hard runs: very long, close to collisions, chaotic, stiff, in extreme units. A quick part belongs to every `cargo test`. A long part writes
//! `tests/stress/README.md`: `cargo test --profile bench -p geoint-tests --test stress -- --ignored`.

mod quick;
mod rounding;
mod run;
mod systems;

/// The long part exists in optimised builds only. Without optimisation it would take hours to run, and minutes to build.
#[cfg(not(debug_assertions))]
mod long;
