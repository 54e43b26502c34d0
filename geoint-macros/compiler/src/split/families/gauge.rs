//! Family "change of gauge": H(q, p − ∇S(q)). The map from p to u = p − ∇S(q) is canonical, so the flow in (q, u) gives the flow in (q, p).
//!
//! An example is F(p₀ − a(q₀, …), …) with an a that reads q₀. The gauge is changed for one direction of the field after the other.
//! Y. K. Wu, E. Forest & D. S. Robin, Phys. Rev. E 68 (2003) 046502.

use super::super::flow::{Flow, Group, Rules};
use super::super::increment::increments;
use super::super::polynomial::{Polynomial, is_free, is_momentum, reads, slope_of_line, times_powers};
use crate::analyze::{self, liouville};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Number, Symbol};

/// Returns the flow by `rules` after a change of gauge.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    if reads(graph, group.energy, Symbol::Action) || !group.clock.is_steady(graph, group.energy) {
        return None;
    }
    let degrees = group.degrees;
    // ∇S.
    let mut shift = vec![graph.zero(); degrees as usize];
    let mut energy = group.energy;
    for i in 0..degrees {
        let Some(own) = OwnShift::of(graph, energy, i) else { continue };
        let logarithm = liouville::Logarithm::OfMagnitude;
        let Ok((potential, _)) = liouville::antiderivative(graph, &[Symbol::Position(i)], &[own.shift], logarithm)
        else {
            continue;
        };
        let mut slopes = diff::gradient(graph, potential, degrees).q;
        slopes[i as usize] = own.shift;
        energy = own.removed(graph, energy, &slopes, i);
        for (shift, slope) in shift.iter_mut().zip(slopes) {
            *shift = graph.add(*shift, slope);
        }
    }
    if shift.iter().all(|shift| graph.is_zero(*shift)) {
        return None;
    }
    let energy = collected(graph, energy);
    let flow = rules(graph, &Group { energy, ..*group })?;
    let back = |graph: &mut Graph, id: Id| shifted_momenta(&shift, Number::MINUS_ONE).apply(graph, id);
    let mut moved = |of: fn(u32) -> Symbol, ends: &[Id]| -> Vec<Id> {
        let ends: Vec<(Symbol, Id)> = (0..degrees).map(of).zip(ends.iter().copied()).collect();
        increments(graph, &ends).into_iter().map(|increment| back(graph, increment)).collect()
    };
    let (of_q, of_u) = (moved(Symbol::Position, &flow.q), moved(Symbol::Momentum, &flow.p));
    let mut changed = Flow::rest(graph, degrees);
    for (i, end) in flow.q.iter().enumerate() {
        changed.q[i] = back(graph, *end);
    }
    // Divided differences give the change of ∇S, because the difference of its values at both ends would cancel.
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

/// A sum c·pᵢ + r + … in the energy, where r reads qᵢ and no momenta.
struct OwnShift {
    sum: Id,
    /// r.
    rest: Id,
    /// −r/c, the shift of pᵢ.
    shift: Id,
}

impl OwnShift {
    /// Returns the first such sum for the momentum with index i.
    fn of(graph: &mut Graph, energy: Id, i: u32) -> Option<OwnShift> {
        let (own, position) = (Symbol::Momentum(i), Symbol::Position(i));
        let momentum = graph.symbol(own);
        if !reads(graph, energy, own) || !reads(graph, energy, position) {
            return None;
        }
        for sum in graph.reachable(&[energy]) {
            let Node::Linear(_, terms) = graph.node(sum) else { continue };
            let has_own = |term: &Id| match graph.node(*term) {
                Node::Product(factors) => factors.contains(&momentum),
                _ => *term == momentum,
            };
            // The terms of the energy itself are split by the search for pieces.
            if sum == energy || !terms.iter().any(|(_, term)| has_own(term)) {
                continue;
            }
            let Some(slope) = slope_of_line(graph, sum, own) else { continue };
            if graph.is_zero(slope) || !is_free(graph, slope, &Symbol::is_coordinate) {
                continue;
            }
            let mut terms = analyze::terms(graph, sum);
            terms.retain(|term| is_free(graph, *term, &is_momentum) && reads(graph, *term, position));
            if !terms.is_empty() {
                let rest = graph.sum(&terms);
                let shift = graph.div(rest, slope);
                return Some(OwnShift { sum, rest, shift: graph.neg(shift) });
            }
        }
        None
    }

    /// Replaces p by p + slopes. The sum loses its rest, so it needs no simplification.
    fn removed(&self, graph: &mut Graph, energy: Id, slopes: &[Id], i: u32) -> Id {
        let mut others = slopes.to_vec();
        others[i as usize] = graph.zero();
        let left = graph.sub(self.sum, self.rest);
        let left = shifted_momenta(&others, Number::ONE).apply(graph, left);
        let mut moved = shifted_momenta(slopes, Number::ONE);
        moved.insert(self.sum, left);
        moved.apply(graph, energy)
    }
}

/// Returns the substitution of p by p + c·shift.
fn shifted_momenta(shift: &[Id], c: Number) -> Substitution<impl Fn(&mut Graph, Symbol) -> Option<Id>> {
    Substitution::new(move |graph: &mut Graph, symbol| match symbol {
        Symbol::Momentum(i) => {
            let (p, shift) = (graph.symbol(symbol), graph.scale(c, shift[i as usize]));
            Some(graph.add(p, shift))
        }
        _ => None,
    })
}

/// Expands a polynomial and drops the terms that are proven to be zero. Returns other energies unchanged.
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
