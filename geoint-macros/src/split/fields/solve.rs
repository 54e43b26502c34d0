//! The flow of a field, all of whose coordinates that move depend on few others that move.

use super::super::scalar::{self, Equation};
use super::super::time::Clock;
use super::{Rule, linear, read};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};
use std::collections::BTreeSet;

/// Where everything that moves is after h, and by which rules.
pub(super) type Ends = (Vec<(Symbol, Id)>, Vec<Rule>);

const SCALAR: Rule = Rule { name: "single equations", fields: "x' = g(x), all else at rest" };

/// The ends of x' = rate for the coordinates that move, if they are known in closed form.
pub(super) fn solve(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<Ends> {
    blocks(graph, rates).into_iter().try_fold((vec![], vec![]), |(mut ends, mut rules), block| {
        let found = block_ends(graph, &block, clock).or_else(|| {
            let cleared = cleared(graph, &block)?;
            block_ends(graph, &cleared, clock)
        });
        let (own, rule) = found?;
        ends.extend(own);
        if !rules.contains(&rule) {
            rules.push(rule);
        }
        Some((ends, rules))
    })
}

/// Coordinates that move, each with its velocity.
type Rates = Vec<(Symbol, Id)>;

/// The coordinates that move, in sets that do not read each other.
fn blocks(graph: &Graph, rates: &[(Symbol, Id)]) -> Vec<Rates> {
    let mut sets: Vec<(BTreeSet<u32>, Rates)> = vec![];
    let moving: BTreeSet<u32> = rates.iter().filter_map(|(symbol, _)| index(*symbol)).collect();
    for (symbol, rate) in rates {
        let mut members: BTreeSet<u32> = &read(graph, *rate) & &moving;
        members.extend(index(*symbol));
        let mut equations = vec![(*symbol, *rate)];
        sets.retain_mut(|(others, own)| {
            let apart = others.is_disjoint(&members);
            if !apart {
                members.append(others);
                equations.append(own);
            }
            apart
        });
        equations.sort_unstable_by_key(|(symbol, _)| *symbol);
        sets.push((members, equations));
    }
    sets.into_iter().map(|(_, equations)| equations).collect()
}

fn index(symbol: Symbol) -> Option<u32> {
    if let Symbol::Q(i) = symbol { Some(i) } else { None }
}

fn block_ends(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<(Vec<(Symbol, Id)>, Rule)> {
    if let [(x, rate)] = *rates
        && let Some(solution) = scalar::solve(graph, &Equation { x, rate, clock })
    {
        return Some((vec![(x, solution.end)], SCALAR));
    }
    linear::ends(graph, rates)
}

/// The same with 1/u for the reciprocals of what is positive wherever H is defined. That it is, is examined by itself.
fn cleared(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Option<Vec<(Symbol, Id)>> {
    let roots: Vec<Id> = rates.iter().map(|(_, rate)| *rate).collect();
    let mut clear = Substitution::new(|_: &mut Graph, _| None);
    let mut some = false;
    for id in graph.reachable(&roots) {
        if let Node::Call(Function::RecipPositive, args) = graph.node(id).clone() {
            let plain = graph.pow(args[0], Ratio::integer(-1));
            clear.insert(id, plain);
            some = true;
        }
    }
    some.then(|| rates.iter().map(|(symbol, rate)| (*symbol, clear.apply(graph, *rate))).collect())
}
