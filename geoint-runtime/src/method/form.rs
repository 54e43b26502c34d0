//! Methods whose equation is posed in one way or another, as the system has it.

use crate::method::{Estimate, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{Record, Summation};
use crate::system::PhaseSpace;

/// How the method `M` finds a step of a system whose equations have this form: one of those in [`system`](crate::system), such as
/// [`ByField`](crate::system::ByField).
pub trait StepsOf<M, S: PhaseSpace<R>, R: Real> {
    /// Coefficients of a step.
    type Prepared: Clone;
    /// What a step hands on to the next one.
    type Memory: Clone + Record<R>;
    /// See [`Method::COMPOSES_TO`](super::Method::COMPOSES_TO).
    const COMPOSES_TO: u32 = u32::MAX;
    /// See [`Method::ROUGH_IF_SHORT`](super::Method::ROUGH_IF_SHORT).
    const ROUGH_IF_SHORT: bool = false;

    /// Coefficients for steps of length `h`.
    fn prepare(system: &S, h: R) -> Self::Prepared;

    /// The memory before the first step.
    fn memory() -> Self::Memory;

    /// One step, in place.
    ///
    /// # Errors
    /// Where the step has no result.
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal>;

    /// See [`Method::order_of_estimate`](super::Method::order_of_estimate).
    fn order_of_estimate() -> Option<u32> {
        None
    }

    /// See [`Method::estimated`](super::Method::estimated).
    #[inline(always)]
    fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        _prepared: &Self::Prepared,
        _memory: &mut Self::Memory,
        _step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Refusal>> {
        None
    }
}
