//! The Taylor coefficients of a solution, of every form whose rates are nodes.

use crate::diff::Gradient;
use crate::diff::jet::{self, Jet};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule::{Kernel, Levels};

/// With more series than this users would wait for code that is run slowly.
const MOST_SERIES: usize = 6000;

/// A program, and the values with which it starts.
#[derive(Debug)]
pub(crate) struct JetKernel<K = Kernel> {
    pub(crate) jet: Jet,
    pub(crate) start: K,
}

impl JetKernel {
    /// Of coordinates by their rates.
    pub(super) fn new(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Option<JetKernel> {
        let jet = jet::jet(graph, rates);
        let start = Kernel::new(Levels::One, jet.values.clone());
        (jet.series.len() <= MOST_SERIES).then_some(JetKernel { jet, start })
    }

    /// Of x' = f(x, t).
    pub(super) fn of_field(graph: &mut Graph, field: &[Id]) -> Option<JetKernel> {
        let rates: Vec<(Symbol, Id)> = (0..).map(Symbol::Q).zip(field.iter().copied()).collect();
        JetKernel::new(graph, &rates)
    }

    /// Of q' = ∂H/∂p, p' = force.
    pub(super) fn canonical(graph: &mut Graph, gradient: &Gradient, force: &[Id]) -> Option<JetKernel> {
        let rates: Vec<(Symbol, Id)> = rates(&gradient.p, force).collect();
        JetKernel::new(graph, &rates)
    }

    /// Of a contact system, whose rates are given one after the other.
    pub(super) fn contact(graph: &mut Graph, all: &[Id]) -> Option<JetKernel> {
        let n = all.len() / 2;
        let rates: Vec<(Symbol, Id)> = rates(&all[..n], &all[n..2 * n]).chain([(Symbol::S, all[2 * n])]).collect();
        JetKernel::new(graph, &rates)
    }
}

/// Velocities and forces with what they are rates of.
fn rates(velocities: &[Id], forces: &[Id]) -> impl Iterator<Item = (Symbol, Id)> {
    let velocities = (0..).map(Symbol::Q).zip(velocities.iter().copied());
    velocities.chain((0..).map(Symbol::P).zip(forces.iter().copied()))
}

impl<K> JetKernel<K> {
    pub(super) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> JetKernel<L> {
        JetKernel { jet: self.jet, start: of(self.start) }
    }
}
