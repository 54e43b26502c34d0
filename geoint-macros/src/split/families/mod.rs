//! Which pieces have a flow in closed form: one entry a family. What can be added is added here.
//!
//! H in terms of q, p, s gives q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

pub(super) mod kinetic;
pub(super) mod damped;
mod geodesic;
mod quadratic;
pub(super) mod prolongation;
mod conjugate;
mod block;
mod central;
mod forms;
mod function;
mod gauge;
mod monomial;
mod independent;

use super::flow::{Family, Flow, Group, Piece, Solve, Space};
use super::polynomial::is_free;
use super::time::Clock;
use crate::ir::{Graph, Id, Symbol};

/// In order of preference, where an energy belongs to several.
pub(crate) static FAMILIES: &[Family] = &[
    Family { name: "kick", energies: "V(q, t)", source: ARNOLD, action: false, solve: forms::kick },
    Family {
        name: "damped drift",
        energies: "p·Wp/2 + g s, g constant or k/(t₀ + t)",
        source: "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
        action: true,
        solve: damped::drift,
    },
    Family {
        name: "oscillators",
        energies: "Σ (a p² + 2e q p + b q²)/2, damped by c s",
        source: "A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17",
        action: true,
        solve: quadratic::oscillator,
    },
    Family { name: "drift", energies: "T(p, t)", source: ARNOLD, action: true, solve: kinetic::free },
    Family {
        name: "prolongation",
        energies: "p·a(q, s) + b(q, s)",
        source: "P. G. Kevrekidis, arXiv:2605.09103 (2026)",
        action: true,
        solve: prolongation::solve,
    },
    Family {
        name: "uniform field",
        energies: "p·Wp/2 + b·p + g·q",
        source: ARNOLD,
        action: true,
        solve: quadratic::uniform_field,
    },
    Family {
        name: "weighted drift",
        energies: "F(s) p·Wp/2",
        source: "A. Bravetti & D. Tapias, Phys. Rev. E 93 (2016) 022139",
        action: true,
        solve: kinetic::weighted,
    },
    Family { name: "weighted power", energies: "s pᵢᵏ", source: SEPARATION, action: true, solve: kinetic::power },
    Family {
        name: "geodesic", energies: "f(qᵢ) pᵢ²", source: SEPARATION, action: true, solve: geodesic::geodesic
    },
    Family {
        name: "Legendre conjugate",
        energies: "H(p, −q, s − q·p) for H of another family",
        source: ARNOLD,
        action: true,
        solve: conjugate,
    },
    Family {
        name: "coupled oscillators",
        energies: "x·Sx/2 + g·x, 32 degrees of freedom coupled at most",
        source: ARNOLD,
        action: false,
        solve: block::block,
    },
    Family {
        name: "inverse square",
        energies: "p·Wp/2 + Σ k/r² + b r²/2, r the length of Aq + c, which is accelerated along itself",
        source: "F. Calogero, J. Math. Phys. 10 (1969) 2191",
        action: false,
        solve: central::inverse_square,
    },
    Family {
        name: "Kepler motion",
        energies: "p·Wp/2 − Σ k/r, r the length of Aq + c, which is accelerated along itself",
        source: "H. Rein & D. Tamayo, Mon. Not. R. Astron. Soc. 452 (2015) 376",
        action: false,
        solve: central::kepler,
    },
    Family {
        name: "forms in involution",
        energies: "F(ℓ₁, …, ℓₖ), ℓ = a·q + b·p with {ℓᵢ, ℓⱼ} = 0",
        source: "Y. K. Wu, E. Forest & D. S. Robin, Phys. Rev. E 68 (2003) 046502",
        action: false,
        solve: forms::straight,
    },
    Family {
        name: "monomial",
        energies: "c Π qᵢᵐ pᵢⁿ",
        source: "P. J. Channell & F. R. Neri, Fields Inst. Commun. 10 (1996) 45",
        action: false,
        solve: monomial::monomial,
    },
    Family {
        name: "function of a piece",
        energies: "F(A) for A of another family",
        source: ARNOLD,
        action: false,
        solve: function,
    },
    Family {
        name: "change of gauge",
        energies: "H(q, p − ∇S(q)) for H of another family",
        source: "Y. K. Wu, E. Forest & D. S. Robin, Phys. Rev. E 68 (2003) 046502",
        action: false,
        solve: gauge,
    },
    Family {
        name: "independent parts",
        energies: "Σ Aᵢ of other families, without a coordinate in common",
        source: SEPARATION,
        action: false,
        solve: independent,
    },
];

const ARNOLD: &str = "V. I. Arnold, Mathematical Methods of Classical Mechanics (1989), appendix 4";

const SEPARATION: &str = "separation of variables";

/// The conjugate energy under any other rule.
fn conjugate(graph: &mut Graph, group: &Group) -> Option<Flow> {
    conjugate::solve(graph, group, |graph, group| others(graph, group, conjugate))
}

/// A function of an energy that any other rule knows.
fn function(graph: &mut Graph, group: &Group) -> Option<Flow> {
    function::solve(graph, group, |graph, group| others(graph, group, function))
}

/// An energy that another rule knows in another gauge.
fn gauge(graph: &mut Graph, group: &Group) -> Option<Flow> {
    // None of those that ask all others again.
    gauge::solve(graph, group, |graph, group| {
        let derived = [conjugate as Solve, function, gauge];
        let plain = |family: &&Family| !derived.iter().any(|solve| std::ptr::fn_addr_eq(family.solve, *solve));
        FAMILIES.iter().filter(plain).find_map(|family| (family.solve)(graph, group))
    })
}

/// Energies of other rules, side by side.
fn independent(graph: &mut Graph, group: &Group) -> Option<Flow> {
    independent::solve(graph, group, |graph, group| others(graph, group, independent))
}

/// The flow by one of the rules before `of`.
fn others(graph: &mut Graph, group: &Group, of: Solve) -> Option<Flow> {
    FAMILIES
        .iter()
        .take_while(|family| !std::ptr::fn_addr_eq(family.solve, of))
        .find_map(|family| (family.solve)(graph, group))
}

/// The families in the order in which they are tried, of contact systems if there is an `action`.
pub(crate) fn tried(action: bool) -> impl Iterator<Item = &'static Family> {
    FAMILIES.iter().filter(move |family| family.action || !action)
}

/// A piece with this energy, if some rule knows its flow: exactly in time, or else at frozen time.
pub(crate) fn piece(graph: &mut Graph, energy: Id, space: Space) -> Option<Piece> {
    // What does not read time is not frozen.
    let steady = is_free(graph, energy, &|symbol| symbol == Symbol::T);
    let clocks = if steady { &[Clock::Own][..] } else { &[Clock::Own, Clock::Stage] };
    clocks.iter().find_map(|clock| {
        let group = Group { energy, degrees: space.degrees, clock: *clock };
        tried(space.action).find_map(|family| {
            let mut flow = (family.solve)(graph, &group)?;
            if !space.action {
                flow.s = graph.symbol(Symbol::S);
            }
            Some(Piece { energy, family, flow, clock: *clock })
        })
    })
}
