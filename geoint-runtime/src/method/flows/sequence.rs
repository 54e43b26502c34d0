//! A table prepared for steps of one length: a list of operations in order of application.

use super::driver::{Alternation, Outer};
use super::kinds::Flows;
use super::operation::{Operation, Reached};
use super::table::{Flow, Splitting};
use crate::method::{Failure, Probe, Step};
use crate::scalar::Real;
use crate::space::{Action, Summation};
use crate::system::Separable;

/// The flows of a step in order of application.
#[derive(Clone, Copy)]
pub struct Sequence<S: Separable<R>, R: Real, F: Flows<S, R>, const K: usize> {
    /// The first flow of a step that does not continue another step.
    first: Operation<S, R, F>,
    /// The flows after the first one, in pairs of an inner and an outer flow. The last one is the joint with the next step.
    pairs: [[Operation<S, R, F>; 2]; K],
    /// The last flow of a step that is not continued.
    last: Option<Operation<S, R, F>>,
    /// Whether the last flow and the first one are equal kicks that only add to momenta and only read positions; see `FlowKind::repeats`.
    pub(super) repeats: bool,
}

impl<S: Separable<R>, R: Real, F: Flows<S, R>, const K: usize> Sequence<S, R, F, K> {
    /// Prepares a table for steps of length `h`.
    pub(super) fn prepare(table: &Splitting<K, F>, system: &S, h: R) -> Self {
        let mut reached = Reached { own: 0.0, other: 0.0 };
        let first = Operation::prepare(system, h, table.entry(0), reached);
        let mut pairs = [[first; 2]; K];
        let operations = pairs.as_flattened_mut();
        for i in 1..=2 * K {
            // Own and other exchange their roles at every flow.
            reached = Reached { own: reached.other, other: reached.own + table.entry(i - 1).flow.fraction() };
            let (entry, mirror) = (table.entry(i), 2 * K - i);
            operations[i - 1] = if i == 2 * K {
                // All inner flows have reached the end of the step, without rounding.
                reached.other = 1.0;
                Operation::prepare(system, h, table.joint(), reached)
            } else if K < i && entry == table.entry(mirror) {
                // Equal flows are prepared once, because the preparation may compute a matrix.
                operations[mirror - 1].at_time(h, reached)
            } else {
                Operation::prepare(system, h, entry, reached)
            };
        }
        let (start, end) = (table.entry(0), table.entry(2 * K));
        let last = match end.flow.fraction() {
            0.0 => None,
            _ if end == start => Some(first.at_time(h, reached)),
            _ => Some(Operation::prepare(system, h, end, reached)),
        };
        let is_kick = matches!(start.flow, Flow::Kick(_));
        let repeats = S::Action::LEN == 0 && S::KICK.repeats() && is_kick && end == start && last.is_some();
        Sequence { first, pairs, last, repeats }
    }

    /// Returns the flows of a step that is not merged with others.
    pub(super) fn operations(&self) -> impl Iterator<Item = &Operation<S, R, F>> {
        [&self.first].into_iter().chain(&self.pairs.as_flattened()[..2 * K - 1]).chain(&self.last)
    }

    /// Returns whether each step ends with a kick that makes the state non-finite where the energy is not defined.
    pub(super) fn last_kick_shows_domain(&self) -> bool {
        F::SHOWS_DOMAIN && self.last.as_ref().is_some_and(Operation::is_kick)
    }
}

impl<S: Separable<R>, R: Real, F: Flows<S, R>, const K: usize> Alternation<S, R> for Sequence<S, R, F, K> {
    const INNER: usize = K;

    #[inline(always)]
    fn are_merged(&self) -> bool {
        true
    }

    #[inline(always)]
    fn shows_middle_of_joint(&self) -> bool {
        self.repeats
    }

    #[inline(always)]
    fn outer<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        place: Outer,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let operation = match place {
            Outer::First => Some(&self.first),
            Outer::Joint(i) => Some(&self.pairs[i][1]),
            Outer::Last => self.last.as_ref(),
        };
        // One call for all places: without optimisation, every call has a copy of the kernels on the stack.
        if let Some(operation) = operation {
            operation.apply(step);
        }
        Ok(())
    }

    #[inline(always)]
    fn inner<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        i: usize,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        self.pairs[i][0].apply(step);
        Ok(())
    }
}
