//! Momenta of Lagrangians that have no energy here: J = ∂L/∂v·(Aq + b) for L that is invariant under q' = Aq + b, v' = Av.
//!
//! A is antisymmetric, so that v moves as momenta do: in the place of momenta, velocities give the same brackets.

use super::generators::generators;
use super::momenta::{self, Momentum};
use crate::analyze::degree::Degrees;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Shape;

/// Sums of momenta and angular momenta that the flow keeps, for every s and t. Gauss methods do, too, because these are linear or bilinear.
pub(crate) fn noether(graph: &mut Graph, lagrangian: Id, coordinates: &Shape) -> Vec<Momentum> {
    let as_momentum = |graph: &mut Graph, symbol| match symbol {
        Symbol::Velocity(i) => Some(graph.symbol(Symbol::Momentum(i))),
        _ => None,
    };
    let energy = Substitution::new(as_momentum).apply(graph, lagrangian);
    let mut generators = generators(coordinates);
    generators.retain(|generator| generator.is_rigid());
    let degrees = Degrees::of(graph, &[energy], |symbol| matches!(symbol, Symbol::Position(_) | Symbol::Momentum(_)));
    momenta::of_generators(graph, &degrees, energy, coordinates, &generators)
}

/// Sums of momenta that tree slopes of an expression by positions keep, whatever else it reads.
pub(crate) fn translations(graph: &mut Graph, root: Id, coordinates: &Shape) -> Vec<Momentum> {
    let mut generators = generators(coordinates);
    generators.retain(|generator| generator.is_translation());
    let degrees = Degrees::of(graph, &[root], |symbol| matches!(symbol, Symbol::Position(_)));
    momenta::of_generators(graph, &degrees, root, coordinates, &generators)
}
