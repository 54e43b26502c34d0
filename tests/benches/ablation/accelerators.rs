//! The accelerators of implicit steps, by the names of their switches in `geoint-runtime/src/ablation.rs`.

use Group::{Contact, Gauss, Many, OrderFour};

/// A group of rows.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Group {
    Gauss,
    Contact,
    OrderFour,
    Many,
}

impl Group {
    pub(crate) const ALL: [Group; 4] = [Gauss, Contact, OrderFour, Many];

    /// The first word of the names of its rows.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Gauss => "Gauss",
            Contact => "contact",
            OrderFour => "order 4",
            Many => "20 particles",
        }
    }
}

/// An accelerator.
pub(crate) struct Accelerator {
    pub(crate) name: &'static str,
    /// The technique, in a few words.
    pub(crate) technique: &'static str,
    /// Lines of code of the accelerator in the runtime, without comments and tests.
    pub(crate) lines: u32,
    /// The groups on which the accelerator acts.
    pub(crate) groups: &'static [Group],
}

macro_rules! accelerators {
    ($($name:ident: $lines:literal, $groups:expr, $technique:literal;)*) => {
        &[$(Accelerator { name: stringify!($name), technique: $technique, lines: $lines, groups: &$groups }),*]
    };
}

/// All accelerators.
pub(crate) const ACCELERATORS: &[Accelerator] = accelerators! {
    extrapolation: 100, [Gauss, Contact, OrderFour, Many], "increments are extrapolated";
    eleven_points: 12, [Gauss, Contact, OrderFour, Many], "eleven increments, not four";
    ring: 14, [Gauss, Contact, OrderFour, Many], "ring of increments for odd numbers of unknowns";
    explicit_guess: 70, [Gauss, Contact, OrderFour, Many], "explicit step as the first guess";
    substeps: 150, [Gauss], "substeps extrapolate few increments and the error of earlier substeps";
    inline_repeat: 58, [Gauss, Contact, OrderFour], "second and third evaluation inline";
    measured_curvature: 20, [Gauss, Contact, OrderFour, Many], "curvature measured each 64th step";
    unmeasured: 18, [Gauss, OrderFour, Many], "first corrections not measured";
    series: 35, [OrderFour], "two terms of Neumann's series";
    series_matrix: 15, [OrderFour], "matrix of first order for the series";
    cramer_two: 14, [Gauss, Contact, OrderFour], "Cramer's rule, 2 unknowns";
    cramer_three: 24, [Gauss, Contact, OrderFour], "adjugate, 3 unknowns";
    pairs: 75, [Gauss, Contact, OrderFour], "elimination in pairs, 4 unknowns and more";
    copy_by_entry: 3, [Gauss, Contact, OrderFour], "solution copied by numbers";
    carries: 25, [OrderFour], "rounding errors carried in order 4";
    one_function: 22, [OrderFour], "equation of order 4 out of line";
    fixed_point: 70, [Many], "fixed-point iteration, more than 12 unknowns";
    fixed_point_pause: 3, [Many], "pause after a failed fixed point";
    no_matrix: 15, [Many], "fixed point without the matrix";
    constant_matrix: 100, [Many], "constant matrix inverted once";
    known_factors: 15, [Contact], "contact factors of time alone computed once";
    zero_blocks: 15, [Contact], "zero derivatives of L omitted";
    last_evaluation: 90, [Gauss, Contact], "forces from the last evaluation";
    last_velocity: 4, [Contact], "velocity found from the last one";
};
