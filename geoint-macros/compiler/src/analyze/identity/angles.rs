//! Surfaces on which both arguments of `atan2` vanish. The angle may jump there by less than a turn: the angle of (x², x) jumps by π.
//!
//! Each factor of an argument and each symbol is a candidate for such a surface. If both arguments, multiplied out, have a common factor that is no candidate, the
//! whole argument stands for its surface.

use super::common_factor::has_hidden_factor;
use super::derivative;
use super::surface::{differs_on, moves, vanishes_on_a_part};
use crate::ir::{Function, Graph, Id, Node, Ratio, Sign};
use std::cmp::Ordering;

/// The angles in a function that the state or time changes.
pub(crate) fn angles(graph: &Graph, function: Id) -> Vec<Id> {
    let is_angle = |id: &Id| {
        let reads = graph.reads(*id);
        matches!(graph.node(*id), Node::Call(Function::Atan2, _)) && (reads.state() || reads.t)
    };
    graph.reachable(&[function]).into_iter().filter(is_angle).collect()
}

/// A power of |g|, times the sign of g if it is odd.
#[derive(Clone, Copy, Debug)]
struct Power {
    exponent: Ratio,
    is_odd: bool,
}

/// How an argument vanishes on a surface g = 0.
#[derive(Clone, Copy, Debug)]
enum Zero {
    Everywhere,
    Power(Power),
    /// In another way, such as max(g, 0).
    Other,
}

/// The functions g among the candidates for which both arguments of an angle vanish on g = 0. Excludes g if the angle was proven to have one limit on both
/// sides, up to turns.
pub(crate) fn broken_at(graph: &mut Graph, angle: Id) -> Vec<Id> {
    let Node::Call(_, args) = graph.node(angle).clone() else { return vec![] };
    let args = [args[0], args[1]];
    // `known` lists the surfaces that are decided.
    let (mut broken, mut known) = (vec![], vec![]);
    for g in candidates(graph, &args) {
        // A factor with a constant sign does not turn the direction.
        let is_broken = if graph.sign(g) == Sign::Unknown { is_broken(graph, args, g) } else { Some(false) };
        known.extend(is_broken.map(|_| g));
        broken.extend((is_broken == Some(true)).then_some(g));
    }
    // |g| and ∛g vanish where g does.
    let factors: Vec<Id> = args.iter().flat_map(|arg| factors(graph, *arg)).collect();
    known.extend(factors.into_iter().filter(|base| known.contains(&signed(graph, *base))).collect::<Vec<Id>>());
    // A hidden factor has no node of its own. One message about an angle is enough.
    if broken.is_empty() && has_hidden_factor(graph, args, &known) {
        broken.push(args[1]);
    }
    broken
}

/// Factors of the arguments, and symbols. A symbol may be a factor of a sum that is not written as a product, such as x y + x².
fn candidates(graph: &mut Graph, args: &[Id]) -> Vec<Id> {
    let mut candidates: Vec<Id> = vec![];
    for arg in args {
        candidates.extend(factors(graph, *arg).into_iter().map(|base| signed(graph, base)));
        candidates.extend(graph.symbols(*arg).into_iter().map(|symbol| graph.symbol(symbol)));
    }
    candidates.retain(|g| graph.symbols(*g).into_iter().any(moves));
    candidates.sort_unstable();
    candidates.dedup();
    candidates
}

/// Returns the factors of an argument without their exponents, and without its coefficient.
fn factors(graph: &Graph, argument: Id) -> Vec<Id> {
    let (_, rest) = graph.coefficient(argument);
    graph.factors(rest).into_iter().map(|(base, _)| base).collect()
}

/// Returns g for |g| and ∛g.
fn signed(graph: &Graph, base: Id) -> Id {
    match graph.node(base) {
        Node::Call(Function::Abs | Function::Cbrt, args) => args[0],
        _ => base,
    }
}

/// Returns whether the direction of (x, y) may differ on both sides of g = 0. `None` if one of both was not proven to vanish there. The argument with
/// the lower power decides the direction near the surface: if its sign changes, the direction is reversed. With equal powers, a change of either sign
/// turns the direction.
fn is_broken(graph: &mut Graph, [y, x]: [Id; 2], g: Id) -> Option<bool> {
    let (y, x) = (zero_on(graph, y, g)?, zero_on(graph, x, g)?);
    Some(match (y, x) {
        (Zero::Everywhere, Zero::Everywhere) => false,
        (Zero::Other, _) | (_, Zero::Other) => true,
        (Zero::Everywhere, Zero::Power(power)) | (Zero::Power(power), Zero::Everywhere) => power.is_odd,
        (Zero::Power(y), Zero::Power(x)) => match y.exponent.cmp(&x.exponent) {
            Ordering::Less => y.is_odd,
            Ordering::Equal => y.is_odd || x.is_odd,
            Ordering::Greater => x.is_odd,
        },
    })
}

/// How an argument vanishes on g = 0; `None` if it was not proven to vanish.
fn zero_on(graph: &mut Graph, argument: Id, g: Id) -> Option<Zero> {
    if graph.is_zero(argument) {
        return Some(Zero::Everywhere);
    }
    let (_, rest) = graph.coefficient(argument);
    let (own, others): (Vec<_>, Vec<_>) =
        graph.factors(rest).into_iter().partition(|(base, _)| signed(graph, *base) == g);
    if own.is_empty() {
        return vanishes_on_a_part(graph, g, argument).then(|| multiplicity(graph, argument, g));
    }
    // Another factor may vanish on the same surface and change the power.
    for (base, _) in others {
        if graph.symbols(base).into_iter().any(moves) && !differs_on(graph, g, base) {
            return Some(Zero::Other);
        }
    }
    let product =
        own.into_iter().try_fold(Power { exponent: Ratio::ZERO, is_odd: false }, |product, (base, exponent)| {
            let factor = power(graph, base, exponent)?;
            Some(Power { exponent: product.exponent.add(factor.exponent)?, is_odd: product.is_odd != factor.is_odd })
        });
    match product {
        None => Some(Zero::Other),
        Some(power) => (power.exponent > Ratio::ZERO).then_some(Zero::Power(power)),
    }
}

/// The power of g that baseᵉ is, where the base is g, |g| or ∛g. `None` if the exponent is no longer exact.
fn power(graph: &Graph, base: Id, exponent: Ratio) -> Option<Power> {
    let is_odd = exponent.is_integer() && exponent.numerator % 2 != 0;
    match graph.node(base) {
        Node::Call(Function::Abs, _) => Some(Power { exponent, is_odd: false }),
        Node::Call(Function::Cbrt, _) => Some(Power { exponent: exponent.mul(Ratio::new(1, 3)?)?, is_odd }),
        // Roots of g are defined on one side only, so they have no sign.
        _ => Some(Power { exponent, is_odd }),
    }
}

/// The highest order of a zero. Zeros of higher order count as [`Zero::Other`]; they are rare, and each derivative is longer than the one before.
const HIGHEST: i128 = 6;

/// The order of the zero of a smooth function on g = 0, by its derivatives across the surface.
fn multiplicity(graph: &mut Graph, argument: Id, g: Id) -> Zero {
    let across = graph.symbols(g).into_iter().find(|symbol| moves(*symbol));
    let Some(symbol) = across.filter(|_| is_smooth(graph, argument)) else { return Zero::Other };
    // The symbol must lead across the surface.
    let slope = derivative(graph, g, symbol);
    if !differs_on(graph, g, slope) {
        return Zero::Other;
    }
    let mut highest = argument;
    for order in 1..=HIGHEST {
        highest = derivative(graph, highest, symbol);
        if !vanishes_on_a_part(graph, g, highest) {
            // A derivative that vanishes without a proof would give a wrong order.
            if !differs_on(graph, g, highest) {
                return Zero::Other;
            }
            return Zero::Power(Power { exponent: Ratio::integer(order), is_odd: order % 2 != 0 });
        }
    }
    Zero::Other
}

/// Returns whether a node has no conditions and no kinks.
fn is_smooth(graph: &Graph, root: Id) -> bool {
    graph.reachable(&[root]).into_iter().all(|id| match graph.node(id) {
        Node::Call(function, _) => !matches!(
            function,
            Function::Abs | Function::Signum | Function::Min | Function::Max | Function::Cbrt | Function::Hypot
        ),
        Node::Power(_, exponent) => exponent.is_integer(),
        node => !node.is_condition() && !matches!(node, Node::Select(..)),
    })
}
