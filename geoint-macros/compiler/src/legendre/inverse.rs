//! From an energy H(q, p, t) to its Lagrangian. The Legendre transform is its own inverse: L is the energy of H if momenta and velocities change places.

use super::{Legendre, Route, transform};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

/// The Lagrangian of an energy, as a function of velocities.
pub(crate) struct Inverse {
    pub(crate) lagrangian: Id,
    /// p = ∂L/∂v.
    pub(crate) momenta: Vec<Id>,
}

/// Returns the Lagrangian of an energy. `None` if ∂H/∂p = v has no formula for p that is shorter than its solution by elimination.
pub(crate) fn inverse(graph: &mut Graph, energy: Id, degrees: u32) -> Option<Inverse> {
    let mut exchange = Substitution::new(|graph: &mut Graph, symbol| match symbol {
        Symbol::Momentum(i) => Some(graph.symbol(Symbol::Velocity(i))),
        Symbol::Velocity(i) => Some(graph.symbol(Symbol::Momentum(i))),
        _ => None,
    });
    let exchanged = exchange.apply(graph, energy);
    let Legendre { route: Route::Energy { energy, velocities }, .. } =
        transform(graph, exchanged, degrees, false, &[]).ok()?
    else {
        return None;
    };
    let lagrangian = exchange.apply(graph, energy);
    let momenta = velocities.into_iter().map(|momentum| exchange.apply(graph, momentum)).collect();
    Some(Inverse { lagrangian, momenta })
}
