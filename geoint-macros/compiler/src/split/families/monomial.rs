//! Products of powers of positions and momenta: each of them is constant along its own flow. P. J. Channell & F. R. Neri, Fields Inst. Commun.
//! 10 (1996) 45.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Monomial, Polynomial, power, times_powers};
use super::super::scalar::positive_power;
use crate::ir::{Function, Graph, Number, Ratio, Symbol};

/// K = c Π qᵢᵐ pᵢⁿ: with w = hK/(qᵢpᵢ) and D = 1 + (n − m) w, qᵢ D^(n/(n−m)) and pᵢ D^(−m/(n−m)); qᵢ e^(mw) and pᵢ e^(−mw) for n = m.
pub(in super::super) fn monomial(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &Symbol::is_coordinate)?;
    let (exponents, c) = powers.single()?;
    let exponents = exponents.clone();
    let whole = exponents.iter().all(|(symbol, r)| *symbol != Symbol::Action && r.is_integer() && r.numerator > 0);
    if !whole {
        return None;
    }
    let weight = group.clock.over_step(graph, c)?;
    let mut flow = Flow::rest(graph, group.degrees);
    for i in 0..group.degrees {
        let (q, p) = (Symbol::Position(i), Symbol::Momentum(i));
        let [m, n] = [q, p].map(|symbol| power(&exponents, symbol));
        let reduced = |graph: &mut Graph, without: &[Symbol]| {
            let mut rest: Monomial = exponents.clone();
            for symbol in without {
                let left = power(&rest, *symbol).add(Ratio::integer(-1)).unwrap_or(Ratio::ZERO);
                rest.insert(*symbol, left);
            }
            rest.retain(|_, r| r.numerator != 0);
            times_powers(graph, weight, &rest)
        };
        let i = i as usize;
        match (m.numerator, n.numerator) {
            (0, 0) => {}
            (0, _) => {
                let moved = reduced(graph, &[p]);
                let moved = graph.scale(Number::Exact(n), moved);
                flow.q[i] = graph.add(flow.q[i], moved);
            }
            (_, 0) => {
                let impulse = reduced(graph, &[q]);
                let impulse = graph.scale(Number::Exact(m), impulse);
                flow.p[i] = graph.sub(flow.p[i], impulse);
            }
            (a, b) if a == b => {
                let w = reduced(graph, &[q, p]);
                let z = graph.scale(Number::Exact(m), w);
                let back = graph.neg(z);
                let [grown, shrunk] = [z, back].map(|z| graph.call(Function::Exp, &[z]));
                flow.q[i] = graph.mul(flow.q[i], grown);
                flow.p[i] = graph.mul(flow.p[i], shrunk);
            }
            _ => {
                let difference = n.add(m.neg())?;
                let (w, one) = (reduced(graph, &[q, p]), graph.integer(1));
                let rise = graph.scale(Number::Exact(difference), w);
                let d = graph.add(one, rise);
                let inverse = difference.recip()?;
                let grown = positive_power(graph, d, n.mul(inverse)?);
                let shrunk = positive_power(graph, d, m.mul(inverse)?.neg());
                flow.q[i] = graph.mul(flow.q[i], grown);
                flow.p[i] = graph.mul(flow.p[i], shrunk);
            }
        }
    }
    Some(flow)
}
