//! The method of a table: kicks and drifts in alternation, with the fractions of the table. The last flow of a step is merged with the first one of the next.

use super::driver;
use super::kinds::Flows;
use super::open::Open;
use super::sequence::Sequence;
use super::table::Splitting;
use crate::method::{Claims, Clock, Failure, Handling, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::Separable;

/// `K` is the number of inner flows of a step, and `F` the kind of the flows.
impl<S: Separable<R>, R: Real, F: Flows<S, R>, const K: usize> Method<S, R> for Splitting<K, F> {
    type Proof = F::Proof;
    type Prepared = Sequence<S, R, F, K>;
    /// The point before the last flow of a step.
    type Memory = Open<S::Phase, S::Action>;
    const HANDLING: Handling = Handling::FASTER_SINGLY;

    fn claims(&self) -> Claims {
        Splitting::claims(self)
    }

    fn name(&self) -> Name {
        Splitting::name(self)
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Sequence::prepare(self, system, h)
    }

    // A last kick evaluates the force at the end, so that a state outside of the domain is not finite.
    #[inline(always)]
    fn shows_domain(prepared: &Self::Prepared) -> bool {
        prepared.last_kick_shows_domain()
    }

    fn memory(_: &S::Phase) -> Self::Memory {
        Open::unknown()
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        driver::step(prepared, open, step)
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Failure> {
        driver::advance(prepared, open, system, clock, steps, x)
    }
}
