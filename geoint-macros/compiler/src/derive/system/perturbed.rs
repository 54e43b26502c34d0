//! What was derived of H = A + B.

use super::{FlowKernel, Missing};
use crate::ir::Id;
use crate::split::OwnMotion;
use std::ops::Range;

/// A and B.
#[derive(Debug)]
pub(crate) struct Perturbed<K> {
    pub(crate) exact: Id,
    pub(crate) rest: Id,
    /// Whether the flow of B is a kick.
    pub(crate) is_kick: bool,
    /// Whether it is the flow of B, or a step of order 2.
    pub(crate) is_exact: bool,
    /// Parts of the flow of A that may end within a step.
    pub(crate) parts: Vec<(OwnMotion, Range<usize>)>,
    /// How the flow of A is known.
    pub(crate) known: Vec<String>,
    pub(crate) flow: FlowKernel<K>,
    /// The same after momenta have grown by Dp, if that is a linear map: what momenta grow by is then waited for by one product and one sum.
    pub(crate) after: Option<FlowKernel<K>>,
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
    /// Masses, each with the sum that it is divided by.
    pub(crate) shares: Vec<[Id; 2]>,
    /// The values of all masses, then those of these, one after the other.
    pub(crate) weighed: K,
}

impl<K> Perturbed<K> {
    pub(in crate::derive) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Perturbed<L> {
        Perturbed {
            exact: self.exact,
            rest: self.rest,
            is_kick: self.is_kick,
            is_exact: self.is_exact,
            parts: self.parts,
            known: self.known,
            flow: self.flow.map(of),
            after: self.after.map(|after| after.map(of)),
            exact_in_time: self.exact_in_time,
            kick: self.kick.map(of),
            repeats: self.repeats,
            gradient_kick: self.gradient_kick.map(|flow| flow.map(of)),
            inner: self.inner.map(|inner| Inner {
                name: inner.name,
                enter: inner.enter.map(of),
                leave: inner.leave.map(of),
                shares: inner.shares,
                weighed: of(inner.weighed),
            }),
        }
    }
}
