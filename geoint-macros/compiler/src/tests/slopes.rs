//! Compares the divided differences of all functions with quotients of hundreds of digits. The ranges of the functions are an exhaustive match, so a
//! new function needs an entry.

use super::fuzz::config;
use super::precise::{self, Big, big};
use super::{Noise, graph_of};
use crate::diff;
use crate::ir::of_steps;
use crate::ir::op::FUNCTIONS;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};
use crate::tests::eval::eval;

const Q: Symbol = Symbol::Position(0);
const DQ: Symbol = Symbol::PositionIncrement(0);
/// Enough for differences of third order with gaps of 2⁻⁸⁰.
const BITS: usize = 450;

/// Cancellation in the derivative of a slope.
#[derive(Clone, Copy, PartialEq)]
enum Parts {
    /// The parts of the derivative do not cancel.
    Alike,
    /// The parts cancel, so that the derivative is accurate relative to the slope only.
    Unlike,
}

/// The interval of test points of a function.
pub(super) struct Range {
    low: f64,
    high: f64,
    parts: Parts,
}

const fn within(low: f64, high: f64) -> Range {
    Range { low, high, parts: Parts::Alike }
}

pub(super) const fn around_zero(size: f64) -> Range {
    within(-size, size)
}

impl Range {
    const fn of_unlike_parts(self) -> Range {
        Range { parts: Parts::Unlike, ..self }
    }

    /// Returns a random number of any magnitude in the range.
    fn draw(&self, noise: &mut Noise) -> f64 {
        let sign = noise.between(-1.0, 1.0).signum();
        if self.low > 0.0 {
            noise.between(self.low.ln(), self.high.ln()).exp()
        } else if self.low == -self.high && noise.between(0.0, 3.0) < 1.0 {
            self.high * noise.between(-20.0, 0.0).exp() * sign
        } else {
            noise.between(self.low, self.high)
        }
    }

    /// Returns two ends: distant, equal, adjacent, or at a random distance.
    fn pair(&self, kind: usize, noise: &mut Noise) -> (f64, f64) {
        let a = self.draw(noise);
        let b = match kind % 5 {
            0 => self.draw(noise),
            1 => a,
            2 => a.next_up(),
            _ => a * (1.0 + 10_f64.powf(-noise.between(0.3, 16.5)) * noise.between(-1.0, 1.0).signum()),
        };
        if (self.low..=self.high).contains(&b) { (a, b) } else { self.pair(kind, noise) }
    }
}

/// Returns the ranges of the arguments that vary. A constant replaces the other argument.
fn ranges(function: Function) -> Vec<Range> {
    match function {
        Function::Sin | Function::Cos | Function::Abs | Function::Signum => vec![around_zero(10.0)],
        Function::Tan => vec![around_zero(1.5)],
        Function::Asin | Function::Acos => vec![around_zero(0.999_999).of_unlike_parts()],
        Function::Atan => vec![around_zero(50.0)],
        Function::Atan2 => vec![around_zero(5.0), around_zero(5.0)],
        Function::Sinh | Function::Cosh | Function::Tanh => vec![around_zero(20.0)],
        Function::Asinh => vec![around_zero(1e3)],
        Function::Acosh => vec![within(1.000_001, 1e3)],
        Function::Atanh => vec![around_zero(0.999_99).of_unlike_parts()],
        Function::Exp | Function::Exp2 | Function::ExpM1 => vec![around_zero(30.0)],
        Function::Ln | Function::Log2 | Function::Log10 => vec![within(1e-6, 1e6)],
        Function::Ln1p => vec![within(-0.9, 50.0)],
        Function::Cbrt => vec![around_zero(100.0)],
        Function::Hypot => vec![around_zero(50.0).of_unlike_parts(), around_zero(50.0).of_unlike_parts()],
        // The exponents are listed below.
        Function::Powf => vec![within(1e-3, 1e3), around_zero(5.0)],
        Function::Min | Function::Max => vec![around_zero(2.0), around_zero(2.0)],
        Function::NotNegative | Function::Bounded | Function::RecipPositive | Function::Provided | of_steps!() => {
            vec![]
        }
    }
}

/// A function of q, and its derivatives and slopes.
pub(super) struct Case {
    name: String,
    range: Range,
    graph: Graph,
    pub(super) value: Id,
    pub(super) derivative: Id,
    pub(super) slope: Id,
    /// The derivative of the slope with respect to its second end.
    pub(super) second: Id,
}

impl Case {
    pub(super) fn new(name: String, range: Range, build: impl FnOnce(&mut Graph, Id) -> Id) -> Case {
        let (mut graph, q) = graph_of(Q);
        let value = build(&mut graph, q);
        let derivative = diff::gradient(&mut graph, value, 1).q[0];
        let slope = diff::discrete_gradient(&mut graph, value, 1).q[0];
        let second = diff::jacobian(&mut graph, &[slope], &[DQ])[0][0];
        Case { name, range, graph, value, derivative, slope, second }
    }

    /// Returns the value of a node for a step of length d from a.
    pub(super) fn at(&self, id: Id, a: f64, d: f64) -> f64 {
        eval(&self.graph, id, &|symbol| if symbol == DQ { d } else { a })
    }
}

fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for entry in FUNCTIONS {
        for (place, range) in ranges(entry.function).into_iter().enumerate() {
            cases.push(Case::new(format!("{}, argument {place}", entry.name), range, |graph, q| {
                let mut args = vec![graph.number(Number::float(0.75)); entry.arity];
                args[place] = q;
                graph.call(entry.function, &args)
            }));
        }
    }
    for exponent in [-2.3, -0.1, 0.3, 1.7, 12.3, 1.01] {
        let range = within(1e-3, 1e3);
        // The second derivative nearly vanishes.
        let range = if exponent == 1.01 { range.of_unlike_parts() } else { range };
        cases.push(Case::new(format!("powf({exponent})"), range, |graph, q| {
            let exponent = graph.number(Number::float(exponent));
            graph.call(Function::Powf, &[q, exponent])
        }));
    }
    for n in (-7..=7).filter(|n| *n != 0) {
        cases.push(Case::new(
            format!("the power {n}"),
            if n > 0 { around_zero(10.0) } else { within(1e-3, 1e3) },
            |graph, q| graph.pow(q, Ratio::integer(n)),
        ));
    }
    for n in (-7..=7).filter(|n| n % 2 != 0) {
        let range = within(1e-3, 1e3);
        let range = if n > 1 { range.of_unlike_parts() } else { range };
        let exponent = Ratio { numerator: n, denominator: 2 };
        cases.push(Case::new(format!("the power {n}/2"), range, |graph, q| graph.pow(q, exponent)));
    }
    cases
}

/// Returns the divided difference of points with values.
fn divided(points: &[(Big, Big)]) -> Big {
    let mut table: Vec<Big> = points.iter().map(|(_, value)| value.clone()).collect();
    for order in 1..points.len() {
        for i in 0..points.len() - order {
            table[i] = (&table[i + 1] - &table[i]) / (&points[i + order].0 - &points[i].0);
        }
    }
    table.swap_remove(0)
}

/// f[a, b] and f[a, b, b] for b = a + d, with their conditions: the change for a relative change of a and b.
struct Exact {
    first: Big,
    first_scale: f64,
    second: Big,
    second_scale: f64,
}

fn exact(case: &Case, a: f64, d: f64) -> Exact {
    let [low, high] = [big(a, BITS), big(a, BITS) + big(d, BITS)];
    let gap = |x: &Big| x * big(2_f64.powi(-80), BITS);
    // Equal points are drawn apart, below a and above b. Both may be zero.
    let [below, above] = [&low, &high].map(|x| if x.to_f64().value() < 0.0 { -gap(x) } else { gap(x) });
    let f = |x: Big| {
        let value = precise::value(&case.graph, case.value, BITS, &|_| x.clone()).expect("a value");
        (x, value)
    };
    let points = [&low - &below - &below, &low - &below, high.clone(), &high + &above, &high + &above + &above].map(f);
    let size = |x: Big| x.to_f64().value().abs();
    let (first, second) = (divided(&points[1..3]), divided(&points[1..4]));
    let [by_a, by_aa, by_bb] = [&points[0..3], &points[0..4], &points[1..5]].map(|points| size(divided(points)));
    let (a, b) = (a.abs(), (a + d).abs());
    let first_scale = size(first.clone()) + a * by_a + b * size(second.clone());
    let mut second_scale = size(second.clone()) + a * by_aa + 2.0 * b * by_bb;
    if case.range.parts == Parts::Unlike {
        second_scale += size(first.clone()) / b;
    }
    Exact { first, first_scale, second, second_scale }
}

/// f[a, b] is accurate to 3 ε and f[a, b, b] to 30 ε, relative to their conditions. If both ends meet, the slope is the derivative.
#[test]
fn slopes_and_their_derivatives_are_accurate() {
    let mut noise = Noise(11);
    let pairs = config().cases as usize / 6;
    for case in cases() {
        for kind in 0..pairs {
            let (a, b) = case.range.pair(kind, &mut noise);
            let d = b - a;
            let exact = exact(&case, a, d);
            let error = |found: f64, exact: &Big, scale: f64| {
                assert!(found.is_finite(), "{} between {a:e} and {b:e}: {found}", case.name);
                let difference = (big(found, BITS) - exact).to_f64().value().abs();
                if difference == 0.0 { 0.0 } else { difference / scale / f64::EPSILON }
            };
            let first = error(case.at(case.slope, a, d), &exact.first, exact.first_scale);
            let second = error(case.at(case.second, a, d), &exact.second, exact.second_scale);
            let bound = if case.name.starts_with("sin,") || case.name.starts_with("cos,") { 2.0 } else { 3.0 };
            assert!(first <= bound, "{} between {a:e} and {b:e}: {first:.1} ε", case.name);
            assert!(second <= 30.0, "the derivative of {} between {a:e} and {b:e}: {second:.1} ε", case.name);
            if d == 0.0 {
                let derivative = big(case.at(case.derivative, a, d), BITS);
                let met = error(case.at(case.slope, a, d), &derivative, exact.first_scale);
                assert!(met <= 2.0, "{} at {a:e}: {met:.1} ε from its derivative", case.name);
            }
        }
    }
}

/// The control: the difference quotient of two values misses the bounds by far.
#[test]
fn a_quotient_is_not_accurate() {
    for case in cases().iter().filter(|case| case.name.starts_with("exp,") || case.name.starts_with("atanh")) {
        let (a, d) = (0.3, 1e-9);
        let exact = exact(case, a, d);
        let quotient = (case.at(case.value, a + d, 0.0) - case.at(case.value, a, 0.0)) / d;
        let error = (big(quotient, BITS) - exact.first).to_f64().value().abs();
        assert!(error > 1e6 * exact.first_scale * f64::EPSILON, "{}", case.name);
    }
}

/// Slopes are symmetric to the last bit if start, increment and end are exact. (An exponent q·ln c is rounded.)
#[test]
fn slopes_are_symmetric() {
    let mut noise = Noise(5);
    for case in cases().iter().filter(|case| case.name != "powf, argument 1") {
        let Range { low, high, .. } = case.range;
        for _ in 0..20 {
            let mut draw = || (noise.between(low.max(-30.0), high.min(30.0)) * 1024.0).round() / 1024.0;
            let (a, b) = (draw(), draw());
            if [a, b].iter().all(|x| (low..=high).contains(x)) {
                let (there, back) = (case.at(case.slope, a, b - a), case.at(case.slope, b, a - b));
                assert!(there == back, "{} between {a} and {b}: {there:e} and {back:e}", case.name);
            }
        }
    }
}
