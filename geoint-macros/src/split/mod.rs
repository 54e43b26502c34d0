//! A contact Hamiltonian as the fewest pieces whose flows are known in closed form.
//!
//! A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7; which energies split at all:
//! P. G. Kevrekidis, arXiv:2605.09103 (2026).

mod polynomial;
mod time;
mod flow;
mod scalar;
mod kinetic;
mod damped;
mod geodesic;
mod quadratic;
mod prolongation;
mod conjugate;
mod rules;
mod partition;
mod mechanics;

use crate::diff::modified;
use crate::ir::{Graph, Id};
use flow::Group;
pub(crate) use flow::{Flow, Piece, level};
pub(crate) use mechanics::{Mechanics, mechanics};
pub(crate) use partition::{Pieces, pieces};
pub(crate) use rules::RULES;
pub(crate) use time::Clock;

/// The energy that [`Pieces`] keep, or let decay, up to h⁴.
pub(crate) fn modified_energy(graph: &mut Graph, pieces: &[Piece], degrees: u32) -> Id {
    let frozen = modified::Clock(0);
    // Frozen time moves before and after all flows.
    let mut parts = vec![modified::Part { energy: graph.zero(), advances: Some(frozen) }];
    for (i, piece) in (1..).zip(pieces) {
        let (reads, advances) = match piece.clock {
            Clock::Own => (modified::Clock(i), Some(modified::Clock(i))),
            Clock::Stage => (frozen, None),
        };
        parts.push(modified::Part { energy: reads.read(graph, piece.energy), advances });
    }
    modified::modified_energy(graph, &parts, degrees)
}

/// A piece with this energy, if some rule knows its flow: exactly in time, or else at frozen time.
pub(crate) fn piece(graph: &mut Graph, energy: Id, degrees: u32) -> Option<Piece> {
    [Clock::Own, Clock::Stage].into_iter().find_map(|clock| {
        let group = Group { energy, degrees, clock };
        RULES.iter().find_map(|rule| {
            let flow = (rule.solve)(graph, &group)?;
            Some(Piece { energy, rule, flow, clock })
        })
    })
}
