//! Which pieces have a flow in closed form: one entry a family. What can be added is added here.
//!
//! H in terms of q, p, s gives q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

pub(super) mod kinetic;
pub(super) mod damped;
mod geodesic;
mod quadratic;
pub(super) mod prolongation;
mod conjugate;

use super::flow::{Family, Flow, Group, Piece};
use super::time::Clock;
use crate::ir::{Graph, Id};

/// In order of preference, where an energy belongs to several.
pub(crate) static FAMILIES: &[Family] = &[
    Family {
        name: "damped drift",
        energies: "p·Wp/2 + g s, g constant or k/(t₀ + t)",
        source: "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
        solve: damped::drift,
    },
    Family {
        name: "damped oscillator",
        energies: "Σ (a p² + 2e q p + b q²)/2 + c s",
        source: "A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17",
        solve: quadratic::oscillator,
    },
    Family { name: "drift", energies: "T(p, t)", source: ARNOLD, solve: kinetic::free },
    Family {
        name: "prolongation",
        energies: "p·a(q, s) + b(q, s)",
        source: "P. G. Kevrekidis, arXiv:2605.09103 (2026)",
        solve: prolongation::solve,
    },
    Family {
        name: "uniform field", energies: "p·Wp/2 + b·p + g·q", source: ARNOLD, solve: quadratic::uniform_field
    },
    Family {
        name: "weighted drift",
        energies: "F(s) p·Wp/2",
        source: "A. Bravetti & D. Tapias, Phys. Rev. E 93 (2016) 022139",
        solve: kinetic::weighted,
    },
    Family { name: "weighted power", energies: "s pᵢᵏ", source: SEPARATION, solve: kinetic::power },
    Family { name: "geodesic", energies: "f(qᵢ) pᵢ²", source: SEPARATION, solve: geodesic::geodesic },
    Family {
        name: "Legendre conjugate",
        energies: "H(p, −q, s − q·p) for H of another family",
        source: ARNOLD,
        solve: conjugate,
    },
];

const ARNOLD: &str = "V. I. Arnold, Mathematical Methods of Classical Mechanics (1989), appendix 4";

const SEPARATION: &str = "separation of variables";

/// The conjugate energy under any other rule.
fn conjugate(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let (_, others) = FAMILIES.split_last()?;
    conjugate::solve(graph, group, |graph, group| others.iter().find_map(|family| (family.solve)(graph, group)))
}

/// A piece with this energy, if some rule knows its flow: exactly in time, or else at frozen time.
pub(crate) fn piece(graph: &mut Graph, energy: Id, degrees: u32) -> Option<Piece> {
    [Clock::Own, Clock::Stage].into_iter().find_map(|clock| {
        let group = Group { energy, degrees, clock };
        FAMILIES.iter().find_map(|family| {
            let flow = (family.solve)(graph, &group)?;
            Some(Piece { energy, family, flow, clock })
        })
    })
}
