//! The energy that a symmetric step of order 2 keeps, or lets decay, up to h⁴: H + h²H₂.
//!
//! For e^(h/2 X) e^(h Y) e^(h/2 X) it is X + Y + h²·(−{X, {X, Y}}/24 + {Y, {Y, X}}/12), with {·, ·} the bracket whose vector field is the
//! commutator; for more pieces the same applies to what is inside, again and again. Flows that advance a clock have a conjugate
//! of that clock added to their energy, which is linear in it: {F + e_c, G} has ∂G/∂c more than {F, G}.

use super::forward::along;
use super::gradient::{Gradient, gradient, partial, rename};
use crate::analyze::Parts;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// A piece of a step: its energy, in which clocks are coordinates of their own, and the clock that its flow advances.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    pub(crate) energy: Id,
    pub(crate) advances: Option<TimeCoordinate>,
}

/// The time of some flows of a step, as a coordinate of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TimeCoordinate(pub(crate) u32);

/// Clocks are symbols that no coordinate uses.
const FIRST: u32 = u32::MAX / 2;

impl TimeCoordinate {
    fn symbol(self) -> Symbol {
        Symbol::Position(FIRST + self.0)
    }

    /// An energy that reads this clock for time.
    pub(crate) fn read(self, graph: &mut Graph, energy: Id) -> Id {
        rename(graph, energy, |symbol| (symbol == Symbol::Time).then(|| self.symbol()))
    }
}

/// H + h²H₂ of the step whose half is `parts` in order.
pub(crate) fn modified_energy(graph: &mut Graph, parts: &[Part], degrees: u32) -> Id {
    let (mut inner, mut clocks, mut second) = (graph.zero(), vec![], graph.zero());
    for part in parts.iter().rev() {
        let outer = (part.energy, part.advances.into_iter().collect::<Vec<_>>());
        let rest = (inner, clocks.clone());
        let across = bracket(graph, &outer, &rest, degrees);
        let ahead = bracket(graph, &outer, &(across, vec![]), degrees);
        let back = bracket(graph, &rest, &(across, vec![]), degrees);
        // {Y, {Y, X}} is −{Y, {X, Y}}.
        for (weight, term) in [(24, ahead), (12, back)] {
            let term = graph.scale(Number::Exact(Ratio { numerator: -1, denominator: weight }), term);
            second = graph.add(second, term);
        }
        inner = graph.add(inner, part.energy);
        clocks.extend(part.advances);
    }
    let modified = corrected(graph, inner, second);
    rename(graph, modified, |symbol| matches!(symbol, Symbol::Position(FIRST..)).then_some(Symbol::Time))
}

/// H + h²H₂.
fn corrected(graph: &mut Graph, energy: Id, second: Id) -> Id {
    let h = graph.symbol(Symbol::StepLength);
    let square = graph.pow(h, Ratio::integer(2));
    let change = graph.mul(square, second);
    graph.add(energy, change)
}

/// The same for half a kick, a drift, half a kick of H = T(p, t) + V(q, t), by ∇H.
///
/// Drifts are straight in q and the time of V, kicks in p and the time of T. What they do twice is then a second derivative along a
/// constant direction: H₂ = V″[v, v]/12 − T″[f, f]/24 with v = (∂T/∂p, 1) and f = (−∂V/∂q, 1).
pub(crate) fn verlet(graph: &mut Graph, parts: &Parts, slopes: &Gradient) -> Id {
    let forces: Vec<Id> = slopes.q.iter().map(|slope| graph.neg(*slope)).collect();
    let drifts = twice(graph, (parts.potential, &slopes.q), &slopes.p, |symbol| match symbol {
        Symbol::Position(i) => Some(i),
        _ => None,
    });
    let kicks = twice(graph, (parts.kinetic, &slopes.p), &forces, |symbol| match symbol {
        Symbol::Momentum(i) => Some(i),
        _ => None,
    });
    let terms = [(1, 12, drifts), (-1, 24, kicks)]
        .map(|(numerator, denominator, term)| graph.scale(Number::Exact(Ratio { numerator, denominator }), term));
    let (energy, second) = (graph.add(parts.kinetic, parts.potential), graph.sum(&terms));
    corrected(graph, energy, second)
}

/// The second derivative of an energy with known slopes along a direction that is constant, and 1 in time.
fn twice(
    graph: &mut Graph,
    (energy, slopes): (Id, &[Id]),
    direction: &[Id],
    coordinate: impl Fn(Symbol) -> Option<u32>,
) -> Id {
    let one = graph.integer(1);
    let rate = partial(graph, energy, Symbol::Time);
    let changes = along(graph, &[slopes, &[rate]].concat(), |symbol| match symbol {
        Symbol::Time => Some(one),
        _ => coordinate(symbol).map(|i| direction[i as usize]),
    });
    let terms: Vec<Id> = direction.iter().chain([&one]).zip(changes).map(|(x, change)| graph.mul(*x, change)).collect();
    graph.sum(&terms)
}

/// ∂F/∂p·∂G/∂q − ∂F/∂q·∂G/∂p + p·(∂F/∂p ∂G/∂s − ∂F/∂s ∂G/∂p) + G ∂F/∂s − F ∂G/∂s, and what clocks add.
fn bracket(
    graph: &mut Graph,
    (f, with_f): &(Id, Vec<TimeCoordinate>),
    (g, with_g): &(Id, Vec<TimeCoordinate>),
    degrees: u32,
) -> Id {
    let [df, dg] = [*f, *g].map(|energy| gradient(graph, energy, degrees));
    let mut terms = vec![];
    for i in 0..degrees as usize {
        // ∂/∂q + p ∂/∂s is what the momenta are moved by.
        let p = graph.symbol(Symbol::Momentum(i as u32));
        let [lifted_f, lifted_g] = [(df.q[i], df.s), (dg.q[i], dg.s)].map(|(by_q, by_s)| {
            let lift = graph.mul(p, by_s);
            graph.add(by_q, lift)
        });
        terms.push(graph.mul(df.p[i], lifted_g));
        let back = graph.mul(lifted_f, dg.p[i]);
        terms.push(graph.neg(back));
    }
    terms.push(graph.mul(*g, df.s));
    let back = graph.mul(*f, dg.s);
    terms.push(graph.neg(back));
    for clock in with_f {
        terms.push(partial(graph, *g, clock.symbol()));
    }
    for clock in with_g {
        let back = partial(graph, *f, clock.symbol());
        terms.push(graph.neg(back));
    }
    graph.sum(&terms)
}
