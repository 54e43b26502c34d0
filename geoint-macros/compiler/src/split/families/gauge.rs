//! Momenta that positions shift: u = p − ∇S(q) with q is canonical, so that the flow in (q, u) gives that in (q, p).
//!
//! F(p₀ − a(q₀, …), …) with an a that reads the momentum's own position is such an energy, direction by direction of a field. Y. K. Wu,
//! E. Forest & D. S. Robin, Phys. Rev. E 68 (2003) 046502.

use super::super::flow::{Flow, Group, Rules};
use super::super::increment::increments;
use super::super::polynomial::{Polynomial, is_free, is_momentum, slope_of_line, times_powers};
use super::super::time::Clock;
use crate::analyze::{self, liouville};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Number, Symbol};

/// The flow by `rules` after a change of gauge.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    let moves = |symbol: Symbol| symbol == Symbol::Action || symbol == Symbol::Time && group.clock == Clock::Own;
    if !is_free(graph, group.energy, &moves) {
        return None;
    }
    let degrees = group.degrees;
    let (mut energy, mut shift) = (group.energy, vec![graph.zero(); degrees as usize]);
    for i in 0..degrees {
        let Some((sum, rest, own)) = own_shift(graph, energy, i) else { continue };
        let logarithm = liouville::Logarithm::OfMagnitude;
        let Ok((potential, _)) = liouville::antiderivative(graph, &[Symbol::Position(i)], &[own], logarithm) else {
            continue;
        };
        let mut slopes = diff::gradient(graph, potential, degrees).q;
        slopes[i as usize] = own;
        energy = freed(graph, energy, (sum, rest), &slopes, i);
        for (shift, slope) in shift.iter_mut().zip(slopes) {
            *shift = graph.add(*shift, slope);
        }
    }
    if shift.iter().all(|shift| graph.is_zero(*shift)) {
        return None;
    }
    let energy = collected(graph, energy);
    let flow = rules(graph, &Group { energy, ..*group })?;
    let back = |graph: &mut Graph, id: Id| shifted(graph, id, &shift, Number::MINUS_ONE);
    let mut moved = |of: fn(u32) -> Symbol, ends: &[Id]| -> Vec<Id> {
        let ends: Vec<(Symbol, Id)> = (0..degrees).map(of).zip(ends.iter().copied()).collect();
        increments(graph, &ends).into_iter().map(|increment| back(graph, increment)).collect()
    };
    let (of_q, of_u) = (moved(Symbol::Position, &flow.q), moved(Symbol::Momentum, &flow.p));
    let mut changed = Flow::rest(graph, degrees);
    for (i, end) in flow.q.iter().enumerate() {
        changed.q[i] = back(graph, *end);
    }
    // Of shifts by divided differences: where they are nearly equal at both ends, little is left of their values.
    let mut along = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::PositionIncrement(i) => Some(of_q[i as usize]),
        _ => None,
    });
    for (i, (of_u, shift)) in of_u.into_iter().zip(&shift).enumerate() {
        let of_shift = diff::increment(graph, *shift);
        let of_shift = along.apply(graph, of_shift);
        changed.p[i] = graph.sum(&[changed.p[i], of_u, of_shift]);
    }
    Some(changed)
}

/// What shifts a momentum and reads its own position, −r/c where a sum is c·pᵢ + r; with that sum, and r.
fn own_shift(graph: &mut Graph, energy: Id, i: u32) -> Option<(Id, Id, Id)> {
    let (own, position) = (Symbol::Momentum(i), Symbol::Position(i));
    let momentum = graph.symbol(own);
    if is_free(graph, energy, &|symbol| symbol == own) || is_free(graph, energy, &|symbol| symbol == position) {
        return None;
    }
    for id in graph.reachable(&[energy]) {
        // The terms of the whole are parted elsewhere.
        let Node::Linear(_, terms) = graph.node(id) else { continue };
        let has_own = |term: &Id| match graph.node(*term) {
            Node::Product(factors) => factors.contains(&momentum),
            _ => *term == momentum,
        };
        if id == energy || !terms.iter().any(|(_, term)| has_own(term)) {
            continue;
        }
        let Some(slope) = slope_of_line(graph, id, own) else { continue };
        if graph.is_zero(slope) || !is_free(graph, slope, &Symbol::is_coordinate) {
            continue;
        }
        if let Some(rest) = reading(graph, id, position) {
            let shift = graph.div(rest, slope);
            return Some((id, rest, graph.neg(shift)));
        }
    }
    None
}

/// p + shift in place of p, where the sum loses its rest by that.
fn freed(graph: &mut Graph, energy: Id, (sum, rest): (Id, Id), shift: &[Id], i: u32) -> Id {
    let others: Vec<Id> = (0..).zip(shift).map(|(j, shift)| if j == i { graph.zero() } else { *shift }).collect();
    let left = graph.sub(sum, rest);
    let left = shifted(graph, left, &others, Number::ONE);
    let mut moved = by_shift(shift, Number::ONE);
    moved.insert(sum, left);
    moved.apply(graph, energy)
}

/// The terms that read a position and no momenta.
fn reading(graph: &mut Graph, sum: Id, position: Symbol) -> Option<Id> {
    let mut terms = analyze::terms(graph, sum);
    terms.retain(|term| is_free(graph, *term, &is_momentum) && !is_free(graph, *term, &|symbol| symbol == position));
    (!terms.is_empty()).then(|| graph.sum(&terms))
}

/// p + c·shift in place of p.
fn shifted(graph: &mut Graph, id: Id, shift: &[Id], c: Number) -> Id {
    by_shift(shift, c).apply(graph, id)
}

fn by_shift(shift: &[Id], c: Number) -> Substitution<impl Fn(&mut Graph, Symbol) -> Option<Id>> {
    Substitution::new(move |graph: &mut Graph, symbol| match symbol {
        Symbol::Momentum(i) => {
            let (p, shift) = (graph.symbol(symbol), graph.scale(c, shift[i as usize]));
            Some(graph.add(p, shift))
        }
        _ => None,
    })
}

/// A polynomial by its terms, without those that are zero; anything else as it is.
fn collected(graph: &mut Graph, energy: Id) -> Id {
    let Some(powers) = Polynomial::of(graph, energy, &Symbol::is_coordinate) else { return energy };
    let mut terms = vec![];
    for (monomial, coefficient) in powers.into_terms() {
        if !analyze::identity(graph, coefficient).is_zero() {
            terms.push(times_powers(graph, coefficient, &monomial));
        }
    }
    graph.sum(&terms)
}
