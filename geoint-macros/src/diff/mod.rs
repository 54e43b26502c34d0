//! Derivations on the graph: gradient, Hessian, divided differences, and the equations of implicit steps.

pub(crate) mod equation;
mod forward;
mod rules;
mod slope;
mod sweep;

use crate::analyze::Structure;
use crate::ir::{Graph, Id, Symbol};
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

/// A term that has no divided difference: there is none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MissingSlope(pub(crate) Id);

/// The tree discrete gradient of `root` between (q, p) and (q + dq, p + dp).
pub(crate) fn discrete_gradient(graph: &mut Graph, root: Id, degrees: u32) -> Result<Gradient, MissingSlope> {
    let entries = slope::Slopes::default().gradient(graph, root);
    Ok(collect(graph, &entries, degrees))
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
    pub(crate) tree: Result<equation::Equation, MissingSlope>,
    pub(crate) field: equation::Field,
}

/// Derives everything that some method needs.
pub(crate) fn derivatives(graph: &mut Graph, structure: &Structure, degrees: u32) -> Derivatives {
    let gradient = gradient(graph, structure.energy, degrees);
    let tree = equation::tree(graph, &gradient, structure, degrees);
    let field = equation::field(graph, &gradient, structure, degrees);
    Derivatives { gradient, tree, field }
}
