//! The modified energy H + h²H₂ of a symmetric step of order 2. The step keeps it, or lets it decay, up to O(h⁴).
//!
//! For e^(h/2 X) e^(h Y) e^(h/2 X) it is X + Y + h²·(−{X, {X, Y}}/24 + {Y, {Y, X}}/12), where {·, ·} is the bracket whose vector field is the
//! commutator. With more pieces, the formula applies to the inner pieces recursively.
//!
//! A flow that advances a clock c has the momentum conjugate to c as a term e_c of its energy, so {F + e_c, G} = {F, G} + ∂G/∂c.

use super::forward::along;
use super::gradient::{Gradient, gradient, partial_derivative, rename};
use crate::analyze::Parts;
use crate::ir::formula::squared;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// A piece of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    /// The energy of the piece, with clocks as coordinates.
    pub(crate) energy: Id,
    /// The clock that the flow of the piece advances.
    pub(crate) advances: Option<TimeCoordinate>,
}

/// The clock of some flows of a step, as an additional coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TimeCoordinate(pub(crate) u32);

/// Positions from this number on are clocks. No system has as many coordinates.
const FIRST: u32 = u32::MAX / 2;

impl TimeCoordinate {
    fn symbol(self) -> Symbol {
        Symbol::Position(FIRST + self.0)
    }

    /// Replaces time by this clock in an energy.
    pub(crate) fn read(self, graph: &mut Graph, energy: Id) -> Id {
        rename(graph, energy, |symbol| (symbol == Symbol::Time).then(|| self.symbol()))
    }
}

/// The generator of a flow.
#[derive(Clone)]
struct Generator {
    energy: Id,
    /// The clocks that the flow advances.
    clocks: Vec<TimeCoordinate>,
}

impl Generator {
    fn without_clocks(energy: Id) -> Generator {
        Generator { energy, clocks: vec![] }
    }
}

/// Computes H + h²H₂ of a symmetric step from the pieces of its first half, in order.
pub(crate) fn modified_energy(graph: &mut Graph, parts: &[Part], degrees: u32) -> Id {
    let (mut inner, mut second) = (Generator::without_clocks(graph.zero()), graph.zero());
    for part in parts.iter().rev() {
        let outer = Generator { energy: part.energy, clocks: part.advances.into_iter().collect() };
        let commutator = Generator::without_clocks(bracket(graph, &outer, &inner, degrees));
        let with_outer = bracket(graph, &outer, &commutator, degrees);
        let with_inner = bracket(graph, &inner, &commutator, degrees);
        // {Y, {Y, X}} = −{Y, {X, Y}}.
        for (weight, term) in [(24, with_outer), (12, with_inner)] {
            second = graph.build(second + Number::Exact(Ratio { numerator: -1, denominator: weight }) * term);
        }
        inner.energy = graph.add(inner.energy, part.energy);
        inner.clocks.extend(part.advances);
    }
    let modified = corrected(graph, inner.energy, second);
    rename(graph, modified, |symbol| matches!(symbol, Symbol::Position(FIRST..)).then_some(Symbol::Time))
}

/// H + h²H₂.
fn corrected(graph: &mut Graph, energy: Id, second: Id) -> Id {
    let h = graph.symbol(Symbol::StepLength);
    graph.build(energy + squared(h) * second)
}

/// Computes H + h²H₂ for half a kick, a drift and half a kick of H = T(p, t) + V(q, t), from ∇H.
///
/// A drift changes q and the time of V uniformly, a kick changes p and the time of T uniformly. The double brackets are therefore second derivatives
/// along constant directions: H₂ = V″[v, v]/12 − T″[f, f]/24 with v = (∂T/∂p, 1) and f = (−∂V/∂q, 1).
pub(crate) fn verlet(graph: &mut Graph, parts: &Parts, slopes: &Gradient) -> Id {
    let forces: Vec<Id> = slopes.q.iter().map(|slope| graph.neg(*slope)).collect();
    let drifts = second_derivative(graph, parts.potential, &slopes.q, &slopes.p, |symbol| match symbol {
        Symbol::Position(i) => Some(i),
        _ => None,
    });
    let kicks = second_derivative(graph, parts.kinetic, &slopes.p, &forces, |symbol| match symbol {
        Symbol::Momentum(i) => Some(i),
        _ => None,
    });
    let terms = [(1, 12, drifts), (-1, 24, kicks)]
        .map(|(numerator, denominator, term)| graph.scale(Number::Exact(Ratio { numerator, denominator }), term));
    let (energy, second) = (graph.add(parts.kinetic, parts.potential), graph.sum(&terms));
    corrected(graph, energy, second)
}

/// The second derivative of an energy with known slopes along a constant direction, which is 1 in time.
fn second_derivative(
    graph: &mut Graph,
    energy: Id,
    slopes: &[Id],
    direction: &[Id],
    coordinate: impl Fn(Symbol) -> Option<u32>,
) -> Id {
    let one = graph.integer(1);
    let rate = partial_derivative(graph, energy, Symbol::Time);
    let slopes = [slopes, &[rate]].concat();
    let changes = along(graph, &slopes, |symbol| match symbol {
        Symbol::Time => Some(one),
        _ => coordinate(symbol).map(|i| direction[i as usize]),
    });
    graph.dot(&[direction, &[one]].concat(), &changes)
}

/// {F, G} = ∂F/∂p·∂G/∂q − ∂F/∂q·∂G/∂p + p·(∂F/∂p ∂G/∂s − ∂F/∂s ∂G/∂p) + G ∂F/∂s − F ∂G/∂s, and the terms ∂G/∂c and −∂F/∂c of clocks.
fn bracket(graph: &mut Graph, f: &Generator, g: &Generator, degrees: u32) -> Id {
    let [df, dg] = [f, g].map(|generator| gradient(graph, generator.energy, degrees));
    let mut terms = vec![];
    for i in 0..degrees as usize {
        let p = graph.symbol(Symbol::Momentum(i as u32));
        // ∂/∂q + p ∂/∂s.
        let [lifted_f, lifted_g] = [&df, &dg].map(|slopes| graph.build(slopes.q[i] + p * slopes.s));
        terms.push(graph.mul(df.p[i], lifted_g));
        terms.push(graph.build(-(lifted_f * dg.p[i])));
    }
    terms.push(graph.mul(g.energy, df.s));
    terms.push(graph.build(-(f.energy * dg.s)));
    for clock in &f.clocks {
        terms.push(partial_derivative(graph, g.energy, clock.symbol()));
    }
    for clock in &g.clocks {
        let back = partial_derivative(graph, f.energy, clock.symbol());
        terms.push(graph.neg(back));
    }
    graph.sum(&terms)
}
