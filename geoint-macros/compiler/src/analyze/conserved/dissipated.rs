//! Dissipated momenta of contact systems: functions J of degree 1 in p that commute with H for every s and t. J' = −J ∂H/∂s, so all decay by one
//! factor.

use super::momenta::{self, Conserved};
use crate::analyze::degree::Degrees;
use crate::analyze::separable::is_momentum;
use crate::analyze::{Structure, degree_in, identity, terms};
use crate::diff;
use crate::ir::substitute::at_zero;
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Shape;

/// The functions that decay by one common factor.
#[derive(Debug)]
pub(crate) struct Dissipated {
    /// Coordinates that H does not read. Their momenta decay.
    pub(crate) cyclic: Vec<u32>,
    /// Sums of momenta and angular momenta.
    pub(crate) momenta: Vec<Conserved>,
    /// Whether H decays.
    pub(crate) energy: bool,
}

impl Dissipated {
    /// Returns whether a function was found.
    pub(crate) fn is_some(&self) -> bool {
        self.energy || !self.cyclic.is_empty() || !self.momenta.is_empty()
    }
}

/// Finds the dissipated functions of a Lagrangian L(q, v, s, t) without an energy: J' = J ∂L/∂s.
pub(crate) fn dissipated_by_velocities(graph: &mut Graph, lagrangian: Id, coordinates: &Shape) -> Option<Dissipated> {
    let momenta = super::noether(graph, lagrangian, coordinates);
    with_cyclic(graph, lagrangian, coordinates, momenta)
}

/// Finds the dissipated functions of an energy that reads the action.
pub(crate) fn dissipated(graph: &mut Graph, energy: Id, coordinates: &Shape) -> Option<Dissipated> {
    let degrees = Degrees::of(graph, &[energy], Symbol::is_canonical);
    let mut momenta = momenta::momenta(graph, &degrees, energy, coordinates);
    momenta.retain(|momentum| is_homogeneous(graph, momentum.value));
    with_cyclic(graph, energy, coordinates, momenta)
}

/// Finds the dissipated functions of an energy H₀ + γ(t)·s with constraints. `kept` are the integrals of H₀ with the constraints. `steady` is true if nothing
/// reads time.
pub(crate) fn dissipated_on_constraints(graph: &mut Graph, kept: &mut Structure, steady: bool) -> Dissipated {
    let mut momenta = std::mem::take(&mut kept.momenta);
    momenta.retain(|momentum| is_homogeneous(graph, momentum.value));
    Dissipated { cyclic: std::mem::take(&mut kept.cyclic), momenta, energy: steady }
}

/// Builds the rate of decay −∂L/∂s.
pub(crate) fn decay(graph: &mut Graph, lagrangian: Id) -> Id {
    let growth = diff::partial_derivative(graph, lagrangian, Symbol::Action);
    let terms: Vec<Id> = terms(graph, growth).into_iter().map(|term| graph.neg(term)).collect();
    graph.sum(&terms)
}

/// Adds the functions that follow from the symbols that H or L does not read. `None` if nothing decays, or if the action is not read.
fn with_cyclic(graph: &Graph, root: Id, coordinates: &Shape, momenta: Vec<Conserved>) -> Option<Dissipated> {
    let read = graph.symbols(root);
    if !read.contains(&Symbol::Action) {
        return None;
    }
    let cyclic: Vec<u32> = (0..coordinates.len() as u32).filter(|i| !read.contains(&Symbol::Position(*i))).collect();
    let energy = !read.contains(&Symbol::Time);
    Some(Dissipated { cyclic, momenta, energy }).filter(Dissipated::is_some)
}

/// Returns whether every term of a polynomial has degree 1 in p.
fn is_homogeneous(graph: &mut Graph, value: Id) -> bool {
    let rest = at_zero(graph, value, is_momentum);
    degree_in(graph, value, is_momentum) == Some(1) && identity(graph, rest).is_zero()
}
