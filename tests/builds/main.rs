//! Tests that must pass in every build of the runtime. Continuous integration also runs them without the standard library and with the operations of
//! the processor. An optimised build (`cargo test --release -p geoint-tests --test builds`) takes 10⁵ steps in single precision.

/// Conservation of energy and momenta.
mod conservation;
/// Single precision.
mod single;
/// Equal bits of a trajectory, however a program asks for it.
mod trajectories;
