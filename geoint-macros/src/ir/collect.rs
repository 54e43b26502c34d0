//! Terms that differ in parameters alone are collected: m₀·c·x + m₁·c·x becomes (m₀ + m₁)·c·x, of which the sum is known before the loop.
//!
//! Derivatives along a recursion over links are such sums, as long as the chain. The graph keeps sums as they are written, so this is done
//! to the results of a kernel that asks for it.

use super::{Graph, Id, Node, Number, Ratio, Table};

/// The same nodes with such terms collected, in every sum that they are made of.
pub(crate) fn collected(graph: &mut Graph, roots: &[Id]) -> Vec<Id> {
    let mut new: Table<Id> = Table::default();
    for id in graph.reachable(roots) {
        let rebuilt = match graph.node(id).clone() {
            Node::Linear(constant, terms) => {
                let terms = terms.into_iter().map(|(c, term)| (c, new[term])).collect();
                sum(graph, constant, terms)
            }
            Node::Product(factors) => {
                let factors: Vec<Id> = factors.iter().map(|factor| new[*factor]).collect();
                graph.product(&factors)
            }
            Node::Power(base, exponent) => graph.pow(new[base], exponent),
            Node::Call(function, args) => {
                let args: Vec<Id> = args.iter().map(|arg| new[*arg]).collect();
                graph.call(function, &args)
            }
            Node::Select(condition, first, second) => graph.select(new[condition], new[first], new[second]),
            // Conditions decide as they are written.
            Node::Number(_) | Node::Symbol(_) | Node::Truth(_) => id,
            Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) => id,
        };
        new.insert(id, rebuilt);
    }
    roots.iter().map(|root| new[*root]).collect()
}

/// A sum with its terms collected: alone a term stays as it is.
fn sum(graph: &mut Graph, constant: Number, terms: Vec<(Number, Id)>) -> Id {
    let mut groups: Vec<Group> = vec![];
    for (c, term) in terms {
        let (own, rest) = graph.coefficient(term);
        let (mut moving, mut weights) = (vec![], vec![]);
        for (base, exponent) in graph.factors(rest) {
            if graph.reads(base).moves() {
                moving.push((base, exponent));
            } else {
                weights.push(graph.pow(base, exponent));
            }
        }
        moving.sort_unstable_by_key(|(base, _)| *base);
        let whole = graph.scale(c, term);
        let weight = graph.product(&weights);
        let weight = graph.scale(c.mul(own), weight);
        match groups.iter_mut().find(|group| group.moving == moving) {
            Some(group) => group.terms.push((whole, weight)),
            None => groups.push(Group { moving, terms: vec![(whole, weight)] }),
        }
    }
    let mut all = vec![graph.number(constant)];
    for Group { moving, terms } in groups {
        if let [(whole, _)] = terms[..] {
            all.push(whole);
            continue;
        }
        let weights: Vec<Id> = terms.into_iter().map(|(_, weight)| weight).collect();
        let weight = graph.sum(&weights);
        let factors: Vec<Id> = moving.into_iter().map(|(base, exponent)| graph.pow(base, exponent)).collect();
        let product = graph.product(&factors);
        all.push(graph.mul(weight, product));
    }
    graph.sum(&all)
}

/// Terms with the same factors that read more than parameters.
struct Group {
    moving: Vec<(Id, Ratio)>,
    /// Each as a whole, and what it has beside these factors.
    terms: Vec<(Id, Id)>,
}
