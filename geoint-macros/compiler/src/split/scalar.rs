//! Scalar equations x' = g(x) with a solution in closed form. All symbols but x and time are constant.
//!
//! Each rule returns x at the end of the flow. The result is NaN if the solution reaches a pole before the end, or if a power in the formula is
//! undefined at the start. [`Clock`] tells whether coefficients may read time.

mod quadrature;

use super::polynomial::{Polynomial, power, reads, slope_of_line};
use super::products::ScaledPower;
use super::time::{Clock, OverTime, over_time};
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// A differential equation for one variable.
pub(super) struct Equation {
    pub(super) x: Symbol,
    pub(super) rate: Id,
    pub(super) clock: Clock,
}

/// The solution of a scalar equation.
pub(super) struct Solution {
    /// x at the end of the flow.
    pub(super) end: Id,
    /// ∂end/∂x. Unlike the derivative of the formula for `end`, it has no cancelling sums when a flow approaches an attractor.
    pub(super) by_start: Id,
}

/// A rule for one kind of right-hand sides.
type Solve = fn(&mut Graph, &Equation) -> Option<Solution>;

/// The rules in order of preference. The first rule with a solution is used.
const SOLUTIONS: &[Solve] = &[
    // b
    constant,
    // a·x + b
    affine,
    // a·x + b·xᵏ (J. Bernoulli 1695)
    bernoulli,
    // b·(a·x + c)ᵏ
    shifted_power,
    // a·x² + b·x + c (J. Riccati 1724)
    riccati,
    // a + b·exp(k·x)
    quadrature::exponential,
    // a·F(k·x + c) with F one of sin, cos, sinh, tanh, 1/cosh
    quadrature::quadrature,
];

/// Returns the solution by the first rule that applies.
pub(super) fn solve(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    SOLUTIONS.iter().find_map(|solve| solve(graph, equation))
}

impl Equation {
    /// Returns the rate as exponents of x with coefficients.
    fn powers(&self, graph: &mut Graph) -> Option<Vec<(Ratio, Id)>> {
        let x = self.x;
        let polynomial = Polynomial::of(graph, self.rate, &|symbol| symbol == x)?;
        Some(polynomial.into_terms().map(|(monomial, coefficient)| (power(&monomial, x), coefficient)).collect())
    }

    /// Returns h if the coefficients are constant in time. Formulas for constant coefficients multiply them by h.
    fn steady(&self, graph: &mut Graph, coefficients: &[Id]) -> Option<Id> {
        let steady = coefficients.iter().all(|id| self.clock.is_steady(graph, *id));
        steady.then(|| graph.symbol(Symbol::StepLength))
    }
}

/// x + ∫b dt.
fn constant(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    if reads(graph, equation.rate, equation.x) {
        return None;
    }
    let change = equation.clock.over_step(graph, equation.rate)?;
    let x = graph.symbol(equation.x);
    Some(Solution { end: graph.add(x, change), by_start: graph.integer(1) })
}

/// x·e^(ah) + b·h·φ₁(ah).
fn affine(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let powers = equation.powers(graph)?;
    let x = graph.symbol(equation.x);
    match powers[..] {
        [(Ratio::ONE, a)] => {
            let growth = growth(graph, equation, a)?;
            Some(Solution { end: graph.mul(x, growth), by_start: growth })
        }
        [(Ratio::ZERO, b), (Ratio::ONE, a)] => {
            let h = equation.steady(graph, &[a, b])?;
            let z = graph.build(a * h);
            // e^z − 1 = zφ₁(z) is added to x without a rounding of e^z. `grown` takes another way after a strong decay, where the sum cancels.
            let [growth, mean] = [Function::Exp, Function::Phi1].map(|function| graph.call(function, &[z]));
            let change = graph.mul(z, mean);
            let terms = [grown(graph, x, z, change), graph.product(&[b, h, mean])];
            Some(Solution { end: graph.sum(&terms), by_start: growth })
        }
        _ => None,
    }
}

/// exp(∫a dt), which is (τ₀/τ₁)^−k for a = k/τ, where τ₀ and τ₁ are the times at the ends of the step.
fn growth(graph: &mut Graph, equation: &Equation, a: Id) -> Option<Id> {
    if equation.clock == Clock::Own
        && let Some(OverTime { k, time }) = over_time(graph, a)
    {
        return Some(match graph.as_number(k) {
            Some(Number::Exact(k)) if k.denominator <= 2 => {
                let ratio = time.ratio(graph);
                graph.pow(ratio, k.neg())
            }
            _ => {
                let ln = time.ln_ratio(graph);
                graph.build(call(Function::Exp, [k * ln]))
            }
        });
    }
    let z = equation.clock.over_step(graph, a)?;
    Some(graph.call(Function::Exp, &[z]))
}

/// Returns x·eᶻ, computed from `change` = eᶻ − 1. The function `Rest` supplies the digits of eᶻ that 1 + change loses if z is very negative.
pub(super) fn grown(graph: &mut Graph, x: Id, z: Id, change: Id) -> Id {
    graph.build(call(Function::Grown, [x.into(), call(Function::Rest, [z, change]), change.into()]))
}

/// x·E·D^(−1/m) with m = k − 1, E = e^(ah), D = 1 − m·b·xᵐ·h·φ₁(m·a·h).
fn bernoulli(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let powers = equation.powers(graph)?;
    let (linear, other): (Vec<_>, Vec<_>) = powers.into_iter().partition(|(power, _)| *power == Ratio::ONE);
    let [(k, b)] = other[..] else { return None };
    if k.numerator == 0 {
        return None;
    }
    let x = graph.symbol(equation.x);
    let m = k.add(Ratio::integer(-1))?;
    let (growth, weight) = match linear[..] {
        [] => (graph.integer(1), equation.clock.over_step(graph, b)?),
        [(_, a)] => {
            let h = equation.steady(graph, &[a, b])?;
            let growth = graph.build(call(Function::Exp, [a * h]));
            let mean = graph.build(call(Function::Phi1, [Number::Exact(m) * (a * h)]));
            (growth, graph.build(b * h * mean))
        }
        _ => return None,
    };
    let d = graph.build(1 + Number::Exact(m).neg() * (weight * pow(x, m)));
    let inverse = m.recip()?.neg();
    let [shrunk, slope] = [inverse, k.mul(inverse)?].map(|exponent| positive_power(graph, d, exponent));
    let end = graph.product(&[x, growth, shrunk]);
    Some(Solution { end, by_start: graph.mul(growth, slope) })
}

/// Returns a power of `base`, or NaN if `base` is negative.
pub(super) fn positive_power(graph: &mut Graph, base: Id, exponent: Ratio) -> Id {
    let base = graph.call(Function::NotNegative, &[base]);
    if exponent.denominator <= 2 {
        return graph.pow(base, exponent);
    }
    let exponent = graph.number(Number::Exact(exponent));
    graph.call(Function::Powf, &[base, exponent])
}

/// x + (y/a)·((1 + u)^(−1/m) − 1) with y = a·x + c, m = k − 1 and u = −m·a·b·h·yᵐ. The formula holds for a = 0, too.
fn shifted_power(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let x = equation.x;
    let ScaledPower { coefficient: b, base: y, exponent: k } =
        ScaledPower::of(graph, equation.rate, &|symbol| symbol == x).filter(|power| power.exponent != Ratio::ONE)?;
    let a = slope_of_line(graph, y, x)?;
    equation.steady(graph, &[y])?;
    let m = k.add(Ratio::integer(-1))?;
    let weight = equation.clock.over_step(graph, b)?;
    let relative = graph.build(Number::Exact(m).neg() * (weight * pow(y, m)));
    let u = graph.mul(a, relative);
    let inverse = m.recip()?.neg();
    let mean = mean_of_power(graph, u, inverse)?;
    let change = graph.build(y * relative * mean);
    let (x, d) = (graph.symbol(x), graph.build(1 + u));
    let by_start = positive_power(graph, d, k.mul(inverse)?);
    Some(Solution { end: graph.add(x, change), by_start })
}

/// Returns ((1 + u)^r − 1)/u without cancellation. The value at u = 0 is r.
pub(super) fn mean_of_power(graph: &mut Graph, u: Id, r: Ratio) -> Option<Id> {
    let d = graph.build(call(Function::NotNegative, [1 + u]));
    // Short sums of products are faster than exp and ln.
    if r.denominator > 2 || r.numerator.abs() > 8 {
        let mean = graph.build(call(Function::Phi1, [Number::Exact(r) * call(Function::Ln1p, [u])]));
        let mean_of_ln = mean_of_recip(graph, u);
        return Some(graph.build(Number::Exact(r) * (mean_of_ln * mean)));
    }
    // With n = |numerator|: (d^(n/2) − 1)(d^(n/2) + 1) = dⁿ − 1, and d^−|r| − 1 = −d^−|r| (d^|r| − 1).
    let mut mean = geometric_sum(graph, d, r.numerator.abs());
    if r.denominator == 2 {
        mean = graph.build(mean / (1 + pow(d, Ratio { numerator: r.numerator.abs(), ..r })));
    }
    if r.numerator < 0 {
        mean = graph.build(-(mean * pow(d, r)));
    }
    Some(mean)
}

/// Returns 1 + d + … + dⁿ⁻¹ = (dⁿ − 1)/(d − 1) by Horner's rule.
pub(super) fn geometric_sum(graph: &mut Graph, d: Id, n: i128) -> Id {
    let zero = graph.zero();
    (0..n).fold(zero, |sum, _| graph.build(1 + d * sum))
}

/// (x·(C + S·b/2) + c·S)/(C − S·(a·x + b/2)), the quotient of the solutions of a linear equation, with ω² = ac − b²/4, C = cos ωh,
/// S = sin ωh/ω.
fn riccati(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let powers = equation.powers(graph)?;
    if powers.iter().any(|(power, _)| !power.is_integer() || !(0..=2).contains(&power.numerator)) {
        return None;
    }
    let [c, b, a] = [0, 1, 2].map(|k| {
        let found = powers.iter().find(|(power, _)| *power == Ratio::integer(k));
        found.map_or_else(|| graph.zero(), |(_, coefficient)| *coefficient)
    });
    let h = equation.steady(graph, &[a, b, c])?;
    let x = graph.symbol(equation.x);
    let half_b = graph.scale(Number::HALF, b);
    let square = graph.build(a * c - squared(half_b));
    let (cosine, sine) = rotation(graph, square, h, Angle::BelowHalfTurn);
    let with_c = graph.mul(c, sine);
    let above = graph.build(x * (cosine + half_b * sine) + with_c);
    let below = graph.build(call(Function::RecipPositive, [cosine - (a * x + half_b) * sine]));
    // A Möbius map with determinant 1 has the derivative 1/denominator².
    Some(Solution { end: graph.build(above * below), by_start: graph.build(squared(below)) })
}

/// The angles ωh for which a solution with cos ωh and sin ωh is valid.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Angle {
    Any,
    /// The solution has a pole before half a turn. The flow is NaN beyond half a turn.
    BelowHalfTurn,
}

/// Returns cos ωh and sin ωh/ω for ω² of either sign.
pub(super) fn rotation(graph: &mut Graph, omega_squared: Id, h: Id, valid: Angle) -> (Id, Id) {
    let mut angle_squared = graph.build(omega_squared * squared(h));
    if valid == Angle::BelowHalfTurn {
        let pi = std::f64::consts::PI;
        let bound = graph.number(Number::float(pi * pi));
        angle_squared = graph.call(Function::AtMost, &[angle_squared, bound]);
    }
    let cosine = graph.call(Function::StumpffC0, &[angle_squared]);
    (cosine, graph.build(h * call(Function::StumpffC1, [angle_squared])))
}

/// Returns ln(1 + u)/u, which is 1 for u = 0.
fn mean_of_recip(graph: &mut Graph, u: Id) -> Id {
    graph.build(call(Function::LnSlope, [1.into(), 1 + u]))
}
