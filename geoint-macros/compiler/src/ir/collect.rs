//! Collects terms that differ in parameters only: m₀·c·x + m₁·c·x becomes (m₀ + m₁)·c·x. The sum of parameters is then computed before the loop.
//!
//! Derivatives along a recursion over links are sums of this kind, with as many terms as the chain has links. The graph keeps sums as they are
//! written, so kernels ask for this step.

use super::{Graph, Id, Node, Number, Ratio, Table};

/// Collects terms in every sum below the roots.
pub(crate) fn collected(graph: &mut Graph, roots: &[Id]) -> Vec<Id> {
    collected_with(graph, roots, &[])
}

/// Collects terms in every sum below the roots and replaces nodes, pairs of (node, replacement), in the same pass.
pub(crate) fn collected_with(graph: &mut Graph, roots: &[Id], replaced: &[(Id, Id)]) -> Vec<Id> {
    let values: Vec<Id> = replaced.iter().map(|(_, value)| *value).collect();
    let mut of_values: Table<Id> = Table::default();
    collect(graph, &values, &mut of_values);
    let mut new: Table<Id> = Table::default();
    for (id, value) in replaced {
        new.insert(*id, of_values[*value]);
    }
    collect(graph, roots, &mut new);
    roots.iter().map(|root| new[*root]).collect()
}

/// Rebuilds the nodes below the roots with collected terms. `new` maps nodes to their replacements.
fn collect(graph: &mut Graph, roots: &[Id], new: &mut Table<Id>) {
    for id in graph.unknown_of(roots, new) {
        let mut same = true;
        graph.node(id).for_each_child(|child| same &= new[child] == child);
        let rebuilt = match graph.node(id) {
            // Conditions stay as they were written, so that they decide alike.
            Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) => id,
            Node::Linear(constant, terms) => {
                let constant = *constant;
                let rebuilt: Vec<(Number, Id)> = terms.iter().map(|(c, term)| (*c, new[*term])).collect();
                match groups(graph, &rebuilt) {
                    Some(groups) => sum(graph, constant, rebuilt, groups),
                    None if same => id,
                    None => graph.scaled_sum(constant, &rebuilt),
                }
            }
            // A merged product may have more than two factors. It is rebuilt as nested products of two, which share parts with other products.
            Node::Product(factors) if !same || factors.len() > 2 => {
                let factors: Vec<Id> = factors.iter().map(|factor| new[*factor]).collect();
                graph.product(&factors)
            }
            _ if same => id,
            node => match node.clone() {
                Node::Power(base, exponent) => graph.pow(new[base], exponent),
                Node::Call(function, args) => {
                    let args: Vec<Id> = args.iter().map(|arg| new[*arg]).collect();
                    graph.call(function, &args)
                }
                Node::Select(condition, first, second) => graph.select(new[condition], new[first], new[second]),
                _ => id,
            },
        };
        new.insert(id, rebuilt);
    }
}

/// Terms with equal moving factors, the factors that read more than parameters.
struct Group {
    moving: Vec<(Id, Ratio)>,
    /// The places of the terms in the sum.
    terms: Vec<usize>,
}

/// Groups terms by their moving factors. `None` if each term is alone in its group.
fn groups(graph: &Graph, terms: &[(Number, Id)]) -> Option<Vec<Group>> {
    let mut groups: Vec<Group> = vec![];
    for (place, (_, term)) in terms.iter().enumerate() {
        let mut moving = graph.factors(graph.coefficient(*term).1);
        moving.retain(|(base, _)| graph.reads(*base).moves());
        moving.sort_unstable_by_key(|(base, _)| *base);
        match groups.iter_mut().find(|group| group.moving == moving) {
            Some(group) => group.terms.push(place),
            None => groups.push(Group { moving, terms: vec![place] }),
        }
    }
    (groups.len() < terms.len()).then_some(groups)
}

/// Builds a sum with its terms collected. A term that is alone in its group stays as it is.
fn sum(graph: &mut Graph, constant: Number, terms: Vec<(Number, Id)>, groups: Vec<Group>) -> Id {
    let (mut whole, mut weights) = (vec![], vec![]);
    for (c, term) in terms {
        let (own, rest) = graph.coefficient(term);
        let mut fixed = graph.factors(rest);
        fixed.retain(|(base, _)| !graph.reads(*base).moves());
        let fixed: Vec<Id> = fixed.into_iter().map(|(base, exponent)| graph.pow(base, exponent)).collect();
        whole.push(graph.scale(c, term));
        let weight = graph.product(&fixed);
        weights.push(graph.scale(c.mul(own), weight));
    }
    let mut all = vec![graph.number(constant)];
    for Group { moving, terms } in groups {
        if let [term] = terms[..] {
            all.push(whole[term]);
            continue;
        }
        let weights: Vec<Id> = terms.into_iter().map(|term| weights[term]).collect();
        let weight = graph.sum(&weights);
        let factors: Vec<Id> = moving.into_iter().map(|(base, exponent)| graph.pow(base, exponent)).collect();
        let product = graph.product(&factors);
        all.push(graph.mul(weight, product));
    }
    graph.sum(&all)
}
