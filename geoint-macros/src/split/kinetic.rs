//! Pieces whose momenta keep their direction.

use super::flow::{Flow, Group};
use super::polynomial::{Monomial, Polynomial, factors, is_free, times_powers};
use super::scalar::{self, Equation, positive_power};
use super::time::{Clock, over_time, ratio};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

fn is_momentum(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::P(_))
}

fn reads_phase_space(symbol: Symbol) -> bool {
    symbol.is_coordinate()
}

/// Σ powers, each of the momenta together.
fn degree(powers: impl IntoIterator<Item = Ratio>) -> Option<Ratio> {
    powers.into_iter().try_fold(Ratio::ZERO, Ratio::add)
}

/// T(p, t): q moves by ∂T/∂p, s by p·∂T/∂p − T.
pub(super) fn free(graph: &mut Graph, group: &Group) -> Option<Flow> {
    if !is_free(graph, group.energy, &|symbol| matches!(symbol, Symbol::Q(_) | Symbol::S)) {
        return None;
    }
    let mut flow = Flow::rest(graph, group.degrees);
    let (velocity, action) = legendre(graph, group)?;
    for (q, velocity) in flow.q.iter_mut().zip(velocity) {
        let change = group.clock.over_step(graph, velocity)?;
        *q = graph.add(*q, change);
    }
    let change = group.clock.over_step(graph, action)?;
    flow.s = graph.add(flow.s, change);
    Some(flow)
}

/// ∂H/∂p and p·∂H/∂p − H: of each power of p that has degree k, k − 1 times itself.
fn legendre(graph: &mut Graph, group: &Group) -> Option<(Vec<Id>, Id)> {
    let velocity = diff::gradient(graph, group.energy, group.degrees).p;
    if let Some(powers) = Polynomial::of(graph, group.energy, &is_momentum) {
        let mut action = graph.zero();
        for (monomial, coefficient) in powers.into_terms() {
            let weight = degree(monomial.values().copied())?.add(Ratio::integer(-1))?;
            let weighted = graph.scale(Number::Exact(weight), coefficient);
            let term = times_powers(graph, weighted, &monomial);
            action = graph.add(action, term);
        }
        return Some((velocity, action));
    }
    let mut action = graph.neg(group.energy);
    for (i, velocity) in velocity.iter().enumerate() {
        let p = graph.symbol(Symbol::P(i as u32));
        let power = graph.mul(p, *velocity);
        action = graph.add(action, power);
    }
    Some((velocity, action))
}

/// T(p) with T homogeneous of degree 2 and coefficients that are free of phase space, and g.
fn damped_parts(graph: &mut Graph, group: &Group) -> Option<(Id, Id)> {
    let powers = Polynomial::of(graph, group.energy, &|symbol| is_momentum(symbol) || symbol == Symbol::S)?;
    let g = powers.coefficient(graph, &[(Symbol::S, 1)]);
    let mut kinetic = graph.zero();
    for (monomial, coefficient) in powers.into_terms() {
        if !is_free(graph, coefficient, &reads_phase_space) {
            return None;
        }
        if monomial.keys().eq([&Symbol::S]) && monomial.values().eq([&Ratio::ONE]) {
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
pub(super) fn damped(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let (kinetic, g) = damped_parts(graph, group)?;
    let free_of_time = |graph: &Graph, id| is_free(graph, id, &|symbol| symbol == Symbol::T);
    if group.clock == Clock::Own && !free_of_time(graph, kinetic) {
        return None;
    }
    let (decay, weight) = if group.clock == Clock::Own && !free_of_time(graph, g) {
        decay_over_time(graph, g)?
    } else {
        let h = graph.symbol(Symbol::H);
        let z = graph.mul(g, h);
        let z = graph.neg(z);
        let mean = graph.call(Function::Phi1, &[z]);
        let change = graph.mul(z, mean);
        (Decay::Exponential(z, change), graph.mul(h, mean))
    };
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
            Decay::Exponential(z, change) => graph.call(Function::Grown, &[x, z, change]),
            Decay::Factor(factor) => graph.mul(factor, x),
        }
    }
}

/// For g = k/t with an integer k ≥ 2 and r = t₀/t₁: E = rᵏ and w = h (r + r² + … + rᵏ⁻¹)/(k − 1), without a singularity at t₀ = 0.
fn decay_over_time(graph: &mut Graph, g: Id) -> Option<(Decay, Id)> {
    let k = over_time(graph, g)?;
    let Some(Number::Exact(k)) = graph.as_number(k) else { return None };
    if !k.is_integer() || !(2..=16).contains(&k.numerator) {
        return None;
    }
    let (ratio, h) = (ratio(graph), graph.symbol(Symbol::H));
    let mut sum = graph.zero();
    for _ in 1..k.numerator {
        // Horner's rule.
        let one = graph.integer(1);
        let inner = graph.add(one, sum);
        sum = graph.mul(ratio, inner);
    }
    let mean = graph.scale(Number::Exact(Ratio::integer(k.numerator - 1).recip()?), sum);
    Some((Decay::Factor(graph.pow(ratio, k)), graph.mul(h, mean)))
}

/// K(p)·F(s) with a homogeneous K of degree 2: F p is constant, and s' = K(F p)/F(s).
pub(super) fn weighted(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
    let changes = |symbol: Symbol| reads_phase_space(symbol) || symbol == Symbol::T && group.clock == Clock::Own;
    let (mut kinetic, mut weight) = (graph.zero(), None);
    for (monomial, coefficient) in powers.into_terms() {
        let weight = *weight.get_or_insert(coefficient);
        let relative = graph.div(coefficient, weight);
        let whole = monomial.values().all(|power| power.is_integer());
        if !whole || degree(monomial.values().copied())? != Ratio::integer(2) || !is_free(graph, relative, &changes) {
            return None;
        }
        let term = times_powers(graph, relative, &monomial);
        kinetic = graph.add(kinetic, term);
    }
    let weight = weight.filter(|weight| is_free(graph, *weight, &|symbol| symbol != Symbol::S && changes(symbol)))?;
    // A coefficient may be zero: the weight is what is divided by.
    let (coefficient, weight) = parted(graph, weight, Symbol::S);
    if is_free(graph, weight, &|symbol| symbol == Symbol::S) {
        return None;
    }
    let kinetic = graph.mul(coefficient, kinetic);
    // What is constant, under a name of its own while the equation of s is solved.
    let square = graph.pow(weight, Ratio::integer(2));
    let constant = graph.mul(kinetic, square);
    let name = graph.symbol(Symbol::Ds);
    let rate = graph.div(name, weight);
    let end = scalar::solve(graph, &Equation { x: Symbol::S, rate, clock: group.clock })?.end;
    let end = Substitution::new(|_, symbol| (symbol == Symbol::Ds).then_some(constant)).apply(graph, end);
    let weight_end = at(graph, weight, Symbol::S, end);
    let change = quotient(graph, weight, weight_end);

    let mut flow = Flow::rest(graph, group.degrees);
    let velocity = diff::gradient(graph, kinetic, group.degrees).p;
    let h = graph.symbol(Symbol::H);
    for (q, velocity) in flow.q.iter_mut().zip(velocity) {
        let moved = graph.product(&[h, weight, velocity]);
        *q = graph.add(*q, moved);
    }
    for p in &mut flow.p {
        *p = graph.mul(*p, change);
    }
    flow.s = end;
    Some(flow)
}

/// a/b without the factors that both have: they may be zero.
fn quotient(graph: &mut Graph, a: Id, b: Id) -> Id {
    let ((above, a), (below, b)) = (graph.coefficient(a), graph.coefficient(b));
    let (mut quotient, mut divisors) = (graph.number(above), factors(graph, b));
    for (base, exponent) in factors(graph, a) {
        match divisors.iter().position(|divisor| *divisor == (base, exponent)) {
            Some(i) => drop(divisors.swap_remove(i)),
            None => {
                let factor = graph.pow(base, exponent);
                quotient = graph.mul(quotient, factor);
            }
        }
    }
    let mut divisor = graph.number(below);
    for (base, exponent) in divisors {
        let factor = graph.pow(base, exponent);
        divisor = graph.mul(divisor, factor);
    }
    graph.div(quotient, divisor)
}

/// A node with a symbol replaced.
fn at(graph: &mut Graph, id: Id, symbol: Symbol, value: Id) -> Id {
    Substitution::new(|_, other| (other == symbol).then_some(value)).apply(graph, id)
}

/// c s pᵢᵏ: D = 1 + k c h pᵢᵏ, Qᵢ = qᵢ + k c h pᵢᵏ⁻¹ s, P = p D^(−1/k), S = s D^((k−1)/k).
pub(super) fn power(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &|symbol| is_momentum(symbol) || symbol == Symbol::S)?;
    let (monomial, c) = powers.single()?;
    let (i, k) = single_momentum(monomial)?;
    if monomial.get(&Symbol::S) != Some(&Ratio::ONE) || monomial.len() != 2 || !is_free(graph, c, &reads_phase_space) {
        return None;
    }
    let c = graph.scale(Number::Exact(k), c);
    let weight = group.clock.over_step(graph, c)?;
    let [p, s, one] = [graph.symbol(Symbol::P(i)), graph.symbol(Symbol::S), graph.integer(1)];
    let lower = graph.pow(p, k.add(Ratio::integer(-1))?);
    let moved = graph.product(&[weight, lower, s]);
    let full = graph.pow(p, k);
    let full = graph.mul(weight, full);
    let d = graph.add(one, full);
    let inverse = k.recip()?;
    let [shrunk, grown] = [inverse.mul(Ratio::integer(-1))?, Ratio::ONE.add(inverse.mul(Ratio::integer(-1))?)?]
        .map(|exponent| positive_power(graph, d, exponent));
    let mut flow = Flow::rest(graph, group.degrees);
    let q = &mut flow.q[i as usize];
    *q = graph.add(*q, moved);
    for p in &mut flow.p {
        *p = graph.mul(*p, shrunk);
    }
    flow.s = graph.mul(s, grown);
    Some(flow)
}

/// The only momentum of a monomial, and its power.
fn single_momentum(monomial: &Monomial) -> Option<(u32, Ratio)> {
    let mut momenta = monomial.iter().filter_map(|(symbol, power)| match symbol {
        Symbol::P(i) => Some((*i, *power)),
        _ => None,
    });
    momenta.next().filter(|_| momenta.next().is_none())
}

/// The factors of a product that do not read a symbol, and those that do.
fn parted(graph: &mut Graph, id: Id, symbol: Symbol) -> (Id, Id) {
    let (c, rest) = graph.coefficient(id);
    let (mut free, mut reading) = (graph.number(c), graph.integer(1));
    for (base, exponent) in factors(graph, rest) {
        let factor = graph.pow(base, exponent);
        let side = if is_free(graph, factor, &|other| other == symbol) { &mut free } else { &mut reading };
        *side = graph.mul(*side, factor);
    }
    (free, reading)
}

/// c f(qᵢ) pᵢ²: with R² = 2f, R pᵢ is constant and qᵢ' = c R·(R pᵢ).
pub(super) fn geodesic(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
    let (monomial, coefficient) = powers.single()?;
    let (i, _) = single_momentum(monomial).filter(|(_, power)| *power == Ratio::integer(2))?;
    let x = Symbol::Q(i);
    if !is_free(graph, coefficient, &|symbol| symbol.is_coordinate() && symbol != x) {
        return None;
    }
    let (c, f) = parted(graph, coefficient, x);
    let weight = group.clock.over_step(graph, c)?;
    let p = graph.symbol(Symbol::P(i));
    let (end, change) = match factors(graph, f)[..] {
        [(base, k)] if base == graph.symbol(x) => along_power(graph, (base, k), p, weight)?,
        _ if is_free(graph, coefficient, &|symbol| symbol == Symbol::T) || group.clock == Clock::Stage => {
            let double = graph.scale(Number::integer(2), f);
            let root = smooth_root(graph, double);
            let name = graph.symbol(Symbol::Ds);
            let constant = graph.product(&[c, root, p]);
            let rate = graph.mul(name, root);
            let end = scalar::solve(graph, &Equation { x, rate, clock: group.clock })?.end;
            let end = Substitution::new(|_, symbol| (symbol == Symbol::Ds).then_some(constant)).apply(graph, end);
            let root_end = at(graph, root, x, end);
            (end, quotient(graph, root, root_end))
        }
        _ => return None,
    };
    let square = graph.pow(p, Ratio::integer(2));
    let gained = graph.product(&[weight, f, square]);
    let mut flow = Flow::rest(graph, group.degrees);
    flow.q[i as usize] = end;
    flow.p[i as usize] = graph.mul(p, change);
    flow.s = graph.add(flow.s, gained);
    Some(flow)
}

/// The same for f = qᵏ, on both sides of q = 0: with D = 1 + (2 − k) c h qᵏ⁻¹ p, Q = q D^(2/(2−k)) and P = p D^(−k/(2−k)); with
/// z = 2 c h q p, Q = q e^z and P = p e^(−z) for k = 2. Returned are Q and P/p.
fn along_power(graph: &mut Graph, (q, k): (Id, Ratio), p: Id, weight: Id) -> Option<(Id, Id)> {
    let lower = graph.pow(q, k.add(Ratio::integer(-1))?);
    let rise = graph.product(&[weight, lower, p]);
    let left = Ratio::integer(2).add(k.mul(Ratio::integer(-1))?)?;
    if left.numerator == 0 {
        let z = graph.scale(Number::integer(2), rise);
        let back = graph.neg(z);
        let [grown, shrunk] = [z, back].map(|z| graph.call(Function::Exp, &[z]));
        return Some((graph.mul(q, grown), shrunk));
    }
    let (one, rise) = (graph.integer(1), graph.scale(Number::Exact(left), rise));
    let d = graph.add(one, rise);
    let inverse = left.recip()?;
    let grown = positive_power(graph, d, inverse.mul(Ratio::integer(2))?);
    let shrunk = positive_power(graph, d, inverse.mul(k)?.mul(Ratio::integer(-1))?);
    Some((graph.mul(q, grown), shrunk))
}

/// A root that changes sign where its square touches zero: q of q².
fn smooth_root(graph: &mut Graph, square: Id) -> Id {
    let (c, rest) = graph.coefficient(square);
    let c = graph.number(c);
    let mut root = graph.sqrt(c);
    for (base, exponent) in factors(graph, rest) {
        let factor = match exponent.mul(Ratio::HALF).filter(|half| half.denominator <= 2) {
            Some(half) => graph.pow(base, half),
            None => {
                let power = graph.pow(base, exponent);
                graph.sqrt(power)
            }
        };
        root = graph.mul(root, factor);
    }
    root
}
