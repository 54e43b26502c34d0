//! H = A + B in kernels: the flow of A, kicks by B, and the way into the coordinates in which both move, and out of them.

use super::canonical::{impulse, increments};
use super::system::{FlowKernel, Missing};
use crate::analyze::reads;
use crate::diff;
use crate::ir::{Graph, Id, Symbol};
use crate::messages::NOT_NYSTROM_EXACT;
use crate::schedule::{Kernel, Levels};
use crate::split::{self, Clock, Division, NoExactPart};

/// A and B.
#[derive(Debug)]
pub(crate) struct Perturbed<K> {
    pub(crate) exact: Id,
    pub(crate) rest: Id,
    /// How the flow of A is known.
    pub(crate) known: Vec<String>,
    pub(crate) flow: FlowKernel<K>,
    /// Whether that flow is exact in its own time.
    pub(crate) exact_in_time: bool,
    pub(crate) kick: FlowKernel<K>,
    /// Whether a kick adds what positions alone decide.
    pub(crate) repeats: bool,
    pub(crate) gradient_kick: Result<FlowKernel<K>, Missing>,
    pub(crate) inner: Option<Inner<K>>,
}

/// Other coordinates than those of the state.
#[derive(Debug)]
pub(crate) struct Inner<K> {
    pub(crate) name: &'static str,
    pub(crate) enter: FlowKernel<K>,
    pub(crate) leave: FlowKernel<K>,
}

/// Kernels of both parts.
pub(super) fn kernels(graph: &mut Graph, division: &Division, degrees: u32) -> Result<Perturbed<Kernel>, Missing> {
    let parts = match division {
        Ok(parts) => parts,
        Err(NoExactPart { term, why }) => return Err(Missing { marker: "Parted", term: *term, why, pair: None }),
    };
    let changed = parts.flow.changed(graph).into_iter().filter(|(symbol, _)| *symbol != Symbol::S).collect();
    let gradient_kick = match &parts.velocity {
        Ok(velocity) => {
            let force: Vec<Id> =
                diff::gradient(graph, parts.rest, degrees).q.into_iter().map(|slope| graph.neg(slope)).collect();
            let kick = diff::gradient_kick(graph, parts.rest, &force, velocity);
            let impulse = weighted(graph, parts, kick.impulse);
            Ok(increments(graph, Symbol::P, &impulse))
        }
        Err(term) => Err(Missing { marker: "Gentle", term: *term, why: NOT_NYSTROM_EXACT, pair: None }),
    };
    Ok(Perturbed {
        exact: parts.exact,
        rest: parts.rest,
        known: parts.known.clone(),
        flow: FlowKernel::with_increments(graph, Levels::Prepared, changed),
        exact_in_time: parts.clock == Clock::Own,
        kick: {
            let impulse = impulse(graph, parts.rest, degrees);
            let impulse = weighted(graph, parts, impulse);
            increments(graph, Symbol::P, &impulse)
        },
        repeats: !reads(graph, parts.rest).t,
        gradient_kick,
        inner: parts.inner.as_ref().map(|inner| Inner {
            name: inner.name,
            enter: FlowKernel::new(Levels::One, inner.enter.clone()),
            leave: FlowKernel::new(Levels::One, inner.leave.clone()),
        }),
    })
}

/// What an impulse adds to what is in the place of momenta.
fn weighted(graph: &mut Graph, parts: &split::Perturbed, impulse: Vec<Id>) -> Vec<Id> {
    match &parts.inner {
        Some(inner) => impulse.into_iter().zip(&inner.weights).map(|(impulse, w)| graph.mul(*w, impulse)).collect(),
        None => impulse,
    }
}

impl<K> Perturbed<K> {
    pub(super) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Perturbed<L> {
        Perturbed {
            exact: self.exact,
            rest: self.rest,
            known: self.known,
            flow: self.flow.map(of),
            exact_in_time: self.exact_in_time,
            kick: self.kick.map(of),
            repeats: self.repeats,
            gradient_kick: self.gradient_kick.map(|flow| flow.map(of)),
            inner: self.inner.map(|inner| Inner {
                name: inner.name,
                enter: inner.enter.map(of),
                leave: inner.leave.map(of),
            }),
        }
    }
}
