//! Linear fields x' = g·(Mx + b) with M³ = −κM and M²b = −κb. The scalar factor g is constant along the flow.
//!
//! With τ = gh and ω² = κ, the flow is x₁ = x + s·(cos(ωτ/2)·(Mx + b) + s/2·M(Mx + b)), s = 2 sin(ωτ/2)/ω. Examples are parabolas,
//! and rotations, shears and hyperbolic rotations about any axis and any centre.

use super::super::polynomial::is_free;
use super::super::products::{factors, matrix_product, times_factors};
use super::super::scalar::{Angle, rotation};
use super::Rule;
use crate::analyze;
use crate::diff;
use crate::diff::equations::times;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

pub(super) const LINEAR: Rule =
    Rule { name: "linear field", fields: "x' = g·(Mx + b), M³ = −κM, M²b = −κb, g constant along the flow" };

/// Returns the end of the flow, if the field is of this kind.
pub(super) fn ends(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Option<Vec<(Symbol, Id)>> {
    let symbols: Vec<Symbol> = rates.iter().map(|(symbol, _)| *symbol).collect();
    let moves = |symbol: Symbol| symbols.contains(&symbol);
    let Scaled { g, velocity } = without_common_factor(graph, rates, &moves);
    let matrix = diff::jacobian(graph, &velocity, &symbols);
    // Derivatives do not show that the field changes at a condition.
    let conditions: Vec<Id> = velocity.iter().flat_map(|v| analyze::conditions(graph, *v)).collect();
    if !matrix.iter().flatten().chain(&conditions).all(|id| is_free(graph, *id, &moves)) {
        return None;
    }
    // g must be constant along Mx + b.
    let slopes = diff::jacobian(graph, &[g], &symbols);
    let change = times(graph, &slopes, &velocity)[0];
    let may_jump = analyze::crossings::may_jump(graph, &symbols, &velocity, g).is_some();
    if !is_zero(graph, change) || may_jump || !analyze::turning_terms(graph, g).is_empty() {
        return None;
    }
    let h = graph.symbol(Symbol::StepLength);
    let tau = graph.mul(g, h);
    let x: Vec<Id> = symbols.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let ends = plane_rotation(graph, &matrix, &velocity, &x, tau).or_else(|| {
        let constant = constant_part(graph, &velocity, &moves);
        space_rotation(graph, &matrix, &constant, &velocity, &x, tau)
    })?;
    Some(symbols.into_iter().zip(ends).collect())
}

/// Returns the end of the flow, if M³ = −κM and M²b = −κb. `constant` is b, and `velocity` is Mx + b.
fn space_rotation(
    graph: &mut Graph,
    matrix: &[Vec<Id>],
    constant: &[Id],
    velocity: &[Id],
    x: &[Id],
    tau: Id,
) -> Option<Vec<Id>> {
    let square = matrix_product(graph, matrix, matrix);
    let cube = matrix_product(graph, &square, matrix);
    let trace: Vec<Id> = (0..x.len()).map(|i| square[i][i]).collect();
    let trace = graph.sum(&trace);
    let kappa = graph.scale(Number::HALF.neg(), trace);
    let pushed = times(graph, &square, constant);
    for (third, first) in cube.iter().flatten().zip(matrix.iter().flatten()).chain(pushed.iter().zip(constant)) {
        let sum = graph.build(*third + kappa * *first);
        if !is_zero(graph, sum) {
            return None;
        }
    }
    let acceleration = times(graph, matrix, velocity);
    // cos ωτ/2 and s = 2 sin(ωτ/2)/ω.
    let (cosine, sine) = if is_zero(graph, kappa) {
        (graph.integer(1), tau)
    } else {
        let quarter = graph.scale(Number::Exact(Ratio::integer(4).recip()?), kappa);
        rotation(graph, quarter, tau, Angle::Any)
    };
    let half_sine = graph.scale(Number::HALF, sine);
    let mut ends = vec![];
    for ((x, v), a) in x.iter().zip(velocity).zip(&acceleration) {
        let terms = [graph.mul(cosine, *v), graph.mul(half_sine, *a)];
        ends.push(moved_along(graph, *x, sine, &terms));
    }
    Some(ends)
}

/// Returns the end of x' = m·y, y' = −m·x by sine and cosine of the angle m·τ.
fn plane_rotation(graph: &mut Graph, matrix: &[Vec<Id>], velocity: &[Id], x: &[Id], tau: Id) -> Option<Vec<Id>> {
    let [first, second] = matrix else { return None };
    let ([a, m], [minus, d]) = (<[Id; 2]>::try_from(&first[..]).ok()?, <[Id; 2]>::try_from(&second[..]).ok()?);
    let sum = graph.add(m, minus);
    let turns = [a, d, sum].into_iter().all(|entry| graph.is_zero(entry));
    if !turns || velocity != [graph.mul(m, x[1]), graph.mul(minus, x[0])] {
        return None;
    }
    let angle = graph.mul(m, tau);
    let back = graph.neg(x[0]);
    let all = [[x[0], x[1]], [x[1], back]];
    let turned =
        |graph: &mut Graph, angle: Id| [Function::Cos, Function::Sin].map(|function| graph.call(function, &[angle]));
    // If the angle is constant, `increment::steady` writes the ends as increments later.
    if !graph.reads(angle).state() {
        let weights = turned(graph, angle);
        return Some(all.map(|pair| graph.dot(&weights, &pair)).to_vec());
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

/// Returns x + c·Σ terms. The small terms are summed before x is added. Separate additions to x, or a rounded cosine, would repeat the same
/// rounding error in many steps, and the invariants of the flow would drift.
fn moved_along(graph: &mut Graph, x: Id, c: Id, terms: &[Id]) -> Id {
    let sum = graph.sum(terms);
    graph.build(x + c * sum)
}

/// A field g·velocity.
struct Scaled {
    g: Id,
    velocity: Vec<Id>,
}

/// Moves the factors that all rates share into g, if they read coordinates that move.
fn without_common_factor(graph: &mut Graph, rates: &[(Symbol, Id)], moves: &impl Fn(Symbol) -> bool) -> Scaled {
    let split: Vec<(Number, Vec<(Id, Ratio)>)> = rates
        .iter()
        .map(|(_, rate)| {
            let (c, rest) = graph.coefficient(*rate);
            (c, factors(graph, rest))
        })
        .collect();
    let mut common = split.first().map(|(_, factors)| factors.clone()).unwrap_or_default();
    common
        .retain(|factor| !is_free(graph, factor.0, moves) && split.iter().all(|(_, factors)| factors.contains(factor)));
    let one = graph.integer(1);
    let g = times_factors(graph, one, common.iter().copied());
    let without = |(c, factors): (Number, Vec<(Id, Ratio)>)| {
        let c = graph.number(c);
        times_factors(graph, c, factors.into_iter().filter(|factor| !common.contains(factor)))
    };
    Scaled { g, velocity: split.into_iter().map(without).collect() }
}

/// Returns the velocities at the point where all coordinates that move are zero.
fn constant_part(graph: &mut Graph, velocity: &[Id], moves: &impl Fn(Symbol) -> bool) -> Vec<Id> {
    let mut at_zero = Substitution::new(|graph: &mut Graph, symbol| moves(symbol).then(|| graph.zero()));
    velocity.iter().map(|v| at_zero.apply(graph, *v)).collect()
}

/// Returns whether an expression is proven to be zero.
pub(super) fn is_zero(graph: &mut Graph, id: Id) -> bool {
    graph.is_zero(id) || analyze::identity(graph, id).is_zero()
}
