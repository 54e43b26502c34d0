//! x' = S(x) ∇I by planes: xᵢ' = S_ij ∂_jI, x_j' = −S_ij ∂_iI with everything else at rest keeps I, and their sum over i < j is the field.
//! A plane has a flow in closed form, or is solved for with divided differences of I.
//!
//! G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.

use super::super::polynomial::is_free;
use super::super::scalar::{self, Equation};
use super::super::time::Clock;
use super::solve::{Ends, solve};
use super::{Motion, NoPart, Part, Rule, clock};
use crate::diff;
use crate::diff::field::Field;
use crate::diff::{end, middle};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

const LINE: Rule = Rule { name: "line", fields: "x' = w(x)·d with a constant d, w of degree 2 at most along it" };

const DISCRETE: Rule =
    Rule { name: "planar discrete gradient", fields: "S_ij ∇I in a plane, solved for: 2 unknowns, I kept, order 2" };

const INCREMENTS: Rule = Rule {
    name: "planar increments",
    fields: "S_ij ∇I in a plane, solved for: 2 unknowns, one coordinate after the other, I kept, order 1",
};

/// Not more planes than this are solved for: each has an equation of its own, which users pay for when they compile, and which a step
/// solves twice.
const MOST_SOLVED: usize = 12;

/// The way between both ends of a step along which divided differences of I are taken, and where S_ij is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// The tree discrete gradient, S_ij in the middle: symmetric.
    Straight,
    /// The first coordinate, then the second, S_ij at the start.
    FirstAhead,
    /// The second coordinate, then the first, S_ij at the end: the adjoint of that.
    SecondAhead,
}

/// A plane: its coordinates, S_ij, and what it moves.
struct Plane {
    pair: [u32; 2],
    s: Id,
    /// ∂_jI and −∂_iI.
    directions: [Id; 2],
    /// Of what moves.
    rates: Vec<(Symbol, Id)>,
}

impl Plane {
    fn symbols(&self) -> [Symbol; 2] {
        self.pair.map(Symbol::Position)
    }

    fn part(&self, graph: &Graph, motion: Motion, rules: Vec<Rule>) -> Part {
        Part { formula: self.rates[0].1, rules, clock: clock(graph, &self.rates), motion }
    }

    /// The first velocity that is not linear in the plane, or the first of all.
    fn bent(&self, graph: &mut Graph) -> NoPart {
        let pair = self.symbols();
        let rates: Vec<Id> = self.rates.iter().map(|(_, rate)| *rate).collect();
        let slopes = diff::jacobian(graph, &rates, &pair);
        let moves = |symbol: Symbol| pair.contains(&symbol);
        let bent = slopes.iter().position(|row| row.iter().any(|slope| !is_free(graph, *slope, &moves)));
        NoPart { formula: rates[bent.unwrap_or(0)], pair: Some(pair) }
    }
}

/// All planes in the order of the entries of S.
fn all(graph: &mut Graph, integral: Id, structure: &[Vec<Id>]) -> Vec<Plane> {
    let n = structure.len();
    let slopes = diff::gradient(graph, integral, n as u32).q;
    let mut planes = vec![];
    for i in 0..n {
        for j in i + 1..n {
            let (s, pair) = (structure[i][j], [i as u32, j as u32]);
            if graph.is_zero(s) {
                continue;
            }
            let directions = [slopes[j], graph.neg(slopes[i])];
            let rates = pair.map(Symbol::Position).into_iter().zip(directions.map(|d| graph.mul(s, d)));
            let rates: Vec<(Symbol, Id)> = rates.filter(|(_, rate)| !graph.is_zero(*rate)).collect();
            if !rates.is_empty() {
                planes.push(Plane { pair, s, directions, rates });
            }
        }
    }
    planes
}

/// The parts in the order of half a step: neighbours first where all flows are known, else as the entries of S are written.
pub(crate) fn planes(graph: &mut Graph, integral: Id, structure: &[Vec<Id>]) -> Result<Vec<Part>, NoPart> {
    let mut parts: Vec<([u32; 2], Part)> = vec![];
    let mut open: Vec<NoPart> = vec![];
    let slopes = diff::discrete_gradient(graph, integral, structure.len() as u32).q;
    for plane in all(graph, integral, structure) {
        let clock = clock(graph, &plane.rates);
        let closed = solve(graph, &plane.rates, clock).or_else(|| line(graph, &plane, clock));
        let (motion, rules) = match closed {
            Some((ends, rules)) => (Motion::Closed(ends), rules),
            None => {
                open.push(plane.bent(graph));
                (solved(graph, &slopes, &plane, Way::Straight), vec![DISCRETE])
            }
        };
        parts.push((plane.pair, plane.part(graph, motion, rules)));
    }
    if open.len() > MOST_SOLVED {
        return Err(open[0]);
    }
    if open.is_empty() {
        parts.sort_by_key(|([i, j], _)| (j - i, *i));
    }
    Ok(parts.into_iter().map(|(_, part)| part).collect())
}

/// All planes as discrete gradients; and as increments, then their adjoints in reverse.
pub(crate) fn solved_planes(graph: &mut Graph, integral: Id, structure: &[Vec<Id>]) -> [Result<Vec<Part>, NoPart>; 2] {
    let planes = all(graph, integral, structure);
    if planes.len() > MOST_SOLVED {
        let first = planes[0].bent(graph);
        return [Err(first), Err(first)];
    }
    let slopes = diff::discrete_gradient(graph, integral, structure.len() as u32).q;
    let mut parts = |planes: &mut dyn Iterator<Item = &Plane>, way, rule| -> Vec<Part> {
        planes
            .map(|plane| {
                let motion = solved(graph, &slopes, plane, way);
                plane.part(graph, motion, vec![rule])
            })
            .collect()
    };
    let straight = parts(&mut planes.iter(), Way::Straight, DISCRETE);
    let mut increments = parts(&mut planes.iter(), Way::FirstAhead, INCREMENTS);
    increments.extend(parts(&mut planes.iter().rev(), Way::SecondAhead, INCREMENTS));
    [Ok(straight), Ok(increments)]
}

/// The ends on a line: with x + τd, τ' = S_ij(x + τd) is Riccati's equation.
fn line(graph: &mut Graph, plane: &Plane, clock: Clock) -> Option<Ends> {
    let (pair, directions) = (plane.symbols(), plane.directions);
    let moves = |symbol: Symbol| pair.contains(&symbol);
    if !directions.iter().all(|d| is_free(graph, *d, &moves)) {
        return None;
    }
    // The way along the line is called by a symbol that nothing else here reads.
    let way = Symbol::PositionIncrement(0);
    let on_line = |graph: &mut Graph, symbol: Symbol| {
        let place = pair.iter().position(|other| *other == symbol)?;
        let [way, x] = [way, symbol].map(|symbol| graph.symbol(symbol));
        let moved = graph.mul(way, directions[place]);
        Some(graph.add(x, moved))
    };
    let rate = Substitution::new(on_line).apply(graph, plane.s);
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

/// S_ij·(∂̄_jI, −∂̄_iI), of order 1 or 2; `slopes` is the discrete gradient of I.
fn solved(graph: &mut Graph, slopes: &[Id], plane: &Plane, way: Way) -> Motion {
    let [i, j] = plane.pair;
    let unknowns = [i, j].map(Symbol::PositionIncrement).to_vec();
    // Of both divided differences: which coordinates move in it, and which is at its end.
    let [first, second] = match way {
        Way::Straight => [(vec![i, j], None), (vec![i, j], None)],
        Way::FirstAhead => [(vec![i], None), (vec![j], Some(i))],
        Way::SecondAhead => [(vec![i], Some(j)), (vec![j], None)],
    };
    let along = |graph: &mut Graph, slope: Id, (moving, ahead): (Vec<u32>, Option<u32>)| {
        let place = |graph: &mut Graph, symbol| match symbol {
            Symbol::PositionIncrement(k) if !moving.contains(&k) => Some(graph.zero()),
            Symbol::Position(k) if ahead == Some(k) => end(graph, symbol),
            _ => None,
        };
        Substitution::new(place).apply(graph, slope)
    };
    let slopes = [along(graph, slopes[j as usize], second), along(graph, slopes[i as usize], first)];
    let moves = |symbol: Symbol| plane.symbols().contains(&symbol);
    let place = |graph: &mut Graph, symbol| match way {
        Way::Straight if moves(symbol) => middle(graph, symbol),
        Way::SecondAhead if moves(symbol) => end(graph, symbol),
        _ => None,
    };
    let s = Substitution::new(place).apply(graph, plane.s);
    let back = graph.neg(slopes[1]);
    let f: Vec<Id> = [slopes[0], back].into_iter().map(|slope| graph.mul(s, slope)).collect();
    let jacobian = diff::jacobian(graph, &f, &unknowns);
    Motion::Solved(plane.symbols(), Field { unknowns, f, jacobian })
}
