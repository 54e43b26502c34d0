//! Terms that differ in parameters alone are collected: m₀·c·x + m₁·c·x becomes (m₀ + m₁)·c·x, of which the sum is known before the loop.
//!
//! Derivatives along a recursion over links are such sums, as long as the chain. The graph keeps sums as they are written, so this is done
//! to the results of a kernel that asks for it.

use super::{Graph, Id, Node, Number, Ratio, Table, hash};

/// The same nodes with such terms collected, in every sum that they are made of.
pub(crate) fn collected(graph: &mut Graph, roots: &[Id]) -> Vec<Id> {
    collected_with(graph, roots, &[])
}

/// The same, with some nodes replaced by others: what is rebuilt is rebuilt once.
pub(crate) fn collected_with(graph: &mut Graph, roots: &[Id], replaced: &[(Id, Id)]) -> Vec<Id> {
    let mut new: Table<Id> = Table::default();
    let values: Vec<Id> = replaced.iter().map(|(_, value)| *value).collect();
    collect(graph, &values, &mut new);
    let values: Vec<Id> = values.iter().map(|value| new[*value]).collect();
    let mut new: Table<Id> = Table::default();
    for ((id, _), value) in replaced.iter().zip(values) {
        new.insert(*id, value);
    }
    collect(graph, roots, &mut new);
    roots.iter().map(|root| new[*root]).collect()
}

fn collect(graph: &mut Graph, roots: &[Id], new: &mut Table<Id>) {
    for id in graph.unknown_of(roots, new) {
        let mut same = true;
        graph.node(id).for_each_child(|child| same &= new[child] == child);
        let rebuilt = match graph.node(id) {
            // Conditions decide as they are written.
            Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) => id,
            Node::Linear(constant, terms) => {
                let constant = *constant;
                let mut rebuilt = terms.clone();
                for (_, term) in &mut rebuilt {
                    *term = new[*term];
                }
                match may_collect(graph, &rebuilt) {
                    true => sum(graph, constant, rebuilt),
                    false if same => id,
                    false => graph.scaled_sum(constant, &rebuilt),
                }
            }
            // Of powers that were merged there may be more than two factors: then they are nested, so that others meet a part of them.
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

/// Whether two terms may have the same factors that move: they are compared by a number that seldom is the same for others.
fn may_collect(graph: &Graph, terms: &[(Number, Id)]) -> bool {
    let mut numbers: Vec<u64> = vec![];
    for (_, term) in terms {
        let number = moving(graph, *term);
        for other in &numbers {
            if *other == number {
                return true;
            }
        }
        numbers.push(number);
    }
    false
}

/// A number that does not depend on the order of factors that move, nor on the others.
fn moving(graph: &Graph, id: Id) -> u64 {
    match graph.node(id) {
        _ if !graph.reads(id).moves() => 0,
        Node::Product(factors) => {
            let mut number = 0_u64;
            for factor in factors {
                number = number.wrapping_add(moving(graph, *factor));
            }
            number
        }
        Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => moving(graph, terms[0].1),
        Node::Power(base, exponent) => hash::of_words(&[base.index() as u64, exponent.word()]).into(),
        _ => hash::of_words(&[id.index() as u64, Ratio::ONE.word()]).into(),
    }
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
