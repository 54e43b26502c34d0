//! Momenta of contact systems: J of degree 1 in p that commute with H for every s and t. J' = −J ∂H/∂s, so that all decay by one factor.

use super::momenta::{self, Momentum};
use crate::analyze::degree::Degrees;
use crate::analyze::{degree_in, identity};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Shape;

/// What decays by one factor.
#[derive(Debug)]
pub(crate) struct Dissipated {
    /// Coordinates that H does not read: their momenta decay so.
    pub(crate) cyclic: Vec<u32>,
    pub(crate) momenta: Vec<Momentum>,
    /// Whether H does, too.
    pub(crate) energy: bool,
}

/// The same of a Lagrangian L(q, v, s, t) that has no energy here: J' = J ∂L/∂s.
pub(crate) fn dissipated_by_velocities(graph: &mut Graph, lagrangian: Id, coordinates: &Shape) -> Option<Dissipated> {
    let momenta = super::noether(graph, lagrangian, coordinates);
    of(graph, lagrangian, coordinates, momenta)
}

/// Finds them, if there is an action that H reads.
pub(crate) fn dissipated(graph: &mut Graph, energy: Id, coordinates: &Shape) -> Option<Dissipated> {
    let degrees = Degrees::of(graph, &[energy], |symbol| matches!(symbol, Symbol::Position(_) | Symbol::Momentum(_)));
    let mut momenta = momenta::momenta(graph, &degrees, energy, coordinates);
    momenta.retain(|momentum| is_homogeneous(graph, momentum.value));
    of(graph, energy, coordinates, momenta)
}

/// −∂L/∂s, by which all of that decays.
pub(crate) fn decay(graph: &mut Graph, lagrangian: Id) -> Id {
    let growth = crate::diff::partial(graph, lagrangian, Symbol::Action);
    let terms: Vec<Id> = crate::analyze::terms(graph, growth).into_iter().map(|term| graph.neg(term)).collect();
    graph.sum(&terms)
}

/// With what is seen from what H or L reads.
fn of(graph: &Graph, root: Id, coordinates: &Shape, momenta: Vec<Momentum>) -> Option<Dissipated> {
    let read = graph.symbols(root);
    if !read.contains(&Symbol::Action) {
        return None;
    }
    let cyclic: Vec<u32> = (0..coordinates.len() as u32).filter(|i| !read.contains(&Symbol::Position(*i))).collect();
    let energy = !read.contains(&Symbol::Time);
    (energy || !cyclic.is_empty() || !momenta.is_empty()).then_some(Dissipated { cyclic, momenta, energy })
}

/// Whether a polynomial is of degree 1 in p in every term.
fn is_homogeneous(graph: &mut Graph, value: Id) -> bool {
    let of_p = |symbol: Symbol| matches!(symbol, Symbol::Momentum(_));
    let rest =
        Substitution::new(move |graph: &mut Graph, symbol| of_p(symbol).then(|| graph.zero())).apply(graph, value);
    degree_in(graph, value, of_p) == Some(1) && identity(graph, rest).is_zero()
}
