//! The accelerators of implicit steps, by the names of their switches in `geoint-runtime/src/ablation.rs`.

/// An accelerator.
pub(crate) struct Accelerator {
    pub(crate) name: &'static str,
    /// The technique, in a few words.
    pub(crate) technique: &'static str,
    /// Lines of code, without comments and tests, that the runtime would lose with it.
    pub(crate) lines: u32,
}

macro_rules! accelerators {
    ($($name:ident: $lines:literal, $technique:literal;)*) => {
        &[$(Accelerator { name: stringify!($name), technique: $technique, lines: $lines }),*]
    };
}

/// All of them.
pub(crate) const ACCELERATORS: &[Accelerator] = accelerators! {
    extrapolation: 100, "increments are extrapolated";
    eleven_points: 12, "eleven increments, not four";
    ring: 14, "ring of increments for odd numbers of unknowns";
    explicit_guess: 70, "explicit step as the first guess";
    substeps: 150, "substeps extrapolate few increments and the error of earlier substeps";
    inline_repeat: 58, "second and third evaluation inline";
    measured_curvature: 20, "curvature measured each 64th step";
    unmeasured: 18, "first corrections not measured";
    series: 35, "two terms of Neumann's series";
    series_matrix: 15, "matrix of first order for the series";
    cramer_two: 14, "Cramer's rule, 2 unknowns";
    cramer_three: 24, "adjugate, 3 unknowns";
    pairs: 75, "elimination in pairs, 4 unknowns and more";
    copy_by_entry: 3, "solution copied by numbers";
    carries: 25, "rounding errors carried in order 4";
    one_function: 22, "equation of order 4 out of line";
    fixed_point: 70, "fixed-point iteration, more than 12 unknowns";
    fixed_point_pause: 3, "pause after a failed fixed point";
    no_matrix: 15, "fixed point without the matrix";
    constant_matrix: 100, "constant matrix inverted once";
    known_factors: 15, "contact factors of time alone computed once";
    zero_blocks: 15, "zero derivatives of L omitted";
    last_evaluation: 90, "forces from the last evaluation";
    last_velocity: 4, "velocity found from the last one";
};
