//! Surfaces on which both arguments of `atan2` vanish. The angle may jump there by less than a turn, as that of (x², x) by π.

use super::surface::vanishes_on;
use crate::diff;
use crate::ir::{Function, Graph, Id, Node, Ratio, Sign, Symbol};

/// The angles in a function that the state or time changes.
pub(crate) fn angles(graph: &Graph, function: Id) -> Vec<Id> {
    let is_angle = |id: &Id| {
        let reads = graph.reads(*id);
        matches!(graph.node(*id), Node::Call(Function::Atan2, _)) && (reads.state() || reads.t)
    };
    graph.reachable(&[function]).into_iter().filter(is_angle).collect()
}

/// How an argument vanishes on a surface g = 0: as a power of |g|, with the sign of g or without.
#[derive(Clone, Copy, Debug)]
enum Zero {
    Everywhere,
    Power {
        exponent: Ratio,
        is_odd: bool,
    },
    /// In another way, such as max(g, 0).
    Other,
}

/// The g = 0 on which both arguments of an angle vanish, unless the angle was proven to have one limit on both sides, up to turns.
pub(crate) fn broken_at(graph: &mut Graph, angle: Id) -> Vec<Id> {
    let Node::Call(_, args) = graph.node(angle).clone() else { return vec![] };
    let candidates = candidates(graph, &args);
    candidates.into_iter().filter(|g| is_broken(graph, [args[0], args[1]], *g)).collect()
}

/// Factors of the arguments, and symbols, each of which may be a factor of a sum.
fn candidates(graph: &mut Graph, args: &[Id]) -> Vec<Id> {
    let mut candidates: Vec<Id> = vec![];
    for arg in args {
        let (_, rest) = graph.coefficient(*arg);
        for (base, _) in graph.factors(rest) {
            candidates.push(signed(graph, base));
        }
        let moving = graph.symbols(*arg).into_iter().filter(|symbol| moves(*symbol));
        for symbol in moving.collect::<Vec<Symbol>>() {
            candidates.push(graph.symbol(symbol));
        }
    }
    // A factor that keeps its sign turns nothing.
    candidates.retain(|g| graph.sign(*g) == Sign::Unknown && graph.symbols(*g).into_iter().any(moves));
    candidates.sort_unstable();
    candidates.dedup();
    candidates
}

fn moves(symbol: Symbol) -> bool {
    !matches!(symbol, Symbol::Parameter(_))
}

/// g of |g| and of ∛g.
fn signed(graph: &Graph, base: Id) -> Id {
    match graph.node(base) {
        Node::Call(Function::Abs | Function::Cbrt, args) => args[0],
        _ => base,
    }
}

/// Returns whether the direction of (x, y) may differ on both sides of g = 0, where both vanish. The argument with the lower power decides.
fn is_broken(graph: &mut Graph, [y, x]: [Id; 2], g: Id) -> bool {
    let (Some(y), Some(x)) = (zero_on(graph, y, g), zero_on(graph, x, g)) else { return false };
    match (y, x) {
        (Zero::Everywhere, Zero::Everywhere) => false,
        (Zero::Other, _) | (_, Zero::Other) => true,
        (Zero::Everywhere, Zero::Power { is_odd, .. }) | (Zero::Power { is_odd, .. }, Zero::Everywhere) => is_odd,
        (Zero::Power { exponent: a, is_odd: first }, Zero::Power { exponent: b, is_odd: second }) => match a.cmp(&b) {
            std::cmp::Ordering::Less => first,
            std::cmp::Ordering::Equal => first || second,
            std::cmp::Ordering::Greater => second,
        },
    }
}

/// How an argument vanishes on g = 0; `None` if it was not proven to vanish.
fn zero_on(graph: &mut Graph, argument: Id, g: Id) -> Option<Zero> {
    if graph.is_zero(argument) {
        return Some(Zero::Everywhere);
    }
    let (_, rest) = graph.coefficient(argument);
    let own = graph.factors(rest).into_iter().filter(|(base, _)| signed(graph, *base) == g);
    let mut powers: Option<(Ratio, bool)> = None;
    for (base, exponent) in own.collect::<Vec<_>>() {
        let Some((exponent, is_odd)) = power(graph, base, exponent) else { return Some(Zero::Other) };
        let (sum, odd) = powers.unwrap_or((Ratio::ZERO, false));
        let Some(sum) = sum.add(exponent) else { return Some(Zero::Other) };
        powers = Some((sum, odd != is_odd));
    }
    match powers {
        Some((exponent, is_odd)) if exponent > Ratio::ZERO => Some(Zero::Power { exponent, is_odd }),
        Some(_) => None,
        None => vanishes_on(graph, g, argument).then(|| multiplicity(graph, argument, g)),
    }
}

/// The power of |g| that a factor is, and whether it has the sign of g.
fn power(graph: &Graph, base: Id, exponent: Ratio) -> Option<(Ratio, bool)> {
    let is_odd = exponent.is_integer() && exponent.numerator % 2 != 0;
    match graph.node(base) {
        Node::Call(Function::Abs, _) => Some((exponent, false)),
        Node::Call(Function::Cbrt, _) => Some((exponent.mul(Ratio::new(1, 3)?)?, is_odd)),
        // A root is defined on one side.
        _ if exponent.is_integer() => Some((exponent, is_odd)),
        _ => Some((exponent, false)),
    }
}

/// The derivatives that are tried: zeros of a higher order count as others.
const HIGHEST: i128 = 6;

/// The order of a zero of a smooth function, by its derivatives across the surface.
fn multiplicity(graph: &mut Graph, argument: Id, g: Id) -> Zero {
    let across = graph.symbols(g).into_iter().find(|symbol| moves(*symbol));
    let Some(symbol) = across.filter(|_| is_smooth(graph, argument)) else { return Zero::Other };
    let slope = diff::jacobian(graph, &[g], &[symbol])[0][0];
    if vanishes_on(graph, g, slope) {
        return Zero::Other;
    }
    let mut derivative = argument;
    for order in 1..=HIGHEST {
        derivative = diff::jacobian(graph, &[derivative], &[symbol])[0][0];
        if !vanishes_on(graph, g, derivative) {
            return Zero::Power { exponent: Ratio::integer(order), is_odd: order % 2 != 0 };
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
