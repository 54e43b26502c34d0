//! The flow of a field, all of whose coordinates that move depend on few others that move.

use super::super::polynomial::{Polynomial, times_powers};
use super::super::scalar::{self, Equation};
use super::super::time::Clock;
use super::{Rule, linear, read};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};
use std::collections::BTreeSet;

/// Where everything that moves is after h, and by which rules.
pub(super) type Ends = (Vec<(Symbol, Id)>, Vec<Rule>);

const SCALAR: Rule = Rule { name: "single equations", fields: "x' = g(x), all else at rest" };

pub(super) const SUMS: Rule = Rule {
    name: "constant sums",
    fields: "xᵢ + xⱼ at rest for pairs of coordinates, by which half of them follow",
};

/// The ends of x' = rate for the coordinates that move, if they are known in closed form.
pub(super) fn solve(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<Ends> {
    blocks(graph, rates).into_iter().try_fold((vec![], vec![]), |(mut ends, mut rules), block| {
        let found = block_ends(graph, &block, clock)
            .or_else(|| {
                let cleared = cleared(graph, &block)?;
                block_ends(graph, &cleared, clock)
            })
            .or_else(|| by_constant_sums(graph, &block, clock));
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
    if let Symbol::Position(i) = symbol { Some(i) } else { None }
}

fn block_ends(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<(Vec<(Symbol, Id)>, Rule)> {
    if let [(x, rate)] = *rates
        && let Some(solution) = scalar::solve(graph, &Equation { x, rate, clock })
    {
        return Some((vec![(x, solution.end)], SCALAR));
    }
    linear::ends(graph, rates)
}

/// Where xᵢ + xⱼ stays for pairs of coordinates, half of them are known by these sums: two spins turn about the sum of both.
fn by_constant_sums(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<(Vec<(Symbol, Id)>, Rule)> {
    let (mut left, mut pairs): (Rates, Vec<[Symbol; 2]>) = (vec![], vec![]);
    for (x, rate) in rates {
        let opposite = |graph: &mut Graph, (y, other): &(Symbol, Id)| {
            let sum = graph.add(*rate, *other);
            linear::is_zero(graph, sum) && pairs.iter().all(|pair| !pair.contains(y))
        };
        match left.iter().find(|other| opposite(graph, other)) {
            Some((y, _)) => pairs.push([*y, *x]),
            None => left.push((*x, *rate)),
        }
    }
    // One pair is a plane: its own rules add to one what they take from the other, and the sum has no trend by rounding.
    if pairs.len() < 2 {
        return None;
    }
    // A sum is a constant under a name of its own while the equations of the others are solved.
    let name = |symbol: Symbol| index(symbol).map(Symbol::PositionIncrement);
    let partner = |symbol: Symbol| pairs.iter().find(|[_, y]| *y == symbol).map(|[x, _]| *x);
    let mut known = Substitution::new(|graph: &mut Graph, y| {
        let [sum, x] = [name(y)?, partner(y)?].map(|symbol| graph.symbol(symbol));
        Some(graph.sub(sum, x))
    });
    let mut reduced: Rates = vec![];
    for (x, rate) in left {
        let rate = known.apply(graph, rate);
        let powers = Polynomial::of(graph, rate, &|symbol| matches!(symbol, Symbol::Position(_)))?;
        let terms: Vec<Id> = powers.into_terms().map(|(monomial, c)| times_powers(graph, c, &monomial)).collect();
        reduced.push((x, graph.sum(&terms)));
    }
    let (mut ends, _) = block_ends(graph, &reduced, clock)?;
    let mut named = Substitution::new(|graph: &mut Graph, symbol| {
        let [x, y] = *pairs.iter().find(|[_, y]| name(*y) == Some(symbol))?;
        let [x, y] = [x, y].map(|symbol| graph.symbol(symbol));
        Some(graph.add(x, y))
    });
    for (_, end) in &mut ends {
        *end = named.apply(graph, *end);
    }
    for [x, y] in &pairs {
        let end = ends.iter().find(|(symbol, _)| symbol == x)?.1;
        let terms = [graph.symbol(*x), graph.symbol(*y), graph.neg(end)];
        ends.push((*y, graph.sum(&terms)));
    }
    Some((ends, SUMS))
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
