//! x' = S(x) ∇I by planes: xᵢ' = S_ij ∂_jI, x_j' = −S_ij ∂_iI with everything else at rest keeps I, and their sum over i < j is the field.
//!
//! G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.

use super::super::polynomial::is_free;
use super::super::scalar::{self, Equation};
use super::super::time::Clock;
use super::solve::{Ends, solve};
use super::{Motion, NoPart, Part, Rule, clock};
use crate::diff;
use crate::diff::field::{Field, middle};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

const LINE: Rule = Rule { name: "line", fields: "x' = w(x)·d with a constant d, w of degree 2 at most along it" };

const DISCRETE: Rule =
    Rule { name: "planar discrete gradient", fields: "S_ij ∇I in a plane, solved for: 2 unknowns, I kept, order 2" };

/// Not more planes than this are solved for: each has an equation of its own, which users pay for when they compile, and which a step
/// solves twice.
const MOST_SOLVED: usize = 12;

/// The parts in the order of half a step: neighbours first where all flows are known, else as the entries of S are written.
pub(crate) fn planes(graph: &mut Graph, integral: Id, structure: &[Vec<Id>]) -> Result<Vec<Part>, NoPart> {
    let n = structure.len();
    let slopes = diff::gradient(graph, integral, n as u32).q;
    let mut parts: Vec<([usize; 2], Part)> = vec![];
    let mut open: Option<NoPart> = None;
    for i in 0..n {
        for j in i + 1..n {
            let s = structure[i][j];
            if graph.is_zero(s) {
                continue;
            }
            let pair = [i as u32, j as u32].map(Symbol::Q);
            let back = graph.neg(slopes[i]);
            let directions = [slopes[j], back];
            let rates: Vec<(Symbol, Id)> = pair
                .into_iter()
                .zip(directions.map(|d| graph.mul(s, d)))
                .filter(|(_, rate)| !graph.is_zero(*rate))
                .collect();
            let Some((_, formula)) = rates.first().copied() else { continue };
            let clock = clock(graph, &rates);
            let closed = solve(graph, &rates, clock).or_else(|| line(graph, pair, directions, (s, clock)));
            let (motion, rules) = match closed {
                Some((ends, rules)) => (Motion::Closed(ends), rules),
                None => {
                    let slopes = diff::jacobian(graph, &rates.iter().map(|(_, rate)| *rate).collect::<Vec<_>>(), &pair);
                    let moves = |symbol: Symbol| pair.contains(&symbol);
                    let bent = slopes.iter().position(|row| row.iter().any(|slope| !is_free(graph, *slope, &moves)));
                    let formula = bent.map_or(formula, |i| rates[i].1);
                    open.get_or_insert(NoPart { formula, pair: Some(pair) });
                    (Motion::Solved(pair, discrete(graph, integral, s, (pair, n))), vec![DISCRETE])
                }
            };
            parts.push(([i, j], Part { formula, rules, clock, motion }));
        }
    }
    let solved = parts.iter().filter(|(_, part)| matches!(part.motion, Motion::Solved(..))).count();
    if let Some(open) = open.filter(|_| solved > MOST_SOLVED) {
        return Err(open);
    }
    if solved == 0 {
        parts.sort_by_key(|([i, j], _)| (j - i, *i));
    }
    Ok(parts.into_iter().map(|(_, part)| part).collect())
}

/// The ends on a line: with x + τd, τ' = S_ij(x + τd) is Riccati's equation.
fn line(graph: &mut Graph, pair: [Symbol; 2], directions: [Id; 2], (s, clock): (Id, Clock)) -> Option<Ends> {
    let moves = |symbol: Symbol| pair.contains(&symbol);
    if !directions.iter().all(|d| is_free(graph, *d, &moves)) {
        return None;
    }
    // The way along the line is called by a symbol that nothing else here reads.
    let way = Symbol::Dq(0);
    let on_line = |graph: &mut Graph, symbol: Symbol| {
        let place = pair.iter().position(|other| *other == symbol)?;
        let [way, x] = [way, symbol].map(|symbol| graph.symbol(symbol));
        let moved = graph.mul(way, directions[place]);
        Some(graph.add(x, moved))
    };
    let rate = Substitution::new(on_line).apply(graph, s);
    let solution = scalar::solve(graph, &Equation { x: way, rate, clock })?;
    let way =
        Substitution::new(|graph: &mut Graph, symbol| (symbol == way).then(|| graph.zero())).apply(graph, solution.end);
    let mut ends = vec![];
    for (symbol, d) in pair.into_iter().zip(directions).filter(|(_, d)| !graph.is_zero(*d)).collect::<Vec<_>>() {
        let (x, moved) = (graph.symbol(symbol), graph.mul(way, d));
        ends.push((symbol, graph.add(x, moved)));
    }
    Some((ends, vec![LINE]))
}

/// S_ij(m)·(∂̄_jI, −∂̄_iI) with the discrete gradient of I in the plane.
fn discrete(graph: &mut Graph, integral: Id, s: Id, (pair, n): ([Symbol; 2], usize)) -> Field {
    let [Symbol::Q(i), Symbol::Q(j)] = pair else { return Field { unknowns: vec![], f: vec![], jacobian: vec![] } };
    let unknowns = [i, j].map(Symbol::Dq).to_vec();
    let slopes = diff::discrete_gradient(graph, integral, n as u32).q;
    let s = Substitution::new(middle).apply(graph, s);
    let back = graph.neg(slopes[i as usize]);
    let at_rest = |graph: &mut Graph, symbol| match symbol {
        Symbol::Dq(k) if k != i && k != j => Some(graph.zero()),
        _ => None,
    };
    let mut in_plane = Substitution::new(at_rest);
    let f: Vec<Id> = [slopes[j as usize], back]
        .into_iter()
        .map(|slope| {
            let whole = graph.mul(s, slope);
            in_plane.apply(graph, whole)
        })
        .collect();
    let jacobian = diff::jacobian(graph, &f, &unknowns);
    Field { unknowns, f, jacobian }
}
