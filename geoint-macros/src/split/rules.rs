//! Which pieces have a flow in closed form: one rule a family. What can be added is added here.
//!
//! H in terms of q, p, s gives q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

use super::flow::Flow;
use super::time::Clock;
use super::{conjugate, kinetic, prolongation, quadratic};
use crate::ir::{Graph, Id};

/// Terms that are to be one piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    pub(super) energy: Id,
    pub(super) degrees: u32,
    pub(super) clock: Clock,
}

/// A family of energies whose flow is known.
pub(crate) struct Rule {
    /// What it is called in reports.
    pub(crate) name: &'static str,
    /// The energies.
    pub(crate) family: &'static str,
    /// The flow, if an energy belongs to the family.
    pub(super) solve: fn(&mut Graph, &Group) -> Option<Flow>,
}

impl std::fmt::Debug for Rule {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// In order of preference, where an energy belongs to several.
pub(crate) static RULES: &[Rule] = &[
    Rule { name: "damped drift", family: "p·Wp/2 + g s, g constant or k/t", solve: kinetic::damped },
    Rule { name: "damped oscillator", family: "Σ (a p² + 2e q p + b q²)/2 + c s", solve: quadratic::oscillator },
    Rule { name: "drift", family: "T(p, t)", solve: kinetic::free },
    Rule { name: "prolongation", family: "p·a(q, s) + b(q, s)", solve: prolongation::solve },
    Rule { name: "uniform field", family: "p·Wp/2 + b·p + g·q", solve: quadratic::uniform_field },
    Rule { name: "weighted drift", family: "F(s) p·Wp/2", solve: kinetic::weighted },
    Rule { name: "weighted power", family: "s pᵢᵏ", solve: kinetic::power },
    Rule { name: "geodesic", family: "f(qᵢ) pᵢ²", solve: kinetic::geodesic },
    Rule {
        name: "Legendre conjugate", family: "H(p, −q, s − q·p) for H of another family", solve: conjugate::solve
    },
];
