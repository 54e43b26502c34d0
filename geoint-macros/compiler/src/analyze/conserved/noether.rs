//! Momenta of Lagrangians without an energy: J = ∂L/∂v·(Aq + b) for an L that is invariant under q' = Aq + b, v' = Av.
//!
//! A is antisymmetric, so velocities transform as momenta do. With velocities in place of momenta, the brackets are equal.

use super::generators::generators;
use super::momenta::{self, Conserved};
use crate::analyze::degree::Degrees;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Shape;

/// Returns sums of momenta and angular momenta that the flow conserves for every s and t. They are linear or bilinear, so Gauss methods conserve
/// them, too.
pub(crate) fn noether(graph: &mut Graph, lagrangian: Id, coordinates: &Shape) -> Vec<Conserved> {
    let as_momentum = |graph: &mut Graph, symbol| match symbol {
        Symbol::Velocity(i) => Some(graph.symbol(Symbol::Momentum(i))),
        _ => None,
    };
    let energy = Substitution::new(as_momentum).apply(graph, lagrangian);
    let mut generators = generators(coordinates);
    generators.retain(|generator| generator.is_rigid());
    let degrees = Degrees::of(graph, &[energy], Symbol::is_canonical);
    momenta::of_generators(graph, &degrees, energy, coordinates, &generators)
}

/// Returns sums of momenta that the tree slopes of an expression by positions conserve. The expression may read other symbols.
pub(crate) fn translations(graph: &mut Graph, root: Id, coordinates: &Shape) -> Vec<Conserved> {
    let mut generators = generators(coordinates);
    generators.retain(|generator| generator.is_translation());
    let degrees = Degrees::of(graph, &[root], |symbol| matches!(symbol, Symbol::Position(_)));
    momenta::of_generators(graph, &degrees, root, coordinates, &generators)
}
