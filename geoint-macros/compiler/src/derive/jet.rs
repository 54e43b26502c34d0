//! The Taylor coefficients of a solution, of every form whose rates are nodes.

use crate::analyze::crossings;
use crate::diff::jet::{self, Jet};
use crate::diff::{Gradient, by_velocities};
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::Legendre;
use crate::schedule::Routine;

/// With more series than this users would wait for code that is run slowly.
const MOST_SERIES: usize = 6000;

/// A program, and the values with which it starts.
#[derive(Debug)]
pub(crate) struct JetKernel {
    pub(crate) jet: Jet,
    pub(crate) start: Routine,
}

impl JetKernel {
    /// Of coordinates by their rates, in the form of them that takes the fewest sums. Steps end where the energy may jump, of which rates need
    /// not know.
    fn new(graph: &mut Graph, forms: &[Vec<(Symbol, Id)>], energy: Option<Id>) -> Option<JetKernel> {
        let edges = energy.map_or_else(Vec::new, |energy| crossings::edges_of_jumps(graph, energy));
        let watched: Vec<Id> = edges.iter().map(|edge| edge.difference).collect();
        let jets = forms.iter().map(|rates| jet::jet(graph, rates, &watched));
        let jet = jets.min_by_key(Jet::half_convolutions)?;
        let start = Routine::row("start", jet.values.clone());
        (jet.series.len() <= MOST_SERIES).then_some(JetKernel { jet, start })
    }

    /// Of x' = f(x, t), which may have an energy.
    pub(super) fn of_field(graph: &mut Graph, field: &[Id], energy: Option<Id>) -> Option<JetKernel> {
        let rates = (0..).map(Symbol::Position).zip(field.iter().copied()).collect();
        JetKernel::new(graph, &[rates], energy)
    }

    /// Of q' and p', and s' if there is an action, which are given one after the other.
    pub(super) fn canonical(graph: &mut Graph, forms: &[Vec<Id>], energy: Id, degrees: u32) -> Option<JetKernel> {
        let symbols =
            || (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum)).chain([Symbol::Action]);
        let forms: Vec<_> = forms.iter().map(|rates| symbols().zip(rates.iter().copied()).collect()).collect();
        JetKernel::new(graph, &forms, Some(energy))
    }
}

/// ∇H, and if it is another formula with ∂H/∂q in velocities.
pub(super) fn forms(graph: &mut Graph, energy: Id, gradient: &Gradient, legendre: Option<&Legendre>) -> Vec<Gradient> {
    let by_velocities = match legendre {
        Some(legendre) => legendre
            .forces
            .iter()
            .any(|force| graph.reads(*force).v)
            .then(|| by_velocities::of_lagrangian(graph, &legendre.forces, gradient)),
        None => by_velocities::of_energy(graph, energy, gradient),
    };
    [gradient.clone()].into_iter().chain(by_velocities).collect()
}
