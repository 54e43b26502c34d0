//! Damping g·s together with a drift or a kick.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, degree, is_free, is_momentum, times_powers};
use super::super::scalar::grown;
use super::super::time::{Clock, OverTime, over_time};
use crate::diff;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// T(p) with T homogeneous of degree 2 and coefficients that are free of phase space, and g.
fn damped_parts(graph: &mut Graph, group: &Group) -> Option<(Id, Id)> {
    let powers = Polynomial::of(graph, group.energy, &|symbol| is_momentum(symbol) || symbol == Symbol::Action)?;
    let g = powers.coefficient(graph, &[(Symbol::Action, 1)]);
    let mut kinetic = graph.zero();
    for (monomial, coefficient) in powers.into_terms() {
        if !is_free(graph, coefficient, &Symbol::is_coordinate) {
            return None;
        }
        if monomial.keys().eq([&Symbol::Action]) && monomial.values().eq([&Ratio::ONE]) {
            continue;
        }
        let whole = monomial.iter().all(|(symbol, power)| is_momentum(*symbol) && power.is_integer());
        if !whole || degree(monomial.values().copied())? != Ratio::integer(2) {
            return None;
        }
        let term = times_powers(graph, coefficient, &monomial);
        kinetic = graph.add(kinetic, term);
    }
    (!graph.is_zero(g) && !graph.is_zero(kinetic)).then_some((kinetic, g))
}

/// p·Wp/2 + g s: with E = exp(−∫g) and w = ∫E, q moves by w·Wp, P = E p, S = E (s + w T).
pub(in super::super) fn drift(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let (kinetic, g) = damped_parts(graph, group)?;
    let free_of_time = |graph: &Graph, id| is_free(graph, id, &|symbol| symbol == Symbol::Time);
    if group.clock == Clock::Own && !free_of_time(graph, kinetic) {
        return None;
    }
    let (decay, weight) =
        if group.clock == Clock::Own && !free_of_time(graph, g) { decay_over_time(graph, g)? } else { decay(graph, g) };
    let mut flow = Flow::rest(graph, group.degrees);
    let velocity = diff::gradient(graph, kinetic, group.degrees).p;
    for (q, velocity) in flow.q.iter_mut().zip(velocity) {
        let change = graph.mul(weight, velocity);
        *q = graph.add(*q, change);
    }
    for p in &mut flow.p {
        *p = decay.of(graph, *p);
    }
    let change = graph.mul(weight, kinetic);
    let moved = graph.add(flow.s, change);
    flow.s = decay.of(graph, moved);
    Some(flow)
}

/// How something decays over a step.
enum Decay {
    /// By eᶻ, with eᶻ − 1.
    Exponential(Id, Id),
    /// By a factor.
    Factor(Id),
}

impl Decay {
    fn of(&self, graph: &mut Graph, x: Id) -> Id {
        match *self {
            Decay::Exponential(z, change) => grown(graph, x, [z, change]),
            Decay::Factor(factor) => graph.mul(factor, x),
        }
    }
}

/// For constant g: E = e^(−gh), and w = h·φ₁(−gh).
fn decay(graph: &mut Graph, g: Id) -> (Decay, Id) {
    let h = graph.symbol(Symbol::StepLength);
    let z = graph.mul(g, h);
    let z = graph.neg(z);
    let mean = graph.call(Function::Phi1, &[z]);
    let change = graph.mul(z, mean);
    (Decay::Exponential(z, change), graph.mul(h, mean))
}

/// For g = k/τ with τ = t₀ + t, and r the τ where the step begins over that where it ends: E = rᵏ and w = h (r − rᵏ)/((k − 1)(1 − r)),
/// without a singularity at τ = 0. For an integer k ≥ 2 that is h (r + r² + … + rᵏ⁻¹)/(k − 1).
fn decay_over_time(graph: &mut Graph, g: Id) -> Option<(Decay, Id)> {
    let OverTime { k, time } = over_time(graph, g)?;
    let (ratio, h) = (time.ratio(graph), graph.symbol(Symbol::StepLength));
    let few = match graph.as_number(k) {
        Some(Number::Exact(k)) if k.is_integer() && (2..=16).contains(&k.numerator) => k,
        _ => {
            let ln = time.ln_ratio(graph);
            let z = graph.mul(k, ln);
            let z = graph.neg(z);
            let change = graph.call(Function::ExpM1, &[z]);
            let mean = graph.call(Function::DecayMean, &[ratio, k]);
            return Some((Decay::Exponential(z, change), graph.mul(h, mean)));
        }
    };
    let mut sum = graph.zero();
    for _ in 1..few.numerator {
        // Horner's rule.
        let one = graph.integer(1);
        let inner = graph.add(one, sum);
        sum = graph.mul(ratio, inner);
    }
    let mean = graph.scale(Number::Exact(Ratio::integer(few.numerator - 1).recip()?), sum);
    Some((Decay::Factor(graph.pow(ratio, few)), graph.mul(h, mean)))
}

/// V(q) + g s at frozen time: q stands still, P = E p − w ∂V/∂q, S = E s − w V, with E and w as above.
pub(in super::super) fn kick(graph: &mut Graph, potential: Id, g: Id, degrees: u32) -> Flow {
    let (decay, weight) = decay(graph, g);
    let mut flow = Flow::rest(graph, degrees);
    // Derivatives of −wV, so that w meets the constants of every term and is prepared with them.
    let loss = graph.mul(weight, potential);
    let gain = graph.neg(loss);
    let impulses = diff::gradient(graph, gain, degrees).q;
    for (p, impulse) in flow.p.iter_mut().zip(impulses) {
        let kept = decay.of(graph, *p);
        *p = graph.add(kept, impulse);
    }
    let kept = decay.of(graph, flow.s);
    flow.s = graph.add(kept, gain);
    flow
}
