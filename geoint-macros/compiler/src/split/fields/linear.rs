//! x' = g·(Mx + b) with M³ = −κM and M²b = −κb, where g is constant along the flow: with τ = gh and ω² = κ,
//!
//! x₁ = x + s·(cos(ωτ/2)·(Mx + b) + s/2·M(Mx + b)), s = 2 sin(ωτ/2)/ω.
//!
//! Rotations, shears and hyperbolic rotations are of this kind, about any axis and any centre, and so are parabolas.

use super::super::polynomial::{factors, is_free};
use super::super::scalar::rotation;
use super::Rule;
use crate::analyze;
use crate::diff;
use crate::diff::equations::times;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

pub(super) const LINEAR: Rule =
    Rule { name: "linear field", fields: "x' = g·(Mx + b), M³ = −κM, M²b = −κb, g constant along the flow" };

/// The ends of the flow, if it is of this kind.
pub(super) fn ends(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Option<(Vec<(Symbol, Id)>, Rule)> {
    let symbols: Vec<Symbol> = rates.iter().map(|(symbol, _)| *symbol).collect();
    let moves = |symbol: Symbol| symbols.contains(&symbol);
    let (g, velocity) = common_factor(graph, rates, &moves);
    let matrix = diff::jacobian(graph, &velocity, &symbols);
    if !matrix.iter().flatten().all(|entry| is_free(graph, *entry, &moves)) {
        return None;
    }
    // Derivatives do not show that the other side of a condition is another field.
    let conditions: Vec<Id> = velocity.iter().flat_map(|v| analyze::conditions(graph, *v)).collect();
    if !conditions.iter().all(|condition| is_free(graph, *condition, &moves)) {
        return None;
    }
    // g is constant along Mx + b.
    let slopes = diff::jacobian(graph, &[g], &symbols);
    let change = times(graph, &slopes, &velocity)[0];
    if !is_zero(graph, change) || analyze::crossings::may_jump(graph, &symbols, &velocity, g).is_some() {
        return None;
    }
    let h = graph.symbol(Symbol::StepLength);
    let tau = graph.mul(g, h);
    let x: Vec<Id> = symbols.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let finished = |ends: Vec<Id>| Some((symbols.iter().copied().zip(ends).collect(), LINEAR));
    if let Some(ends) = plane_rotation(graph, &matrix, &velocity, (&x, tau)) {
        return finished(ends);
    }
    let square = product(graph, &matrix, &matrix);
    let cube = product(graph, &square, &matrix);
    let trace: Vec<Id> = (0..x.len()).map(|i| square[i][i]).collect();
    let trace = graph.sum(&trace);
    let kappa = graph.scale(Number::HALF.neg(), trace);
    let constant = constant_part(graph, &velocity, &moves);
    let pushed = times(graph, &square, &constant);
    for (third, first) in cube.iter().flatten().zip(matrix.iter().flatten()).chain(pushed.iter().zip(&constant)) {
        let scaled = graph.mul(kappa, *first);
        let sum = graph.add(*third, scaled);
        if !is_zero(graph, sum) {
            return None;
        }
    }
    let acceleration = times(graph, &matrix, &velocity);
    // With ω/2 in place of ω: cos, and 2 sin/ω; 1 − cos ωτ = 2 sin²(ωτ/2).
    let (cosine, sine) = if is_zero(graph, kappa) {
        (graph.integer(1), tau)
    } else {
        let quarter = graph.scale(Number::Exact(Ratio::integer(4).recip()?), kappa);
        rotation(graph, quarter, tau, false)
    };
    let half_sine = graph.scale(Number::HALF, sine);
    let mut ends = vec![];
    for ((x, v), a) in x.iter().zip(&velocity).zip(&acceleration) {
        let terms = [graph.mul(cosine, *v), graph.mul(half_sine, *a)];
        ends.push(moved_along(graph, *x, sine, &terms));
    }
    finished(ends)
}

/// x' = m·y, y' = −m·x: by the angle m·τ itself.
fn plane_rotation(graph: &mut Graph, matrix: &[Vec<Id>], velocity: &[Id], (x, tau): (&[Id], Id)) -> Option<Vec<Id>> {
    let [[a, m], [minus, d]] = square_of_two(matrix)?;
    let sum = graph.add(m, minus);
    let turns = [a, d, sum].into_iter().all(|entry| graph.is_zero(entry));
    let first = graph.mul(m, x[1]);
    let second = graph.mul(minus, x[0]);
    if !turns || velocity != [first, second] {
        return None;
    }
    let angle = graph.mul(m, tau);
    let back = graph.neg(x[0]);
    let all = [[x[0], x[1]], [x[1], back]];
    let turned =
        |graph: &mut Graph, angle: Id| [Function::Cos, Function::Sin].map(|function| graph.call(function, &[angle]));
    // What is prepared is made to add to x elsewhere.
    if !graph.reads(angle).state() {
        let [cosine, sine] = turned(graph, angle);
        let ends = all.map(|[x, y]| {
            let terms = [graph.mul(cosine, x), graph.mul(sine, y)];
            graph.sum(&terms)
        });
        return Some(ends.to_vec());
    }
    let half = graph.scale(Number::HALF, angle);
    let [cosine, sine] = turned(graph, half);
    let double = graph.scale(Number::integer(2), sine);
    let ends = all.map(|[x, y]| {
        let opposite = graph.neg(x);
        let terms = [graph.mul(cosine, y), graph.mul(sine, opposite)];
        moved_along(graph, x, double, &terms)
    });
    Some(ends.to_vec())
}

/// x + c·Σ: the small terms are added up before they meet x. Added to x one by one they would be rounded alike in many steps, and a rounded
/// cosine alike in all, so that what such flows keep would have a trend.
fn moved_along(graph: &mut Graph, x: Id, c: Id, terms: &[Id]) -> Id {
    let sum = graph.sum(terms);
    let change = graph.mul(c, sum);
    graph.add(x, change)
}

fn square_of_two(matrix: &[Vec<Id>]) -> Option<[[Id; 2]; 2]> {
    let [first, second] = matrix else { return None };
    Some([<[Id; 2]>::try_from(&first[..]).ok()?, <[Id; 2]>::try_from(&second[..]).ok()?])
}

/// What all rates have as a factor, and is no linear function of what moves; and the rates without it.
fn common_factor(graph: &mut Graph, rates: &[(Symbol, Id)], moves: &impl Fn(Symbol) -> bool) -> (Id, Vec<Id>) {
    let velocity: Vec<Id> = rates.iter().map(|(_, rate)| *rate).collect();
    let mut common: Option<Vec<(Id, Ratio)>> = None;
    for rate in &velocity {
        let rest = graph.coefficient(*rate).1;
        let own: Vec<(Id, Ratio)> =
            factors(graph, rest).into_iter().filter(|(base, _)| !is_free(graph, *base, moves)).collect();
        common = Some(match common {
            None => own,
            Some(common) => common.into_iter().filter(|factor| own.contains(factor)).collect(),
        });
    }
    let one = graph.integer(1);
    let common = common.unwrap_or_default();
    let mut g = one;
    for (base, exponent) in &common {
        let factor = graph.pow(*base, *exponent);
        g = graph.mul(g, factor);
    }
    let without = |graph: &mut Graph, rate: Id| {
        let (c, rest) = graph.coefficient(rate);
        let mut left = graph.number(c);
        for factor in factors(graph, rest).into_iter().filter(|factor| !common.contains(factor)) {
            let factor = graph.pow(factor.0, factor.1);
            left = graph.mul(left, factor);
        }
        left
    };
    let velocity = velocity.into_iter().map(|rate| without(graph, rate)).collect();
    (g, velocity)
}

/// What velocities are where everything that moves is zero.
fn constant_part(graph: &mut Graph, velocity: &[Id], moves: &impl Fn(Symbol) -> bool) -> Vec<Id> {
    let mut at_zero = Substitution::new(|graph: &mut Graph, symbol| moves(symbol).then(|| graph.zero()));
    velocity.iter().map(|v| at_zero.apply(graph, *v)).collect()
}

fn product(graph: &mut Graph, a: &[Vec<Id>], b: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let n = a.len();
    let columns: Vec<Vec<Id>> = (0..n).map(|j| b.iter().map(|row| row[j]).collect()).collect();
    let columns: Vec<Vec<Id>> = columns.iter().map(|column| times(graph, a, column)).collect();
    (0..n).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

/// Whether something is proven to be zero.
pub(super) fn is_zero(graph: &mut Graph, id: Id) -> bool {
    graph.is_zero(id) || analyze::identity(graph, id).is_zero()
}
