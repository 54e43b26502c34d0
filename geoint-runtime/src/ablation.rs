//! Switches of the accelerators of implicit steps. Each one is on in every build, except in the builds of the ablation benchmark.
//!
//! `--cfg 'geoint_without="name"'` switches the accelerator `name` off. Results then differ by rounding errors only. The benchmark
//! `tests/benches/ablation` compiles one variant for each name and writes the gains to `tests/benches/ABLATION.md`.

/// Implicit steps extrapolate the increments of previous steps. Without: each step starts from the explicit guess.
pub(crate) const EXTRAPOLATION: bool = !cfg!(geoint_without = "extrapolation");

/// The first guess is an explicit step. Without: the increment zero.
pub(crate) const EXPLICIT_GUESS: bool = !cfg!(geoint_without = "explicit_guess");

/// The curvature of the equation is measured in each 64th step, and bounds the last correction. Without: the bound is √(ε/2²⁰).
pub(crate) const MEASURED_CURVATURE: bool = !cfg!(geoint_without = "measured_curvature");

/// Cramer's rule for two unknowns. Without: elimination with exchanges.
pub(crate) const CRAMER_TWO: bool = !cfg!(geoint_without = "cramer_two");

/// The adjugate for three unknowns. Without: elimination with exchanges.
pub(crate) const CRAMER_THREE: bool = !cfg!(geoint_without = "cramer_three");

/// Four unknowns and more are eliminated in pairs. Without: one by one.
pub(crate) const PAIRS: bool = !cfg!(geoint_without = "pairs");

/// More than twelve unknowns are solved by fixed-point iteration while it converges fast. Without: by Newton's iteration.
pub(crate) const FIXED_POINT: bool = !cfg!(geoint_without = "fixed_point");
