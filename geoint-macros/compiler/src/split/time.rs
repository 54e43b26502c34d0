//! ∫ f dt over a step from t to t + h, where f has an elementary antiderivative.

use super::polynomial::{Polynomial, factors, is_free, power, slope_of_line};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// How time is dealt with in the flow of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clock {
    /// Exactly: t is where the flow begins.
    Own,
    /// Frozen: t is the middle of the step.
    Stage,
}

impl Clock {
    /// The integral of a rate over the flow; `None` if that has to be exact and is not elementary.
    pub(super) fn over_step(self, graph: &mut Graph, rate: Id) -> Option<Id> {
        if self == Clock::Stage || is_free(graph, rate, &|symbol| symbol == Symbol::Time) {
            let h = graph.symbol(Symbol::StepLength);
            return Some(graph.mul(h, rate));
        }
        integral(graph, rate)
    }
}

/// Σ over terms: what does not depend on t, times the integral of a power, an exponential, a sine or a cosine of t.
fn integral(graph: &mut Graph, rate: Id) -> Option<Id> {
    if let Node::Linear(constant, terms) = graph.node(rate).clone() {
        let h = graph.symbol(Symbol::StepLength);
        let mut sum = graph.scale(constant, h);
        for (c, term) in terms {
            let term = Clock::Own.over_step(graph, term)?;
            let term = graph.scale(c, term);
            sum = graph.add(sum, term);
        }
        return Some(sum);
    }
    let reads_t = |symbol| symbol == Symbol::Time;
    let (mut constant, mut changing) = (graph.integer(1), graph.integer(1));
    for (base, exponent) in factors(graph, rate) {
        let factor = graph.pow(base, exponent);
        let side = if is_free(graph, factor, &reads_t) { &mut constant } else { &mut changing };
        *side = graph.mul(*side, factor);
    }
    if matches!(graph.node(changing), Node::Linear(..)) {
        let whole = integral(graph, changing)?;
        return Some(graph.mul(constant, whole));
    }
    let mean = waves(graph, changing).or_else(|| powers(graph, changing))?;
    let h = graph.symbol(Symbol::StepLength);
    Some(graph.product(&[constant, h, mean]))
}

/// The mean of an exponential, a sine or a cosine of a·t + b, whether a is zero or not.
fn waves(graph: &mut Graph, rate: Id) -> Option<Id> {
    let reads_t = |symbol| symbol == Symbol::Time;
    let Node::Call(function, args) = graph.node(rate).clone() else { return None };
    let line = Polynomial::of(graph, args[0], &reads_t)?;
    if !line.has_only(|monomial| [Ratio::ZERO, Ratio::ONE].contains(&power(monomial, Symbol::Time))) {
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

/// (f(a + d) − f(a))/d, or f'(a).
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

/// The mean of a sum of powers of t.
fn powers(graph: &mut Graph, rate: Id) -> Option<Id> {
    let powers = Polynomial::of(graph, rate, &|symbol| symbol == Symbol::Time)?;
    let mut sum = graph.zero();
    for (exponent, coefficient) in powers.terms().map(|(m, c)| (power(m, Symbol::Time), c)).collect::<Vec<_>>() {
        // 1/t is dealt with where it appears: its exponential has no singularity at t = 0.
        let next = exponent.add(Ratio::ONE).filter(|next| next.numerator != 0)?;
        let singular = next.is_integer() && next.numerator < 0;
        let [t, h] = [Symbol::Time, Symbol::StepLength].map(|symbol| graph.symbol(symbol));
        let size = if singular { next.mul(Ratio::integer(-1))? } else { next };
        let value = graph.pow(t, size);
        let mut mean = diff::mean_rate(graph, value);
        if singular {
            // Not across t = 0: (t^−m)[a, b] is −(tᵐ)[a, b]/(ab)ᵐ.
            let end = graph.add(t, h);
            let product = graph.mul(t, end);
            let reciprocal = graph.call(Function::RecipPositive, &[product]);
            let reciprocal = graph.pow(reciprocal, size);
            mean = graph.mul(mean, reciprocal);
        }
        let mean = graph.scale(Number::Exact(size.recip()?), mean);
        let mean = graph.mul(coefficient, mean);
        sum = graph.add(sum, mean);
    }
    Some(sum)
}

/// A rate k/τ with τ = t₀ + t.
pub(super) struct OverTime {
    pub(super) k: Id,
    pub(super) time: ShiftedTime,
}

/// τ = t₀ + t, which is singular where it is zero.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct ShiftedTime(Id);

/// k and τ where a rate is k/τ: with a number before t, and whatever else is free of time.
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
            let k = graph.scale(c, k);
            sum = graph.add(sum, k);
        }
        return common.map(|time| OverTime { k: sum, time });
    }
    let (c, rest) = graph.coefficient(rate);
    let (mut k, mut found) = (graph.number(c), None);
    for (base, exponent) in factors(graph, rest) {
        if is_free(graph, base, &|symbol| symbol == Symbol::Time) {
            let factor = graph.pow(base, exponent);
            k = graph.mul(k, factor);
        } else if exponent == Ratio::integer(-1) && found.is_none() {
            found = Some(base);
        } else {
            return None;
        }
    }
    let base = found?;
    let slope = slope_of_line(graph, base, Symbol::Time)?;
    graph.as_number(slope).filter(|slope| !slope.is_zero())?;
    Some(OverTime { k: graph.div(k, slope), time: ShiftedTime(graph.div(base, slope)) })
}

impl ShiftedTime {
    /// τ/(τ + h); not a number if the singular time lies between both.
    pub(super) fn ratio(self, graph: &mut Graph) -> Id {
        let h = graph.symbol(Symbol::StepLength);
        let end = graph.add(self.0, h);
        let ratio = graph.div(self.0, end);
        graph.call(Function::NotNegative, &[ratio])
    }

    /// ln((τ + h)/τ); not a number if the singular time lies between both.
    pub(super) fn ln_ratio(self, graph: &mut Graph) -> Id {
        let h = graph.symbol(Symbol::StepLength);
        let relative = graph.div(h, self.0);
        graph.call(Function::Ln1p, &[relative])
    }
}
