//! A contact Hamiltonian as the fewest pieces whose flows are known in closed form.
//!
//! A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7; which energies split at all:
//! P. G. Kevrekidis, arXiv:2605.09103 (2026).

mod polynomial;
mod time;
mod flow;
mod scalar;
mod kinetic;
mod quadratic;
mod prolongation;
mod conjugate;
mod rules;
mod partition;
mod mechanics;

use crate::ir::{Graph, Id};
pub(crate) use flow::{Flow, Piece, level};
pub(crate) use mechanics::{Mechanics, is_conformal, mechanics};
pub(crate) use partition::{Pieces, pieces};
pub(crate) use rules::RULES;
use rules::Group;
pub(crate) use time::Clock;

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
