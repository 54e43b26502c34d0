//! Programs that compute the Taylor coefficients of a solution.

use crate::analyze::crossings;
use crate::diff::jet::{self, Jet};
use crate::diff::{Gradient, by_velocities};
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::Legendre;
use crate::schedule::Routine;

/// The largest number of series in a program. Larger programs compile slowly, and the emitted code runs slowly.
const MOST_SERIES: usize = 6000;

/// A program and its initial values.
#[derive(Debug)]
pub(crate) struct JetKernel {
    pub(crate) jet: Jet,
    pub(crate) start: Routine,
}

impl JetKernel {
    /// Creates a program from the rates of coordinates. If several forms of the rates are known, the form with the fewest sums is used. A step ends where
    /// the energy may jump. These conditions are observed explicitly, because rates may not contain them.
    fn new(graph: &mut Graph, forms: &[Vec<(Symbol, Id)>], energy: Option<Id>) -> Option<JetKernel> {
        let edges = energy.map_or_else(Vec::new, |energy| crossings::edges_of_jumps(graph, energy));
        let observed: Vec<Id> = edges.iter().map(|edge| edge.difference).collect();
        let jets = forms.iter().map(|rates| jet::jet(graph, rates, &observed));
        let jet = jets.min_by_key(Jet::half_convolutions)?;
        let start = Routine::row("start", jet.values.clone());
        (jet.series.len() <= MOST_SERIES).then_some(JetKernel { jet, start })
    }

    /// Creates the program of x' = f(x, t).
    pub(super) fn of_field(graph: &mut Graph, field: &[Id], energy: Option<Id>) -> Option<JetKernel> {
        let rates = (0..).map(Symbol::Position).zip(field.iter().copied()).collect();
        JetKernel::new(graph, &[rates], energy)
    }

    /// Creates the program of a system with momenta. Each form lists the rates of q, p, and s if there is an action.
    pub(super) fn canonical(graph: &mut Graph, forms: &[Vec<Id>], energy: Id, degrees: u32) -> Option<JetKernel> {
        let symbols =
            || (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum)).chain([Symbol::Action]);
        let forms: Vec<_> = forms.iter().map(|rates| symbols().zip(rates.iter().copied()).collect()).collect();
        JetKernel::new(graph, &forms, Some(energy))
    }
}

/// Returns ∇H, and a second form with ∂H/∂q as a function of velocities if that is another formula.
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
