//! Which pieces have a flow in closed form: one rule a family. What can be added is added here.
//!
//! H in terms of q, p, s gives q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

use super::flow::{Flow, Group, Rule};
use super::{conjugate, damped, geodesic, kinetic, prolongation, quadratic};
use crate::ir::Graph;

/// In order of preference, where an energy belongs to several.
pub(crate) static RULES: &[Rule] = &[
    Rule {
        name: "damped drift",
        family: "p·Wp/2 + g s, g constant or k/(t₀ + t)",
        source: "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
        solve: damped::drift,
    },
    Rule {
        name: "damped oscillator",
        family: "Σ (a p² + 2e q p + b q²)/2 + c s",
        source: "A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17",
        solve: quadratic::oscillator,
    },
    Rule { name: "drift", family: "T(p, t)", source: ARNOLD, solve: kinetic::free },
    Rule {
        name: "prolongation",
        family: "p·a(q, s) + b(q, s)",
        source: "P. G. Kevrekidis, arXiv:2605.09103 (2026)",
        solve: prolongation::solve,
    },
    Rule { name: "uniform field", family: "p·Wp/2 + b·p + g·q", source: ARNOLD, solve: quadratic::uniform_field },
    Rule {
        name: "weighted drift",
        family: "F(s) p·Wp/2",
        source: "A. Bravetti & D. Tapias, Phys. Rev. E 93 (2016) 022139",
        solve: kinetic::weighted,
    },
    Rule { name: "weighted power", family: "s pᵢᵏ", source: SEPARATION, solve: kinetic::power },
    Rule { name: "geodesic", family: "f(qᵢ) pᵢ²", source: SEPARATION, solve: geodesic::geodesic },
    Rule {
        name: "Legendre conjugate",
        family: "H(p, −q, s − q·p) for H of another family",
        source: ARNOLD,
        solve: conjugate,
    },
];

const ARNOLD: &str = "V. I. Arnold, Mathematical Methods of Classical Mechanics (1989), appendix 4";

const SEPARATION: &str = "separation of variables";

/// The conjugate energy under any other rule.
fn conjugate(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let (_, others) = RULES.split_last()?;
    conjugate::solve(graph, group, |graph, group| others.iter().find_map(|rule| (rule.solve)(graph, group)))
}
