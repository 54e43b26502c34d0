//! (q, p, s) → (p, −q, s − q·p) keeps ds − p dq: with a flow there is the flow of the conjugate energy.

use super::super::flow::{Flow, Group, Rules};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

/// The flow of an energy from that of its conjugate, if `rules` know it.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    let degrees = group.degrees;
    // H(−p̂, q̂, ŝ − q̂·p̂) with q̂ = p, p̂ = −q, ŝ = s − q·p.
    let energy = replaced(graph, degrees, group.energy, |graph, q, p| (graph.neg(p), q));
    let conjugate = Group { energy, ..*group };
    let flow = rules(graph, &conjugate)?;
    let back = |graph: &mut Graph, id: Id| replaced(graph, degrees, id, |graph, q, p| (p, graph.neg(q)));
    let [q_hat, p_hat] = [&flow.q, &flow.p].map(|all| all.iter().map(|id| back(graph, *id)).collect::<Vec<_>>());
    let mut s = back(graph, flow.s);
    let q: Vec<Id> = p_hat.into_iter().map(|p| graph.neg(p)).collect();
    for (q, p) in q.iter().zip(&q_hat) {
        let product = graph.mul(*q, *p);
        s = graph.add(s, product);
    }
    Some(Flow { q, p: q_hat, s })
}

/// q and p replaced as `by` says, s by s − q·p.
fn replaced(graph: &mut Graph, degrees: u32, id: Id, by: impl Fn(&mut Graph, Id, Id) -> (Id, Id)) -> Id {
    let replace = |graph: &mut Graph, symbol: Symbol| {
        let [q, p] = [Symbol::Position as fn(u32) -> Symbol, Symbol::Momentum];
        match symbol {
            Symbol::Position(i) | Symbol::Momentum(i) => {
                let (old_q, old_p) = (graph.symbol(q(i)), graph.symbol(p(i)));
                let (new_q, new_p) = by(graph, old_q, old_p);
                Some(if symbol == q(i) { new_q } else { new_p })
            }
            Symbol::Action => {
                let mut s = graph.symbol(Symbol::Action);
                for i in 0..degrees {
                    let (q, p) = (graph.symbol(q(i)), graph.symbol(p(i)));
                    let product = graph.mul(q, p);
                    s = graph.sub(s, product);
                }
                Some(s)
            }
            _ => None,
        }
    };
    Substitution::new(replace).apply(graph, id)
}
