//! Family "monomial": products of powers of positions and momenta. Each product is constant along its own flow.
//!
//! P. J. Channell & F. R. Neri, Fields Inst. Commun. 10 (1996) 45.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Monomial, Polynomial, is_whole, power, times_powers};
use super::super::scalar::positive_power;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// The factors by which a flow multiplies a position and its momentum.
pub(super) struct Growth {
    pub(super) q: Id,
    pub(super) p: Id,
}

/// Returns the factors for K = c qᵐpⁿ with w = hK/(qp) and D = 1 + (n − m) w: D^(n/(n−m)) and D^(−m/(n−m)). They are e^(mw) and e^(−mw) for
/// n = m.
pub(super) fn growth(graph: &mut Graph, w: Id, m: Ratio, n: Ratio) -> Option<Growth> {
    let difference = n.add(m.neg())?;
    if difference.numerator == 0 {
        let z = graph.scale(Number::Exact(m), w);
        let back = graph.neg(z);
        let [q, p] = [z, back].map(|z| graph.call(Function::Exp, &[z]));
        return Some(Growth { q, p });
    }
    let (one, rise) = (graph.integer(1), graph.scale(Number::Exact(difference), w));
    let d = graph.add(one, rise);
    let inverse = difference.recip()?;
    let q = positive_power(graph, d, inverse.mul(n)?);
    Some(Growth { q, p: positive_power(graph, d, inverse.mul(m)?.neg()) })
}

/// Returns the flow of c Π qᵢᵐ pᵢⁿ with positive integer exponents.
pub(super) fn monomial(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &Symbol::is_coordinate)?;
    let (exponents, c) = powers.single()?;
    if !is_whole(exponents) || exponents.contains_key(&Symbol::Action) {
        return None;
    }
    let weight = group.clock.over_step(graph, c)?;
    // h times the monomial divided by the given symbols.
    let divided_by = |graph: &mut Graph, symbols: &[Symbol]| {
        let mut rest: Monomial = exponents.clone();
        for symbol in symbols {
            rest.insert(*symbol, power(&rest, *symbol).add(Ratio::integer(-1)).unwrap_or(Ratio::ZERO));
        }
        rest.retain(|_, r| r.numerator != 0);
        times_powers(graph, weight, &rest)
    };
    let mut flow = Flow::rest(graph, group.degrees);
    for i in 0..group.degrees {
        let (q, p) = (Symbol::Position(i), Symbol::Momentum(i));
        let [m, n] = [q, p].map(|symbol| power(exponents, symbol));
        let i = i as usize;
        match (m.numerator, n.numerator) {
            (0, 0) => {}
            (0, _) => {
                let moved = divided_by(graph, &[p]);
                let moved = graph.scale(Number::Exact(n), moved);
                flow.q[i] = graph.add(flow.q[i], moved);
            }
            (_, 0) => {
                let impulse = divided_by(graph, &[q]);
                let impulse = graph.scale(Number::Exact(m), impulse);
                flow.p[i] = graph.sub(flow.p[i], impulse);
            }
            _ => {
                let w = divided_by(graph, &[q, p]);
                let growth = growth(graph, w, m, n)?;
                flow.q[i] = graph.mul(flow.q[i], growth.q);
                flow.p[i] = graph.mul(flow.p[i], growth.p);
            }
        }
    }
    Some(flow)
}
