//! The families of energies with a flow in closed form. A new family needs an entry in `FAMILIES`.
//!
//! The equations of motion of H(q, p, s, t) are q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

pub(super) mod kinetic;
pub(super) mod damped;
mod monomial;
mod geodesic;
mod quadratic;
pub(super) mod prolongation;
mod conjugate;
mod block;
mod central;
mod forms;
mod function;
mod gauge;
mod independent;

use super::flow::Solve::{ByGauge, Direct, InParts, Transformed};
use super::flow::{Family, Flow, Group, Piece, Space};
use super::time::Clock;
use crate::ir::{Graph, Id, Symbol};

/// The families in order of preference. An energy that belongs to several families takes the first one.
pub(crate) static FAMILIES: &[Family] = &[
    Family { name: "kick", energies: "V(q, t)", source: ARNOLD, action: false, solve: Direct(forms::kick) },
    Family {
        name: "damped drift",
        energies: "p·Wp/2 + g s, g constant or k/(t₀ + t)",
        source: "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
        action: true,
        solve: Direct(damped::drift),
    },
    Family {
        name: "oscillators",
        energies: "Σ (a p² + 2e q p + b q²)/2, damped by c s",
        source: "A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17",
        action: true,
        solve: Direct(quadratic::oscillator),
    },
    Family { name: "drift", energies: "T(p, t)", source: ARNOLD, action: true, solve: Direct(kinetic::free) },
    Family {
        name: "prolongation",
        energies: "p·a(q, s) + b(q, s)",
        source: "P. G. Kevrekidis, arXiv:2605.09103 (2026)",
        action: true,
        solve: Direct(prolongation::solve),
    },
    Family {
        name: "uniform field",
        energies: "p·Wp/2 + b·p + g·q",
        source: ARNOLD,
        action: true,
        solve: Direct(quadratic::uniform_field),
    },
    Family {
        name: "weighted drift",
        energies: "F(s) p·Wp/2",
        source: "A. Bravetti & D. Tapias, Phys. Rev. E 93 (2016) 022139",
        action: true,
        solve: Direct(kinetic::weighted),
    },
    Family {
        name: "weighted power",
        energies: "s pᵢᵏ",
        source: SEPARATION,
        action: true,
        solve: Direct(kinetic::power),
    },
    Family {
        name: "geodesic",
        energies: "f(qᵢ) pᵢ²",
        source: SEPARATION,
        action: true,
        solve: Direct(geodesic::geodesic),
    },
    Family {
        name: "Legendre conjugate",
        energies: "H(p, −q, s − q·p) for H of another family",
        source: ARNOLD,
        action: true,
        solve: Transformed(conjugate::solve),
    },
    Family {
        name: "coupled oscillators",
        energies: "x·Sx/2 + g·x, 32 degrees of freedom coupled at most",
        source: ARNOLD,
        action: false,
        solve: Direct(block::block),
    },
    Family {
        name: "inverse square",
        energies: "p·Wp/2 + Σ k/r² + b r²/2, r the length of Aq + c, which is accelerated along itself",
        source: "F. Calogero, J. Math. Phys. 10 (1969) 2191",
        action: false,
        solve: Direct(central::inverse_square),
    },
    Family {
        name: "Kepler motion",
        energies: "p·Wp/2 − Σ k/r, r the length of Aq + c, which is accelerated along itself",
        source: "H. Rein & D. Tamayo, Mon. Not. R. Astron. Soc. 452 (2015) 376",
        action: false,
        solve: Direct(central::kepler),
    },
    Family {
        name: "forms in involution",
        energies: "F(ℓ₁, …, ℓₖ), ℓ = a·q + b·p with {ℓᵢ, ℓⱼ} = 0",
        source: "Y. K. Wu, E. Forest & D. S. Robin, Phys. Rev. E 68 (2003) 046502",
        action: false,
        solve: Direct(forms::in_involution),
    },
    Family {
        name: "monomial",
        energies: "c Π qᵢᵐ pᵢⁿ",
        source: "P. J. Channell & F. R. Neri, Fields Inst. Commun. 10 (1996) 45",
        action: false,
        solve: Direct(monomial::monomial),
    },
    Family {
        name: "function of a piece",
        energies: "F(A) for A of another family",
        source: ARNOLD,
        action: false,
        solve: Transformed(function::solve),
    },
    Family {
        name: "change of gauge",
        energies: "H(q, p − ∇S(q)) for H of another family",
        source: "Y. K. Wu, E. Forest & D. S. Robin, Phys. Rev. E 68 (2003) 046502",
        action: false,
        solve: ByGauge(gauge::solve),
    },
    Family {
        name: "independent parts",
        energies: "Σ Aᵢ of other families, without a coordinate in common",
        source: SEPARATION,
        action: false,
        solve: InParts(independent::solve),
    },
];

const ARNOLD: &str = "V. I. Arnold, Mathematical Methods of Classical Mechanics (1989), appendix 4";

const SEPARATION: &str = "separation of variables";

/// Returns the flow of a group by the family at `index` of the list.
///
/// The recursion ends. `Transformed` and `InParts` ask only families with a smaller index. `ByGauge` asks only `Direct` and `InParts`, so a second
/// change of gauge needs an energy that `InParts` has split into parts with fewer degrees of freedom.
fn flow(graph: &mut Graph, group: &Group, index: usize) -> Option<Flow> {
    match FAMILIES[index].solve {
        Direct(solve) => solve(graph, group),
        Transformed(solve) | InParts(solve) => {
            solve(graph, group, &|graph, group| (0..index).find_map(|earlier| flow(graph, group, earlier)))
        }
        ByGauge(solve) => {
            let asked = |index: &usize| matches!(FAMILIES[*index].solve, Direct(_) | InParts(_));
            solve(graph, group, &|graph, group| {
                (0..FAMILIES.len()).filter(asked).find_map(|other| flow(graph, group, other))
            })
        }
    }
}

/// Returns the families with their indices, in the order of the list. With an `action`, families without a flow of s are omitted.
pub(crate) fn tried(action: bool) -> impl Iterator<Item = (usize, &'static Family)> {
    FAMILIES.iter().enumerate().filter(move |(_, family)| family.action || !action)
}

/// Returns a piece with this energy, if a family knows its flow. A flow that is exact in time is preferred to a flow at frozen time.
pub(crate) fn piece(graph: &mut Graph, energy: Id, space: Space) -> Option<Piece> {
    let clocks = if graph.reads(energy).t { &[Clock::Own, Clock::Stage][..] } else { &[Clock::Own] };
    clocks.iter().find_map(|clock| {
        let group = Group { energy, degrees: space.degrees, clock: *clock };
        tried(space.action).find_map(|(index, family)| {
            let mut flow = flow(graph, &group, index)?;
            if !space.action {
                flow.s = graph.symbol(Symbol::Action);
            }
            Some(Piece { energy, family, flow, clock: *clock })
        })
    })
}
