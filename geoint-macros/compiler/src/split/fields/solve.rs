//! Flows of fields x' = f(x) whose moving coordinates form independent blocks: each block is a scalar equation, a linear field, or has pairs with constant sums.
//!
//! All coordinates here are `Symbol::Position`, as in all forms without momenta.

use super::super::polynomial::{Polynomial, times_powers};
use super::super::scalar::{self, Equation};
use super::super::time::Clock;
use super::{Rule, index, linear, read};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};
use std::collections::BTreeSet;

/// Moving coordinates x with x'. Coordinates at rest are absent.
type Rates = Vec<(Symbol, Id)>;

/// The end of a flow of length h for each moving coordinate, and the rules that found it.
pub(super) struct Ends {
    pub(super) ends: Vec<(Symbol, Id)>,
    pub(super) rules: Vec<Rule>,
}

/// The end of the flow of one block.
struct BlockEnds {
    ends: Vec<(Symbol, Id)>,
    rule: Rule,
}

const SCALAR: Rule = Rule { name: "single equations", fields: "x' = g(x), all else at rest" };

pub(super) const SUMS: Rule = Rule {
    name: "constant sums",
    fields: "xᵢ + xⱼ constant for at least two pairs, and a linear field without the xⱼ",
};

/// Returns the ends of x' = rate, if all blocks have flows in closed form. `clock` treats the time in rates.
///
/// Rules with shorter code are tried first, and the first that succeeds is kept. Plain reciprocals and constant sums are not combined.
pub(super) fn solve(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<Ends> {
    let mut all = Ends { ends: vec![], rules: vec![] };
    for block in blocks(graph, rates) {
        let BlockEnds { ends, rule } = block_ends(graph, &block, clock)
            .or_else(|| {
                let plain = with_plain_reciprocals(graph, &block)?;
                block_ends(graph, &plain, clock)
            })
            .or_else(|| by_constant_sums(graph, &block))?;
        all.ends.extend(ends);
        if !all.rules.contains(&rule) {
            all.rules.push(rule);
        }
    }
    Some(all)
}

/// Returns the moving coordinates in sets: no rate reads a coordinate of another set.
fn blocks(graph: &Graph, rates: &[(Symbol, Id)]) -> Vec<Rates> {
    let mut sets: Vec<(BTreeSet<u32>, Rates)> = vec![];
    let moving: BTreeSet<u32> = rates.iter().filter_map(|(symbol, _)| index(*symbol)).collect();
    for (symbol, rate) in rates {
        let mut members: BTreeSet<u32> = &read(graph, *rate) & &moving;
        members.extend(index(*symbol));
        let mut equations = vec![(*symbol, *rate)];
        for (others, own) in sets.extract_if(.., |(others, _)| !others.is_disjoint(&members)).collect::<Vec<_>>() {
            members.extend(others);
            equations.extend(own);
        }
        equations.sort_unstable_by_key(|(symbol, _)| *symbol);
        sets.push((members, equations));
    }
    sets.into_iter().map(|(_, equations)| equations).collect()
}

/// Returns the end of one block, solved as a scalar equation or as a linear field with constant coefficients.
fn block_ends(graph: &mut Graph, rates: &[(Symbol, Id)], clock: Clock) -> Option<BlockEnds> {
    if let [(x, rate)] = *rates
        && let Some(solution) = scalar::solve(graph, &Equation { x, rate, clock })
    {
        return Some(BlockEnds { ends: vec![(x, solution.end)], rule: SCALAR });
    }
    Some(BlockEnds { ends: linear::ends(graph, rates)?, rule: linear::LINEAR })
}

/// Returns the end of a block with at least two pairs of coordinates whose sums xᵢ + xⱼ are constant. The other equations, without the xⱼ, must be a linear field;
/// they are not divided into blocks again. Then xⱼ is the sum minus xᵢ. Example: two spins rotate about their sum.
fn by_constant_sums(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Option<BlockEnds> {
    let (mut independent, mut pairs): (Rates, Vec<[Symbol; 2]>) = (vec![], vec![]);
    for (x, rate) in rates {
        let is_opposite = |graph: &mut Graph, (y, other): &(Symbol, Id)| {
            let sum = graph.add(*rate, *other);
            linear::is_zero(graph, sum) && pairs.iter().all(|pair| !pair.contains(y))
        };
        match independent.iter().find(|other| is_opposite(graph, other)) {
            Some((y, _)) => pairs.push([*y, *x]),
            None => independent.push((*x, *rate)),
        }
    }
    // A single pair is left to the rule `planar`, which callers try next. It keeps the sum exactly: it adds the negative increment to the second coordinate.
    if pairs.len() < 2 {
        return None;
    }
    // Fields read no increments, so `PositionIncrement(j)` can stand for the constant sum xᵢ + xⱼ while the other equations are solved.
    let stand_in = |symbol: Symbol| index(symbol).map(Symbol::PositionIncrement);
    let partner = |symbol: Symbol| pairs.iter().find(|[_, y]| *y == symbol).map(|[x, _]| *x);
    let mut without_partners = Substitution::new(|graph: &mut Graph, y| {
        let [sum, x] = [stand_in(y)?, partner(y)?].map(|symbol| graph.symbol(symbol));
        Some(graph.sub(sum, x))
    });
    let mut reduced: Rates = vec![];
    for (x, rate) in independent {
        let rate = without_partners.apply(graph, rate);
        // Expanded, because quadratic terms cancel, and the field is linear then.
        let powers = Polynomial::of(graph, rate, &|symbol| matches!(symbol, Symbol::Position(_)))?;
        let terms: Vec<Id> = powers.into_terms().map(|(monomial, c)| times_powers(graph, c, &monomial)).collect();
        reduced.push((x, graph.sum(&terms)));
    }
    let mut ends = linear::ends(graph, &reduced)?;
    let mut restored_sums = Substitution::new(|graph: &mut Graph, symbol| {
        let [x, y] = *pairs.iter().find(|[_, y]| stand_in(*y) == Some(symbol))?;
        let [x, y] = [x, y].map(|symbol| graph.symbol(symbol));
        Some(graph.add(x, y))
    });
    for (_, end) in &mut ends {
        *end = restored_sums.apply(graph, *end);
    }
    for [x, y] in &pairs {
        let end = ends.iter().find(|(symbol, _)| symbol == x)?.1;
        let terms = [graph.symbol(*x), graph.symbol(*y), graph.neg(end)];
        ends.push((*y, graph.sum(&terms)));
    }
    Some(BlockEnds { ends, rule: SUMS })
}

/// Replaces checked reciprocals of positive expressions by 1/u. `None` if there are none. The solvers know powers only. The check is not lost: the domain of H
/// includes u > 0, and every step tests it.
fn with_plain_reciprocals(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Option<Rates> {
    let roots: Vec<Id> = rates.iter().map(|(_, rate)| *rate).collect();
    let mut plain = Substitution::new(|_: &mut Graph, _| None);
    let mut found = false;
    for id in graph.reachable(&roots) {
        if let Node::Call(Function::RecipPositive, args) = graph.node(id).clone() {
            let reciprocal = graph.pow(args[0], Ratio::integer(-1));
            plain.insert(id, reciprocal);
            found = true;
        }
    }
    found.then(|| rates.iter().map(|(symbol, rate)| (*symbol, plain.apply(graph, *rate))).collect())
}
