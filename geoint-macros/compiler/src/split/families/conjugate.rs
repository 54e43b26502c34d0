//! Family "Legendre conjugate". The map (q, p, s) → (p, −q, s − q·p) keeps ds − p dq, so it turns flows into flows.

use super::super::flow::{Flow, Group, Rules};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// Returns the flow of an energy from the flow of its conjugate, if `rules` know it.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    let degrees = group.degrees;
    // H(−p̂, q̂, ŝ − q̂·p̂) with q̂ = p, p̂ = −q, ŝ = s − q·p.
    let energy = rotated(graph, degrees, group.energy, Number::MINUS_ONE);
    let flow = rules(graph, &Group { energy, ..*group })?;
    let back = |graph: &mut Graph, id: Id| rotated(graph, degrees, id, Number::ONE);
    let [p, q] = [&flow.q, &flow.p].map(|ends| ends.iter().map(|end| back(graph, *end)).collect::<Vec<_>>());
    let mut s = back(graph, flow.s);
    let q: Vec<Id> = q.into_iter().map(|q| graph.neg(q)).collect();
    for (q, p) in q.iter().zip(&p) {
        s = graph.build(s + *q * *p);
    }
    Some(Flow { q, p, s })
}

/// Replaces q by c·p, p by −c·q, and s by s − q·p.
fn rotated(graph: &mut Graph, degrees: u32, id: Id, c: Number) -> Id {
    let replace = |graph: &mut Graph, symbol: Symbol| match symbol {
        Symbol::Position(i) => {
            let p = graph.symbol(Symbol::Momentum(i));
            Some(graph.scale(c, p))
        }
        Symbol::Momentum(i) => {
            let q = graph.symbol(Symbol::Position(i));
            Some(graph.scale(c.neg(), q))
        }
        Symbol::Action => {
            let s = graph.symbol(Symbol::Action);
            Some((0..degrees).fold(s, |s, i| {
                let (q, p) = (graph.symbol(Symbol::Position(i)), graph.symbol(Symbol::Momentum(i)));
                let product = graph.mul(q, p);
                graph.sub(s, product)
            }))
        }
        _ => None,
    };
    Substitution::new(replace).apply(graph, id)
}
