//! Pieces in which one coordinate moves along a geodesic.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{
    Polynomial, factors, is_free, is_momentum, parted, quotient, single_momentum, slope_of_line,
};
use super::super::scalar::{self, Equation, positive_power};
use super::super::time::Clock;
use crate::ir::substitute::replaced;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// c f(qᵢ) pᵢ²: with R² = 2f, R pᵢ is constant and qᵢ' = c R·(R pᵢ).
pub(in super::super) fn geodesic(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
    let (monomial, coefficient) = powers.single()?;
    let (i, _) = single_momentum(monomial).filter(|(_, power)| *power == Ratio::integer(2))?;
    let x = Symbol::Position(i);
    if !is_free(graph, coefficient, &|symbol| symbol.is_coordinate() && symbol != x) {
        return None;
    }
    let (c, f) = parted(graph, coefficient, x);
    let weight = group.clock.over_step(graph, c)?;
    let p = graph.symbol(Symbol::Momentum(i));
    let steady = group.clock == Clock::Stage || is_free(graph, f, &|symbol| symbol == Symbol::Time);
    let (end, change) = match factors(graph, f)[..] {
        [(base, k)] if base == graph.symbol(x) => along_power(graph, (base, k), p, weight)?,
        [(base, k)] if steady && slope(graph, base, x).is_some() => {
            along_shifted_power(graph, (x, base, k), p, weight)?
        }
        _ if group.clock == Clock::Stage || is_free(graph, coefficient, &|symbol| symbol == Symbol::Time) => {
            let double = graph.scale(Number::integer(2), f);
            let root = smooth_root(graph, double);
            let name = graph.symbol(Symbol::ActionIncrement);
            let constant = graph.product(&[c, root, p]);
            let rate = graph.mul(name, root);
            let end = scalar::solve(graph, &Equation { x, rate, clock: group.clock })?.end;
            let end = replaced(graph, end, Symbol::ActionIncrement, constant);
            let root_end = replaced(graph, root, x, end);
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

/// a of a·x + b, if that does not move.
fn slope(graph: &mut Graph, base: Id, x: Symbol) -> Option<Id> {
    slope_of_line(graph, base, x).filter(|slope| is_free(graph, *slope, &Symbol::is_coordinate))
}

/// The same for f = uᵏ, u = a x + b: with r = (2 − k) c h uᵏ⁻¹ p and D = 1 + a r, x grows by u (D^(2/(2−k)) − 1)/a, which is a mean of powers
/// times u r, whatever the signs of a and u, and for a = 0 too. Returned are x at the end, and P/p.
fn along_shifted_power(graph: &mut Graph, (x, base, k): (Symbol, Id, Ratio), p: Id, weight: Id) -> Option<(Id, Id)> {
    let a = slope(graph, base, x)?;
    let lower = graph.pow(base, k.add(Ratio::integer(-1))?);
    let left = Ratio::integer(2).add(k.neg())?;
    let scale = if left.numerator == 0 { Ratio::integer(2) } else { left };
    let scale = graph.number(Number::Exact(scale));
    let rise = graph.product(&[scale, weight, lower, p]);
    let z = graph.mul(a, rise);
    let (mean, shrunk) = if left.numerator == 0 {
        let back = graph.neg(z);
        (graph.call(Function::Phi1, &[z]), graph.call(Function::Exp, &[back]))
    } else {
        let (one, inverse) = (graph.integer(1), left.recip()?);
        let d = graph.add(one, z);
        let mean = scalar::mean_of_power(graph, z, inverse.mul(Ratio::integer(2))?)?;
        (mean, positive_power(graph, d, inverse.mul(k)?.neg()))
    };
    let (x, change) = (graph.symbol(x), graph.product(&[base, rise, mean]));
    Some((graph.add(x, change), shrunk))
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
