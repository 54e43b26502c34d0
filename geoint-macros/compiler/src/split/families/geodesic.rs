//! Family "geodesic": c f(qᵢ) pᵢ². One coordinate moves along a geodesic.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_free, is_momentum, single_momentum, slope_of_line};
use super::super::products::{Separated, factors, quotient, separated};
use super::super::scalar::{self, Equation, mean_of_power, positive_power};
use super::monomial;
use crate::ir::formula::{call, pow, squared};
use crate::ir::substitute::replaced;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// The position at the end of a flow, and the factor by which the flow multiplies the momentum.
struct Geodesic {
    end: Id,
    growth_of_p: Id,
}

/// Returns the flow of c f(qᵢ) pᵢ². With R² = 2f, R pᵢ is constant and qᵢ' = c R·(R pᵢ).
pub(super) fn geodesic(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
    let (monomial, coefficient) = powers.single()?;
    let (i, _) = single_momentum(monomial).filter(|(_, power)| *power == Ratio::integer(2))?;
    let x = Symbol::Position(i);
    if !is_free(graph, coefficient, &|symbol| symbol.is_coordinate() && symbol != x) {
        return None;
    }
    let Separated { free: c, reading: f } = separated(graph, coefficient, x);
    let weight = group.clock.over_step(graph, c)?;
    let p = graph.symbol(Symbol::Momentum(i));
    let steady = group.clock.is_steady(graph, f);
    let Geodesic { end, growth_of_p } = match factors(graph, f)[..] {
        [(base, k)] if base == graph.symbol(x) => along_power(graph, base, k, p, weight)?,
        [(base, k)] if steady && slope(graph, base, x).is_some() => along_shifted_power(graph, x, base, k, p, weight)?,
        _ if group.clock.is_steady(graph, coefficient) => {
            let double = graph.build(2 * f);
            let root = smooth_root(graph, double);
            // `ActionIncrement` stands for the constant c R pᵢ while the equation is solved.
            let name = graph.symbol(Symbol::ActionIncrement);
            let constant = graph.product(&[c, root, p]);
            let rate = graph.mul(name, root);
            let end = scalar::solve(graph, &Equation { x, rate, clock: group.clock })?.end;
            let end = replaced(graph, end, Symbol::ActionIncrement, constant);
            let root_end = replaced(graph, root, x, end);
            Geodesic { end, growth_of_p: quotient(graph, root, root_end) }
        }
        _ => return None,
    };
    let square = graph.build(squared(p));
    let gained = graph.build(weight * f * square);
    let mut flow = Flow::rest(graph, group.degrees);
    flow.q[i as usize] = end;
    flow.p[i as usize] = graph.mul(p, growth_of_p);
    flow.s = graph.add(flow.s, gained);
    Some(flow)
}

/// Returns the motion for f = qᵏ, which is valid for q < 0, too.
fn along_power(graph: &mut Graph, q: Id, k: Ratio, p: Id, weight: Id) -> Option<Geodesic> {
    let rise = graph.build(weight * pow(q, k.add(Ratio::integer(-1))?) * p);
    let growth = monomial::growth(graph, rise, k, Ratio::integer(2))?;
    Some(Geodesic { end: graph.mul(q, growth.q), growth_of_p: growth.p })
}

/// Returns a of a·x + b, if a does not read coordinates.
fn slope(graph: &mut Graph, base: Id, x: Symbol) -> Option<Id> {
    slope_of_line(graph, base, x).filter(|slope| is_free(graph, *slope, &Symbol::is_coordinate))
}

/// Returns the motion for f = uᵏ with u = a x + b, r = (2 − k) c h uᵏ⁻¹ p and D = 1 + a r: x grows by u (D^(2/(2−k)) − 1)/a.
///
/// This increment is u r times a mean of powers of D. The formula holds for all signs of a and u, and for a = 0.
fn along_shifted_power(graph: &mut Graph, x: Symbol, u: Id, k: Ratio, p: Id, weight: Id) -> Option<Geodesic> {
    let a = slope(graph, u, x)?;
    let lower = graph.pow(u, k.add(Ratio::integer(-1))?);
    let difference = Ratio::integer(2).add(k.neg())?;
    let is_square = difference.numerator == 0;
    let scale = Number::Exact(if is_square { Ratio::integer(2) } else { difference });
    let rise = graph.build(scale * weight * lower * p);
    let z = graph.mul(a, rise);
    let (mean, growth_of_p) = if is_square {
        (graph.call(Function::Phi1, &[z]), graph.build(call(Function::Exp, [-z])))
    } else {
        let inverse = difference.recip()?;
        let d = graph.build(1 + z);
        let mean = mean_of_power(graph, z, inverse.mul(Ratio::integer(2))?)?;
        (mean, positive_power(graph, d, inverse.mul(k)?.neg()))
    };
    let x = graph.symbol(x);
    Some(Geodesic { end: graph.build(x + u * rise * mean), growth_of_p })
}

/// Returns a root that changes sign where its square touches zero. The root of q² is q, not |q|.
fn smooth_root(graph: &mut Graph, square: Id) -> Id {
    let (c, rest) = graph.coefficient(square);
    let c = graph.number(c);
    let mut root = graph.sqrt(c);
    for (base, exponent) in factors(graph, rest) {
        let factor = match exponent.mul(Ratio::HALF).filter(|half| half.denominator <= 2) {
            Some(half) => graph.pow(base, half),
            None => graph.build(pow(pow(base, exponent), Ratio::HALF)),
        };
        root = graph.mul(root, factor);
    }
    root
}
