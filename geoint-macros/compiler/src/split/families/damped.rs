//! Family "damped drift", and kicks with damping. The damping is a term g·s.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, degree, is_free, is_linear, is_momentum, times_powers};
use super::super::scalar::grown;
use super::super::time::{OverTime, over_time};
use crate::diff;
use crate::ir::formula::call;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// An energy T(p) + g s. T is homogeneous of degree 2. Its coefficients and g do not read coordinates.
struct DampedDrift {
    kinetic: Id,
    g: Id,
}

impl DampedDrift {
    fn of(graph: &mut Graph, group: &Group) -> Option<DampedDrift> {
        let powers = Polynomial::of(graph, group.energy, &|symbol| is_momentum(symbol) || symbol == Symbol::Action)?;
        let g = powers.coefficient(graph, &[(Symbol::Action, 1)]);
        let mut kinetic = graph.zero();
        for (monomial, coefficient) in powers.into_terms() {
            if !is_free(graph, coefficient, &Symbol::is_coordinate) {
                return None;
            }
            if is_linear(&monomial) && monomial.contains_key(&Symbol::Action) {
                continue;
            }
            let integers = monomial.iter().all(|(symbol, power)| is_momentum(*symbol) && power.is_integer());
            if !integers || degree(&monomial)? != Ratio::integer(2) {
                return None;
            }
            let term = times_powers(graph, coefficient, &monomial);
            kinetic = graph.add(kinetic, term);
        }
        (!graph.is_zero(g) && !graph.is_zero(kinetic)).then_some(DampedDrift { kinetic, g })
    }
}

/// Returns the flow of p·Wp/2 + g s. With E = exp(−∫g dt) and w = ∫E dt: q grows by w·Wp, P = E p, S = E (s + w T).
pub(in super::super) fn drift(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let DampedDrift { kinetic, g } = DampedDrift::of(graph, group)?;
    if !group.clock.is_steady(graph, kinetic) {
        return None;
    }
    let decay = if group.clock.is_steady(graph, g) { Decay::constant(graph, g) } else { Decay::over_time(graph, g)? };
    let mut flow = Flow::rest(graph, group.degrees);
    let velocity = diff::gradient(graph, kinetic, group.degrees).p;
    for (q, velocity) in flow.q.iter_mut().zip(velocity) {
        *q = graph.build(*q + decay.integral * velocity);
    }
    for p in &mut flow.p {
        *p = decay.of(graph, *p);
    }
    let moved = graph.build(flow.s + decay.integral * kinetic);
    flow.s = decay.of(graph, moved);
    Some(flow)
}

/// The decay E = exp(−∫g dt) over a step.
struct Decay {
    factor: Factor,
    /// w = ∫E dt.
    integral: Id,
}

/// The factor E of a decay.
enum Factor {
    /// eᶻ, given by z and `change` = eᶻ − 1.
    Exponential { z: Id, change: Id },
    /// E itself.
    Plain(Id),
}

impl Decay {
    /// Returns the decay for constant g: E = e^(−gh), w = h·φ₁(−gh).
    fn constant(graph: &mut Graph, g: Id) -> Decay {
        let h = graph.symbol(Symbol::StepLength);
        let z = graph.build(-(g * h));
        let mean = graph.call(Function::Phi1, &[z]);
        let change = graph.mul(z, mean);
        Decay { factor: Factor::Exponential { z, change }, integral: graph.mul(h, mean) }
    }

    /// Returns the decay for g = k/τ with τ = t₀ + t. With r the ratio of τ at the start to τ at the end: E = rᵏ and
    /// w = h (r − rᵏ)/((k − 1)(1 − r)).
    ///
    /// For an integer k ≥ 2, w = h (r + r² + … + rᵏ⁻¹)/(k − 1). Both forms are regular at τ = 0.
    fn over_time(graph: &mut Graph, g: Id) -> Option<Decay> {
        let OverTime { k, time } = over_time(graph, g)?;
        let (ratio, h) = (time.ratio(graph), graph.symbol(Symbol::StepLength));
        let k = match graph.as_number(k) {
            Some(Number::Exact(k)) if k.is_integer() && (2..=16).contains(&k.numerator) => k,
            _ => {
                let ln = time.ln_ratio(graph);
                let z = graph.build(-(k * ln));
                let change = graph.call(Function::ExpM1, &[z]);
                let integral = graph.build(h * call(Function::DecayMean, [ratio, k]));
                return Some(Decay { factor: Factor::Exponential { z, change }, integral });
            }
        };
        // Horner's rule.
        let mut sum = graph.zero();
        for _ in 1..k.numerator {
            sum = graph.build(ratio * (1 + sum));
        }
        let mean = graph.scale(Number::Exact(Ratio::integer(k.numerator - 1).recip()?), sum);
        Some(Decay { factor: Factor::Plain(graph.pow(ratio, k)), integral: graph.mul(h, mean) })
    }

    /// Returns E·x.
    fn of(&self, graph: &mut Graph, x: Id) -> Id {
        match self.factor {
            Factor::Exponential { z, change } => grown(graph, x, z, change),
            Factor::Plain(factor) => graph.mul(factor, x),
        }
    }
}

/// Returns the flow of V(q) + g s at frozen time: q is constant, P = E p − w ∂V/∂q, S = E s − w V with E and w of [`Decay`].
pub(in super::super) fn kick(graph: &mut Graph, potential: Id, g: Id, degrees: u32) -> Flow {
    let decay = Decay::constant(graph, g);
    let mut flow = Flow::rest(graph, degrees);
    // The derivatives of −wV combine w with the constants of each term, so that the products are computed once for each h.
    let gain = graph.build(-(decay.integral * potential));
    let impulses = diff::gradient(graph, gain, degrees).q;
    for (p, impulse) in flow.p.iter_mut().zip(impulses) {
        let kept = decay.of(graph, *p);
        *p = graph.add(kept, impulse);
    }
    let kept = decay.of(graph, flow.s);
    flow.s = graph.add(kept, gain);
    flow
}
