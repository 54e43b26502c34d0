//! Runs that are hard: very long, close to collisions, chaotic, stiff, in extreme units. A quick part in every `cargo test`, and a long one that
//! writes `tests/stress/README.md`: `cargo test --profile bench -p geoint-tests --test stress -- --ignored`.

mod quick;
mod rounding;
mod run;
mod systems;

/// Only where optimised: without, it would take hours, and minutes to build.
#[cfg(not(debug_assertions))]
mod long;
