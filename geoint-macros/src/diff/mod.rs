//! Derivations on the graph: gradient, Hessian, divided differences, and the field of implicit methods.

pub(crate) mod field;
mod forward;
mod rules;
mod slope;
mod sweep;

use crate::analyze::Structure;
use crate::ir::{Graph, Id, Symbol};
pub(crate) use field::{Field, SecondOrder};
#[cfg(test)]
pub(crate) use forward::jacobian;

/// The partial derivatives of a node with respect to positions and momenta.
#[derive(Clone, Debug)]
pub(crate) struct Gradient {
    pub(crate) q: Vec<Id>,
    pub(crate) p: Vec<Id>,
}

/// ∇ of `root` by one reverse sweep.
pub(crate) fn gradient(graph: &mut Graph, root: Id, degrees: u32) -> Gradient {
    let entries = sweep::gradient(graph, root);
    collect(graph, &entries, degrees)
}

/// The tree discrete gradient of `root` between (q, p) and (q + dq, p + dp).
pub(crate) fn discrete_gradient(graph: &mut Graph, root: Id, degrees: u32) -> Gradient {
    let entries = slope::Slopes::default().gradient(graph, root);
    collect(graph, &entries, degrees)
}

fn collect(graph: &mut Graph, entries: &sweep::Entries, degrees: u32) -> Gradient {
    let mut all = |symbol: fn(u32) -> Symbol| {
        (0..degrees).map(|i| entries.get(&symbol(i)).copied().unwrap_or_else(|| graph.zero())).collect()
    };
    Gradient { q: all(Symbol::Q), p: all(Symbol::P) }
}

/// Everything that is derived from an energy.
pub(crate) struct Derivatives {
    pub(crate) gradient: Gradient,
    pub(crate) field: Field,
    pub(crate) discrete: Field,
    pub(crate) second_order: Option<SecondOrder>,
}

/// Derives everything that some method needs.
pub(crate) fn derivatives(graph: &mut Graph, structure: &Structure, degrees: u32) -> Derivatives {
    let gradient = gradient(graph, structure.energy, degrees);
    let field = field::field(graph, &gradient, structure, degrees);
    let discrete = field::discrete(graph, structure, degrees);
    let second_order = field::second_order(graph, &gradient, structure, degrees);
    Derivatives { gradient, field, discrete, second_order }
}
