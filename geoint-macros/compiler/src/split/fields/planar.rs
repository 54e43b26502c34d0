//! Fields x' = S(x) ∇I by planes. In the plane i, j, xᵢ' = S_ij ∂_jI and x_j' = −S_ij ∂_iI, and all other coordinates are constant.
//!
//! Each plane keeps I, and the sum over i < j is the field. The flow of a plane has a closed form, or a step is solved for with divided
//! differences of I. G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.

use super::super::polynomial::is_free;
use super::super::scalar::{self, Equation};
use super::super::time::Clock;
use super::solve::{Ends, solve};
use super::{Motion, NoPart, Part, Rule, clock};
use crate::diff;
use crate::diff::field::Field;
use crate::diff::{coordinate_at_end, coordinate_in_middle};
use crate::ir::substitute::{Substitution, replaced};
use crate::ir::{Graph, Id, Symbol};

const LINE: Rule = Rule { name: "line", fields: "x' = w(x)·d with a constant d, w of degree 2 at most along it" };

const DISCRETE: Rule =
    Rule { name: "planar discrete gradient", fields: "S_ij ∇I in a plane, solved for: 2 unknowns, I kept, order 2" };

const INCREMENTS: Rule = Rule {
    name: "planar increments",
    fields: "S_ij ∇I in a plane, solved for: 2 unknowns, one coordinate after the other, I kept, order 1",
};

/// The largest number of planes that are solved for. Each plane has its own equation, which costs compile time and is solved twice in each step.
const MOST_SOLVED: usize = 12;

/// The path between both ends of a step for the divided differences of I, and the point where S_ij is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Path {
    /// The tree discrete gradient, with S_ij in the middle. The step is symmetric.
    Straight,
    /// The first coordinate moves before the second one. S_ij is taken at the start.
    FirstAhead,
    /// The second coordinate moves before the first one. S_ij is taken at the end. The step is the adjoint of `FirstAhead`.
    SecondAhead,
}

/// A plane of two coordinates.
struct Plane {
    pair: [u32; 2],
    /// S_ij.
    s: Id,
    /// ∂_jI and −∂_iI.
    directions: [Id; 2],
    /// The nonzero rates.
    rates: Vec<(Symbol, Id)>,
}

impl Plane {
    fn symbols(&self) -> [Symbol; 2] {
        self.pair.map(Symbol::Position)
    }

    fn part(&self, graph: &Graph, motion: Motion, rules: Vec<Rule>) -> Part {
        Part { formula: self.rates[0].1, rules, clock: clock(graph, &self.rates), motion }
    }

    /// Returns the first velocity that is not linear in the plane, or else the first velocity.
    fn without_flow(&self, graph: &mut Graph) -> NoPart {
        let pair = self.symbols();
        let rates: Vec<Id> = self.rates.iter().map(|(_, rate)| *rate).collect();
        let slopes = diff::jacobian(graph, &rates, &pair);
        let moves = |symbol: Symbol| pair.contains(&symbol);
        let bent = slopes.iter().position(|row| row.iter().any(|slope| !is_free(graph, *slope, &moves)));
        NoPart { formula: rates[bent.unwrap_or(0)], pair: Some(pair) }
    }
}

/// Returns all planes that move, in the order of the entries of S.
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

/// Returns the planes in the order of half a step. If all flows have a closed form, planes of neighbouring coordinates come first. Otherwise the
/// order is the order of the entries of S.
pub(crate) fn planes(graph: &mut Graph, integral: Id, structure: &[Vec<Id>]) -> Result<Vec<Part>, NoPart> {
    let mut parts: Vec<([u32; 2], Part)> = vec![];
    let mut open: Vec<NoPart> = vec![];
    let slopes = diff::discrete_gradient(graph, integral, structure.len() as u32).q;
    for plane in all(graph, integral, structure) {
        let clock = clock(graph, &plane.rates);
        let closed = solve(graph, &plane.rates, clock).or_else(|| line(graph, &plane, clock));
        let (motion, rules) = match closed {
            Some(Ends { ends, rules }) => (Motion::Closed(ends), rules),
            None => {
                open.push(plane.without_flow(graph));
                (solved(graph, &slopes, &plane, Path::Straight), vec![DISCRETE])
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

/// Returns two lists of parts: all planes by discrete gradients, and all planes by increments, followed by their adjoints in reverse order.
pub(crate) fn solved_planes(graph: &mut Graph, integral: Id, structure: &[Vec<Id>]) -> [Result<Vec<Part>, NoPart>; 2] {
    let planes = all(graph, integral, structure);
    if planes.len() > MOST_SOLVED {
        let first = planes[0].without_flow(graph);
        return [Err(first), Err(first)];
    }
    let slopes = diff::discrete_gradient(graph, integral, structure.len() as u32).q;
    let mut part = |plane: &Plane, path, rule| {
        let motion = solved(graph, &slopes, plane, path);
        plane.part(graph, motion, vec![rule])
    };
    let straight = planes.iter().map(|plane| part(plane, Path::Straight, DISCRETE)).collect();
    let mut increments: Vec<Part> = planes.iter().map(|plane| part(plane, Path::FirstAhead, INCREMENTS)).collect();
    increments.extend(planes.iter().rev().map(|plane| part(plane, Path::SecondAhead, INCREMENTS)));
    [Ok(straight), Ok(increments)]
}

/// Returns the flow of a plane with constant directions d. On the line x + τd, τ' = S_ij(x + τd).
fn line(graph: &mut Graph, plane: &Plane, clock: Clock) -> Option<Ends> {
    let (pair, directions) = (plane.symbols(), plane.directions);
    let moves = |symbol: Symbol| pair.contains(&symbol);
    if !directions.iter().all(|d| is_free(graph, *d, &moves)) {
        return None;
    }
    // The symbol for τ does not occur in S.
    let tau = Symbol::PositionIncrement(0);
    let on_line = |graph: &mut Graph, symbol: Symbol| {
        let place = pair.iter().position(|other| *other == symbol)?;
        let [tau, x] = [tau, symbol].map(|symbol| graph.symbol(symbol));
        let moved = graph.mul(tau, directions[place]);
        Some(graph.add(x, moved))
    };
    let rate = Substitution::new(on_line).apply(graph, plane.s);
    let solution = scalar::solve(graph, &Equation { x: tau, rate, clock })?;
    let zero = graph.zero();
    let length = replaced(graph, solution.end, tau, zero);
    let mut ends = vec![];
    for (symbol, d) in pair.into_iter().zip(directions) {
        if !graph.is_zero(d) {
            let (x, moved) = (graph.symbol(symbol), graph.mul(length, d));
            ends.push((symbol, graph.add(x, moved)));
        }
    }
    Some(Ends { ends, rules: vec![LINE] })
}

/// The state of one coordinate of a plane while a divided difference is taken along the other coordinate.
#[derive(Clone, Copy, PartialEq)]
enum Beside {
    Moving,
    AtStart,
    AtEnd,
}

/// Returns the step S_ij·(∂̄_jI, −∂̄_iI), whose order is 1 or 2. `slopes` is the discrete gradient of I.
fn solved(graph: &mut Graph, slopes: &[Id], plane: &Plane, path: Path) -> Motion {
    let [i, j] = plane.pair;
    let unknowns = [i, j].map(Symbol::PositionIncrement).to_vec();
    let [i_beside, j_beside] = match path {
        Path::Straight => [Beside::Moving, Beside::Moving],
        Path::FirstAhead => [Beside::AtEnd, Beside::AtStart],
        Path::SecondAhead => [Beside::AtStart, Beside::AtEnd],
    };
    let along = |graph: &mut Graph, own: u32, other: u32, beside: Beside| {
        let place = |graph: &mut Graph, symbol| match symbol {
            Symbol::PositionIncrement(k) if k != own && (k != other || beside != Beside::Moving) => Some(graph.zero()),
            Symbol::Position(k) if k == other && beside == Beside::AtEnd => coordinate_at_end(graph, symbol),
            _ => None,
        };
        Substitution::new(place).apply(graph, slopes[own as usize])
    };
    let [by_j, by_i] = [along(graph, j, i, i_beside), along(graph, i, j, j_beside)];
    let moves = |symbol: Symbol| plane.symbols().contains(&symbol);
    let place = |graph: &mut Graph, symbol| match path {
        Path::Straight if moves(symbol) => coordinate_in_middle(graph, symbol),
        Path::SecondAhead if moves(symbol) => coordinate_at_end(graph, symbol),
        _ => None,
    };
    let s = Substitution::new(place).apply(graph, plane.s);
    let back = graph.neg(by_i);
    let f = vec![graph.mul(s, by_j), graph.mul(s, back)];
    let jacobian = diff::jacobian(graph, &f, &unknowns);
    Motion::Solved(plane.symbols(), Field { unknowns, f, jacobian })
}
