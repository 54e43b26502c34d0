//! x' = g(x), everything else frozen: the equations with a solution in closed form, one rule each.
//!
//! What a rule returns is x at the end of the flow; where the solution has come to a pole before that, it is not a number.

mod quadrature;

use super::polynomial::{Monomial, Polynomial, factors, is_free, power, slope_of_line};
use super::time::{Clock, OverTime, over_time};
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// An equation for one variable.
pub(super) struct Equation {
    pub(super) x: Symbol,
    pub(super) rate: Id,
    pub(super) clock: Clock,
}

/// Where x is at the end of the flow.
pub(super) struct Solution {
    pub(super) end: Id,
    /// ∂end/∂x, which has no sums that cancel where a flow forgets its start, as the derivative of a formula has.
    pub(super) by_start: Id,
}

/// The solutions of one kind of right-hand sides.
type Solve = fn(&mut Graph, &Equation) -> Option<Solution>;

/// In order of preference: the first one that fits is taken.
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
    // a·F(k·x + c), with F one of sin, cos, sinh, tanh, 1/cosh
    quadrature::quadrature,
];

/// x at the end of the flow.
pub(super) fn solve(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    SOLUTIONS.iter().find_map(|solve| solve(graph, equation))
}

impl Equation {
    /// The rate as a sum of powers of x.
    fn powers(&self, graph: &mut Graph) -> Option<Vec<(Ratio, Id)>> {
        let x = self.x;
        let polynomial = Polynomial::of(graph, self.rate, &|symbol| symbol == x)?;
        Some(
            polynomial
                .terms()
                .map(|(monomial, coefficient): (&Monomial, Id)| (power(monomial, x), coefficient))
                .collect(),
        )
    }

    /// What multiplies h in a solution for coefficients that do not depend on time.
    fn steady(&self, graph: &mut Graph, coefficients: &[Id]) -> Option<Id> {
        let steady = coefficients.iter().all(|id| is_free(graph, *id, &|symbol| symbol == Symbol::Time));
        (steady || self.clock == Clock::Stage).then(|| graph.symbol(Symbol::StepLength))
    }
}

fn constant(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let x = equation.x;
    if !is_free(graph, equation.rate, &|symbol| symbol == x) {
        return None;
    }
    let change = equation.clock.over_step(graph, equation.rate)?;
    let x = graph.symbol(x);
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
            let z = graph.mul(a, h);
            let (growth, mean) = growth_and_mean(graph, z);
            let change = graph.mul(z, mean);
            let terms = [grown(graph, x, [z, change]), graph.product(&[b, h, mean])];
            Some(Solution { end: graph.sum(&terms), by_start: growth })
        }
        _ => None,
    }
}

/// exp(∫a dt); (t₀/t₁)^k for a = −k/t.
fn growth(graph: &mut Graph, equation: &Equation, a: Id) -> Option<Id> {
    if equation.clock == Clock::Own
        && let Some(OverTime { k, time }) = over_time(graph, a)
    {
        return Some(match graph.as_number(k) {
            Some(Number::Exact(k)) if k.denominator <= 2 => {
                let ratio = time.ratio(graph);
                graph.pow(ratio, k.mul(Ratio::integer(-1))?)
            }
            _ => {
                let ln = time.ln_ratio(graph);
                let z = graph.mul(k, ln);
                graph.call(Function::Exp, &[z])
            }
        });
    }
    let z = equation.clock.over_step(graph, a)?;
    Some(graph.call(Function::Exp, &[z]))
}

/// x·eᶻ, with eᶻ − 1 at hand.
pub(super) fn grown(graph: &mut Graph, x: Id, [z, change]: [Id; 2]) -> Id {
    let rest = graph.call(Function::Rest, &[z, change]);
    graph.call(Function::Grown, &[x, rest, change])
}

/// eᶻ and φ₁(z). (Not 1 + zφ₁(z), of which nothing is left after a strong decay.)
pub(super) fn growth_and_mean(graph: &mut Graph, z: Id) -> (Id, Id) {
    (graph.call(Function::Exp, &[z]), graph.call(Function::Phi1, &[z]))
}

/// x·E·D^(−1/m) with m = k − 1, E = e^(ah), D = 1 − m·b·xᵐ·h·φ₁(m·a·h).
fn bernoulli(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let powers = equation.powers(graph)?;
    let (linear, other): (Vec<_>, Vec<_>) = powers.into_iter().partition(|(power, _)| *power == Ratio::ONE);
    let [(k, b)] = other[..] else { return None };
    if k.numerator == 0 {
        return None;
    }
    let (x, one) = (graph.symbol(equation.x), graph.integer(1));
    let m = k.add(Ratio::integer(-1))?;
    let (growth, weight) = match linear[..] {
        [] => (one, equation.clock.over_step(graph, b)?),
        [(_, a)] => {
            let h = equation.steady(graph, &[a, b])?;
            let z = graph.mul(a, h);
            let growth = graph.call(Function::Exp, &[z]);
            let z = graph.scale(Number::Exact(m), z);
            let mean = graph.call(Function::Phi1, &[z]);
            (growth, graph.product(&[b, h, mean]))
        }
        _ => return None,
    };
    let power = graph.pow(x, m);
    let change = graph.mul(weight, power);
    let change = graph.scale(Number::Exact(m).neg(), change);
    let d = graph.add(one, change);
    let inverse = m.recip()?.mul(Ratio::integer(-1))?;
    let [shrunk, slope] = [inverse, k.mul(inverse)?].map(|exponent| positive_power(graph, d, exponent));
    let end = graph.product(&[x, growth, shrunk]);
    Some(Solution { end, by_start: graph.mul(growth, slope) })
}

/// A power of what must not be negative.
pub(super) fn positive_power(graph: &mut Graph, base: Id, exponent: Ratio) -> Id {
    let base = graph.call(Function::NotNegative, &[base]);
    if exponent.denominator <= 2 {
        return graph.pow(base, exponent);
    }
    let exponent = graph.number(Number::Exact(exponent));
    graph.call(Function::Powf, &[base, exponent])
}

/// With y = a·x + c, m = k − 1 and u = −m·a·b·h·yᵐ: x + (y/a)·((1 + u)^(−1/m) − 1), also for a = 0.
fn shifted_power(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let own = equation.x;
    let (c, rest) = graph.coefficient(equation.rate);
    let (mut b, mut found) = (graph.number(c), None);
    for (base, exponent) in factors(graph, rest) {
        if !is_free(graph, base, &|symbol| symbol == own) {
            found = Some((base, exponent)).filter(|_| found.is_none());
            found?;
        } else {
            let factor = graph.pow(base, exponent);
            b = graph.mul(b, factor);
        }
    }
    let (y, k) = found.filter(|(_, k)| *k != Ratio::ONE)?;
    let a = slope_of_line(graph, y, own)?;
    equation.steady(graph, &[y])?;
    let m = k.add(Ratio::integer(-1))?;
    let weight = equation.clock.over_step(graph, b)?;
    let power = graph.pow(y, m);
    let relative = graph.mul(weight, power);
    let relative = graph.scale(Number::Exact(m).neg(), relative);
    let u = graph.mul(a, relative);
    let inverse = m.recip()?.mul(Ratio::integer(-1))?;
    let mean = mean_of_power(graph, u, inverse)?;
    let change = graph.product(&[y, relative, mean]);
    let (x, one) = (graph.symbol(own), graph.integer(1));
    let d = graph.add(one, u);
    let by_start = positive_power(graph, d, k.mul(inverse)?);
    Some(Solution { end: graph.add(x, change), by_start })
}

/// ((1 + u)^r − 1)/u without a difference, also for u = 0.
pub(super) fn mean_of_power(graph: &mut Graph, u: Id, r: Ratio) -> Option<Id> {
    let one = graph.integer(1);
    let d = graph.add(one, u);
    let d = graph.call(Function::NotNegative, &[d]);
    if r.denominator > 2 || r.numerator.abs() > 8 {
        let ln = graph.call(Function::Ln1p, &[u]);
        let ln = graph.scale(Number::Exact(r), ln);
        let mean = graph.call(Function::Phi1, &[ln]);
        let mean_of_ln = mean_of_recip(graph, u);
        let mean = graph.mul(mean_of_ln, mean);
        return Some(graph.scale(Number::Exact(r), mean));
    }
    // (dⁿ − 1)/u = 1 + d + … + dⁿ⁻¹.
    let mut mean = graph.zero();
    for _ in 0..r.numerator.abs() {
        let inner = graph.mul(d, mean);
        mean = graph.add(one, inner);
    }
    if r.denominator == 2 {
        let root = graph.pow(d, Ratio { numerator: r.numerator.abs(), ..r });
        let root = graph.add(one, root);
        mean = graph.div(mean, root);
    }
    if r.numerator < 0 {
        let whole = graph.pow(d, r);
        mean = graph.mul(mean, whole);
        mean = graph.neg(mean);
    }
    Some(mean)
}

/// The quotient of the solutions of a linear equation: with ω² = ac − b²/4, C = c₀(ω²h²) and S = h·c₁(ω²h²),
/// (x·(C + S·b/2) + c·S)/(C − S·(a·x + b/2)).
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
    let product = graph.mul(a, c);
    let square = graph.pow(half_b, Ratio::integer(2));
    let square = graph.sub(product, square);
    let (cosine, sine) = rotation(graph, square, h, true);
    let with_c = graph.mul(c, sine);
    let scaled = graph.mul(half_b, sine);
    let grown = graph.add(cosine, scaled);
    let moved = graph.mul(x, grown);
    let above = graph.add(moved, with_c);
    let slope = graph.mul(a, x);
    let slope = graph.add(slope, half_b);
    let slope = graph.mul(slope, sine);
    let below = graph.sub(cosine, slope);
    let below = graph.call(Function::RecipPositive, &[below]);
    let end = graph.mul(above, below);
    Some(Solution { end, by_start: graph.pow(below, Ratio::integer(2)) })
}

/// cos ωh and sin ωh/ω from ω², of either sign; `half` if there is a pole before half a turn.
pub(super) fn rotation(graph: &mut Graph, square: Id, h: Id, half: bool) -> (Id, Id) {
    let h_squared = graph.pow(h, Ratio::integer(2));
    let mut angle = graph.mul(square, h_squared);
    if half {
        let pi = std::f64::consts::PI;
        let bound = graph.number(Number::float(pi * pi));
        angle = graph.call(Function::AtMost, &[angle, bound]);
    }
    let cosine = graph.call(Function::StumpffC0, &[angle]);
    let sine = graph.call(Function::StumpffC1, &[angle]);
    (cosine, graph.mul(h, sine))
}

/// ln(1 + u)/u, or 1.
fn mean_of_recip(graph: &mut Graph, u: Id) -> Id {
    let one = graph.integer(1);
    let end = graph.add(one, u);
    graph.call(Function::LnSlope, &[one, end])
}
