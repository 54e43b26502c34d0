//! Switches of the accelerators of implicit steps. Each one is on in every build, except in the builds of the ablation benchmark.
//!
//! `--cfg 'geoint_without="name"'` switches the accelerator `name` off. Results then differ by rounding errors only. The benchmark
//! `tests/benches/ablation` compiles one variant for each name and writes the gains to `tests/benches/ABLATION.md`.

/// Implicit steps extrapolate the increments of the steps before them. Without: each step starts from the explicit guess.
pub(crate) const EXTRAPOLATION: bool = !cfg!(geoint_without = "extrapolation");

/// The extrapolation uses eleven increments. Without: four.
pub(crate) const ELEVEN_POINTS: bool = !cfg!(geoint_without = "eleven_points");

/// An odd number of unknowns is pushed into a ring of increments. Without: all increments move by one place.
pub(crate) const RING: bool = !cfg!(geoint_without = "ring");

/// The first guess is an explicit step. Without: the increment zero.
pub(crate) const EXPLICIT_GUESS: bool = !cfg!(geoint_without = "explicit_guess");

/// Substeps of compositions extrapolate four increments and the error of the two substeps before. Without: they guess as steps do.
pub(crate) const SUBSTEPS: bool = !cfg!(geoint_without = "substeps");

/// The second and the third evaluation of a step are compiled into the loop over steps. Without: they call the search.
pub(crate) const INLINE_REPEAT: bool = !cfg!(geoint_without = "inline_repeat");

/// The curvature of the equation is measured in each 64th step, and bounds the last correction. Without: the bound is √(ε/2²⁰).
pub(crate) const MEASURED_CURVATURE: bool = !cfg!(geoint_without = "measured_curvature");

/// The first corrections are not measured where steps remove drift, nor in compositions. Without: each correction is measured.
pub(crate) const UNMEASURED: bool = !cfg!(geoint_without = "unmeasured");

/// Two terms of Neumann's series replace the elimination where a third one is below rounding. Without: elimination.
pub(crate) const SERIES: bool = !cfg!(geoint_without = "series");

/// The series of order 4 uses a matrix that is correct to first order. Without: the derivative.
pub(crate) const SERIES_MATRIX: bool = !cfg!(geoint_without = "series_matrix");

/// Cramer's rule for two unknowns. Without: elimination with exchanges.
pub(crate) const CRAMER_TWO: bool = !cfg!(geoint_without = "cramer_two");

/// The adjugate for three unknowns. Without: elimination with exchanges.
pub(crate) const CRAMER_THREE: bool = !cfg!(geoint_without = "cramer_three");

/// Four unknowns and more are eliminated in pairs. Without: one by one.
pub(crate) const PAIRS: bool = !cfg!(geoint_without = "pairs");

/// The solution of a search is copied number by number. Without: as a block.
pub(crate) const COPY_BY_ENTRY: bool = !cfg!(geoint_without = "copy_by_entry");

/// Equations of order 4 count with the rounding errors of sums and of the last correction. Without: they ignore both.
pub(crate) const CARRIES: bool = !cfg!(geoint_without = "carries");

/// The equation of order 4 in four unknowns and more is one function. Without: it is compiled into each place that evaluates it.
pub(crate) const ONE_FUNCTION: bool = !cfg!(geoint_without = "one_function");

/// More than twelve unknowns are solved by fixed-point iteration while it converges fast. Without: by Newton's iteration.
pub(crate) const FIXED_POINT: bool = !cfg!(geoint_without = "fixed_point");

/// After a failure, the fixed-point iteration pauses for 256 steps. Without: each step tries it.
pub(crate) const FIXED_POINT_PAUSE: bool = !cfg!(geoint_without = "fixed_point_pause");

/// The fixed-point iteration evaluates the equation without its matrix. Without: with it.
pub(crate) const NO_MATRIX: bool = !cfg!(geoint_without = "no_matrix");

/// The matrix of a quadratic energy is inverted once for all steps. Without: Newton's iteration.
pub(crate) const CONSTANT_MATRIX: bool = !cfg!(geoint_without = "constant_matrix");

/// Contact factors that depend on time only are computed once a step. Without: in each evaluation.
pub(crate) const KNOWN_FACTORS: bool = !cfg!(geoint_without = "known_factors");

/// Contact stages omit second derivatives of L that are zero. Without: they multiply by zero.
pub(crate) const ZERO_BLOCKS: bool = !cfg!(geoint_without = "zero_blocks");

/// Forces at the solution are those of the last evaluation and a linear change. Without: the equation is evaluated once more.
pub(crate) const LAST_EVALUATION: bool = !cfg!(geoint_without = "last_evaluation");

/// The velocity at the start of a step is found from the velocity at the end of the step before. Without: from zero.
pub(crate) const LAST_VELOCITY: bool = !cfg!(geoint_without = "last_velocity");
