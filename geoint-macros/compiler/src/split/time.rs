//! Time in flows: the exact integral of a rate over a step from t to t + h, if the rate has an elementary antiderivative.

use super::polynomial::{Polynomial, power, reads, slope_of_line};
use super::products::{ScaledPower, Separated, separated};
use crate::diff;
use crate::ir::formula::{call, pow};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// The treatment of time in the flow of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clock {
    /// Exact. `Symbol::Time` is the time at the start of the flow.
    Own,
    /// Frozen. `Symbol::Time` is the time in the middle of the step.
    Stage,
}

impl Clock {
    /// Returns whether time leaves the value of an expression unchanged during a flow with this clock.
    pub(super) fn is_steady(self, graph: &Graph, id: Id) -> bool {
        self == Clock::Stage || !reads(graph, id, Symbol::Time)
    }

    /// Returns the integral of a rate over the flow, or `None` if it has to be exact and is not elementary.
    pub(super) fn over_step(self, graph: &mut Graph, rate: Id) -> Option<Id> {
        if self.is_steady(graph, rate) {
            let h = graph.symbol(Symbol::StepLength);
            return Some(graph.mul(h, rate));
        }
        integral(graph, rate)
    }
}

/// Integrates term by term. Each term is a factor free of t times a power, an exponential, a sine or a cosine of t.
fn integral(graph: &mut Graph, rate: Id) -> Option<Id> {
    if let Node::Linear(constant, terms) = graph.node(rate).clone() {
        let h = graph.symbol(Symbol::StepLength);
        let mut sum = graph.scale(constant, h);
        for (c, term) in terms {
            let term = Clock::Own.over_step(graph, term)?;
            sum = graph.build(sum + c * term);
        }
        return Some(sum);
    }
    let Separated { free, reading } = separated(graph, rate, Symbol::Time);
    if matches!(graph.node(reading), Node::Linear(..)) {
        let whole = integral(graph, reading)?;
        return Some(graph.mul(free, whole));
    }
    let mean = mean_of_wave(graph, reading).or_else(|| mean_of_powers(graph, reading))?;
    let h = graph.symbol(Symbol::StepLength);
    Some(graph.product(&[free, h, mean]))
}

/// Returns the mean of an exponential, a sine or a cosine of a·t + b over the step. The formula holds for a = 0, too.
fn mean_of_wave(graph: &mut Graph, rate: Id) -> Option<Id> {
    let Node::Call(function, args) = graph.node(rate).clone() else { return None };
    let line = Polynomial::of(graph, args[0], &|symbol| symbol == Symbol::Time)?;
    if !line.is_affine() {
        return None;
    }
    let (primitive, sign) = match function {
        Function::Sin => (Function::Cos, Number::MINUS_ONE),
        Function::Cos => (Function::Sin, Number::ONE),
        Function::Exp => (Function::Exp, Number::ONE),
        _ => return None,
    };
    let (rise, h) = (line.coefficient(graph, &[(Symbol::Time, 1)]), graph.symbol(Symbol::StepLength));
    let rise = graph.mul(rise, h);
    let mean = slope(graph, primitive, args[0], rise);
    Some(graph.scale(sign, mean))
}

/// Returns the divided difference (f(a + d) − f(a))/d, which is f'(a) for d = 0.
pub(super) fn slope(graph: &mut Graph, f: Function, a: Id, d: Id) -> Id {
    let t = graph.symbol(Symbol::Time);
    let value = graph.call(f, &[t]);
    let slope = diff::mean_rate(graph, value);
    let ends = |_: &mut Graph, symbol| match symbol {
        Symbol::Time => Some(a),
        Symbol::StepLength => Some(d),
        _ => None,
    };
    Substitution::new(ends).apply(graph, slope)
}

/// Returns the mean of a sum of powers of t over the step.
fn mean_of_powers(graph: &mut Graph, rate: Id) -> Option<Id> {
    let powers = Polynomial::of(graph, rate, &|symbol| symbol == Symbol::Time)?;
    let mut sum = graph.zero();
    for (monomial, coefficient) in powers.into_terms() {
        // Only `ShiftedTime` integrates 1/t, because the exponential of its integral has no singularity at t = 0.
        let next = power(&monomial, Symbol::Time).add(Ratio::ONE).filter(|next| next.numerator != 0)?;
        let singular = next.is_integer() && next.numerator < 0;
        let [t, h] = [Symbol::Time, Symbol::StepLength].map(|symbol| graph.symbol(symbol));
        let size = if singular { next.neg() } else { next };
        let value = graph.pow(t, size);
        let mut mean = diff::mean_rate(graph, value);
        if singular {
            // (t^−m)[a, b] = −(tᵐ)[a, b]/(ab)ᵐ. NaN if the step passes t = 0.
            mean = graph.build(mean * pow(call(Function::RecipPositive, [t * (t + h)]), size));
        }
        sum = graph.build(sum + coefficient * (Number::Exact(size.recip()?) * mean));
    }
    Some(sum)
}

/// A rate k/τ with τ = t₀ + t.
pub(super) struct OverTime {
    pub(super) k: Id,
    pub(super) time: ShiftedTime,
}

/// τ = t₀ + t. Rates k/τ are singular at τ = 0.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct ShiftedTime(Id);

/// Returns k and τ of a rate k/τ. The coefficient of t has to be a number, and k must not read t.
pub(super) fn over_time(graph: &mut Graph, rate: Id) -> Option<OverTime> {
    if let Node::Linear(Number::ZERO, terms) = graph.node(rate).clone()
        && terms.len() > 1
    {
        let (mut sum, mut common) = (graph.zero(), None);
        for (c, term) in terms {
            let OverTime { k, time } = over_time(graph, term)?;
            if *common.get_or_insert(time) != time {
                return None;
            }
            sum = graph.build(sum + c * k);
        }
        return common.map(|time| OverTime { k: sum, time });
    }
    let ScaledPower { coefficient: k, base, exponent } =
        ScaledPower::of(graph, rate, &|symbol| symbol == Symbol::Time)?;
    if exponent != Ratio::integer(-1) {
        return None;
    }
    let slope = slope_of_line(graph, base, Symbol::Time)?;
    graph.as_number(slope).filter(|slope| !slope.is_zero())?;
    Some(OverTime { k: graph.div(k, slope), time: ShiftedTime(graph.div(base, slope)) })
}

impl ShiftedTime {
    /// Returns τ/(τ + h), or NaN if the step passes τ = 0.
    pub(super) fn ratio(self, graph: &mut Graph) -> Id {
        let h = graph.symbol(Symbol::StepLength);
        graph.build(call(Function::NotNegative, [self.0 / (self.0 + h)]))
    }

    /// Returns ln((τ + h)/τ), or NaN if the step passes τ = 0.
    pub(super) fn ln_ratio(self, graph: &mut Graph) -> Id {
        let h = graph.symbol(Symbol::StepLength);
        graph.build(call(Function::Ln1p, [h / self.0]))
    }
}
