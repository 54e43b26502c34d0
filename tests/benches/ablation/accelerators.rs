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
    explicit_guess: 70, [Gauss, Contact, OrderFour, Many], "explicit step as the first guess";
    measured_curvature: 20, [Gauss, Contact, OrderFour, Many], "curvature measured each 64th step";
    cramer_two: 14, [Gauss, Contact, OrderFour], "Cramer's rule, 2 unknowns";
    cramer_three: 24, [Gauss, Contact, OrderFour], "adjugate, 3 unknowns";
    pairs: 75, [Gauss, Contact, OrderFour], "elimination in pairs, 4 unknowns and more";
    fixed_point: 70, [Many], "fixed-point iteration, more than 12 unknowns";
};
