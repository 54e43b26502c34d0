//! The driver of splitting tables: single steps, and loops of steps.
//!
//! The last flow of a step and the first flow of the next step are merged, within one call and between calls.

use super::between::Between;
use super::flows::Order;
use super::moving::{Moving, Times};
use super::sequence::Sequence;
use super::table::Splitting;
use crate::method::open::Open;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Array, Point, Summation};
use crate::system::Separable;

/// Largest number of positions for which a single step is inlined. In larger systems it is a function of its own.
const MAX_INLINED: usize = 4;

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Sequence<S, R, O, K> {
    const IS_OUT_OF_LINE: bool = S::Array::LEN > MAX_INLINED;

    /// Returns whether a round is a drift and the kick after it, in a table that begins with a drift. Loops of such rounds are faster.
    ///
    /// [`begin`](Self::begin) then applies the first drift and the first kick, and the rounds of a step end after its last kick. The result is false if drifts
    /// include the impulse of the kick before them: then a round is a kick and the drift after it.
    #[inline(always)]
    fn rounds_start_with_drift<C: Summation<S::Phase>>(&self) -> bool {
        O::DRIFT_IS_OUTER && !O::is_ahead::<C>(self.repeats)
    }

    /// Applies outer₁. If the step continues a step that started at the time `before`, outer₁ is merged with the last flow of that step.
    #[inline(always)]
    fn begin<C: Summation<S::Phase>>(&self, before: Option<R>, t: R, step: &mut Between<'_, S, R, C>) {
        step.enter(before.is_some());
        match before {
            None => O::outer(&self.first, Times { own: t, other: t }, step.moving()),
            Some(_) if O::is_ahead::<C>(self.repeats) => {}
            Some(before) => self.outer(K - 1, before, step.moving()),
        }
        if self.rounds_start_with_drift::<C>() {
            self.inner(0, t, step.moving());
        }
    }

    /// Applies inner₁, outer₂, inner₂, …, outer_K. If rounds start with a drift: outer₂, inner₂, …, outer_K, inner_K.
    #[inline(always)]
    fn between<C: Summation<S::Phase>>(&self, t: R, mut x: Moving<'_, S, R, C>) {
        for i in 0..K - 1 {
            self.round(i, [t; 2], x.again());
        }
    }

    /// Applies one round of the step that starts at the time `t`: the i-th inner flow, and the outer flow after it. If rounds start with a drift, it applies
    /// this outer flow and the next inner flow. The next inner flow belongs to the step that starts at the time `next`.
    #[inline(always)]
    fn round<C: Summation<S::Phase>>(&self, i: usize, [t, next]: [R; 2], mut x: Moving<'_, S, R, C>) {
        if self.rounds_start_with_drift::<C>() {
            self.outer(i, t, x.again());
            self.inner((i + 1) % K, next, x);
        } else {
            let [inner_at, outer_at] = self.times(t, i);
            O::both((&self.inner[i], inner_at), (&self.outer[i], outer_at), x);
        }
    }

    /// Applies inner_K, stores the point from which the next step continues, and applies the last flow to the state.
    #[inline(always)]
    fn end<C: Summation<S::Phase>>(&self, t: R, mut step: Between<'_, S, R, C>) {
        let [inner_at, outer_at] = self.times(t, K - 1);
        let (inner, last) = (&self.inner[K - 1], self.last.as_ref());
        if O::is_ahead::<C>(self.repeats) {
            return O::end_ahead((inner, inner_at), (last, &self.outer[K - 1]), outer_at, step);
        }
        if !self.rounds_start_with_drift::<C>() {
            O::inner(inner, inner_at, step.moving());
        }
        step.leave();
        step.show();
        if let Some(last) = last {
            O::outer(last, outer_at, Moving::of(step.system, step.x));
        }
    }

    /// Takes one step. Small systems move as a local copy.
    #[inline(always)]
    fn single<C: Summation<S::Phase>>(
        &self,
        open: &mut Open<S::Phase, S::Action>,
        system: &S,
        times: [R; 2],
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        if Between::<S, R, C>::MANY {
            return self.in_place(open, system, times, x);
        }
        let mut here = *x;
        self.in_place(open, system, times, &mut here);
        *x = here;
    }

    /// Takes one step by [`single`](Self::single), in a function of its own.
    #[inline(never)]
    fn single_out_of_line<C: Summation<S::Phase>>(
        &self,
        open: &mut Open<S::Phase, S::Action>,
        system: &S,
        times: [R; 2],
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        self.single(open, system, times, x);
    }

    /// Takes one step without a copy of the point.
    #[inline(always)]
    fn in_place<C: Summation<S::Phase>>(
        &self,
        open: &mut Open<S::Phase, S::Action>,
        system: &S,
        [t, end]: [R; 2],
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        let before = open.reopen(t, x);
        let mut step = Between::of(system, open, x);
        self.begin(before, t, &mut step);
        self.between(t, step.moving());
        self.end(t, step);
        open.end([t, end], x);
    }

    /// Takes one step that does not continue the step before, and reports its points to a probe.
    fn checked_step<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    ) {
        let mut outer = |flow, at: Times<R>, x: &mut _| {
            checked_flow(O::DRIFT_IS_OUTER, Step::at(at.other, (system, x, &mut *probe)), |x| O::outer(flow, at, x));
        };
        outer(&self.first, Times { own: t, other: t }, x);
        for i in 0..K {
            let [inner_at, outer_at] = self.times(t, i);
            let step = Step::at(inner_at.other, (system, &mut *x, &mut *probe));
            checked_flow(!O::DRIFT_IS_OUTER, step, |x| O::inner(&self.inner[i], inner_at, x));
            let flow = if i + 1 < K { Some(&self.outer[i]) } else { self.last.as_ref() };
            if let Some(flow) = flow {
                let step = Step::at(outer_at.other, (system, &mut *x, &mut *probe));
                checked_flow(O::DRIFT_IS_OUTER, step, |x| O::outer(flow, outer_at, x));
            }
        }
    }

    /// Takes `steps` steps with merged flows.
    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        &self,
        open: &mut Open<S::Phase, S::Action>,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        let Some(final_step) = steps.checked_sub(1) else { return };
        out_of_line(|| {
            let before = open.reopen(clock.at(0), x);
            self.begin(before, clock.at(0), &mut Between::of(system, open, x));
        });
        self.merged_steps(system, clock, final_step, Between::of(system, open, x).moving());
        out_of_line(|| {
            let [t, end] = [clock.at(final_step), clock.at(steps)];
            let mut step = Between::of(system, open, x);
            self.between(t, step.moving());
            self.end(t, step);
            open.end([t, end], x);
        });
    }

    /// Applies the i-th inner flow of a step that starts at the time `t`.
    #[inline(always)]
    fn inner<C: Summation<S::Phase>>(&self, i: usize, t: R, x: Moving<'_, S, R, C>) {
        O::inner(&self.inner[i], self.times(t, i)[0], x);
    }

    /// Applies the outer flow after the i-th inner flow of a step that starts at the time `t`.
    #[inline(always)]
    fn outer<C: Summation<S::Phase>>(&self, i: usize, t: R, x: Moving<'_, S, R, C>) {
        O::outer(&self.outer[i], self.times(t, i)[1], x);
    }

    /// Takes steps that begin and end with merged flows. This is a function, not a closure: the optimiser knows that its arguments do not alias.
    #[inline(never)]
    fn merged_steps<C: Summation<S::Phase>>(&self, system: &S, clock: &Clock<R>, steps: u64, x: Moving<'_, S, R, C>) {
        // This exit tells the optimiser that the loop below runs at least once.
        if steps == 0 {
            return;
        }
        // One coordinate moves in place. A local copy would be spilled around the call of a function such as the sine in each kick.
        if S::Array::LEN == 1 {
            return self.rounds(clock, steps, x);
        }
        // Local copies of more coordinates stay in registers.
        let (mut q, mut p, mut s) = (*x.q, *x.p, *x.s);
        let (mut sums, mut compensation) = (*x.sums, *x.compensation);
        let here = Moving { system, q: &mut q, p: &mut p, s: &mut s, sums: &mut sums, compensation: &mut compensation };
        self.rounds(clock, steps, here);
        (*x.q, *x.p, *x.s) = (q, p, s);
        (*x.sums, *x.compensation) = (sums, compensation);
    }

    /// Applies K rounds for each step.
    #[inline(always)]
    fn rounds<C: Summation<S::Phase>>(&self, clock: &Clock<R>, steps: u64, mut x: Moving<'_, S, R, C>) {
        for n in 0..steps {
            let t = clock.at(n);
            for i in 0..K {
                let next = if i + 1 < K { t } else { clock.at(n + 1) };
                self.round(i, [t, next], x.again());
            }
        }
    }
}

/// Runs `work` in a function of its own, so that it does not compete for registers with the loop over steps.
#[inline(never)]
fn out_of_line(work: impl FnOnce()) {
    work();
}

/// Applies a flow and reports its start to a probe. After a drift it also reports the parts of the drift that may end early.
#[inline(always)]
pub(super) fn checked_flow<S: Separable<R>, R: Real, C: Summation<S::Phase>, P: Probe<S, R>, T>(
    is_drift: bool,
    Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    flow: impl FnOnce(Moving<'_, S, R, C>) -> T,
) -> T {
    probe.visit(t, &x.z, &x.s);
    // The constant conditions remove this code from fast steps.
    let reports = P::EFFORT.is_thorough() && const { !S::DRIFT_PARTS.is_empty() } && is_drift && x.is_finite();
    let result = flow(Moving::of(system, x));
    if P::EFFORT.is_thorough() && const { !S::DRIFT_PARTS.is_empty() } && reports {
        for part in S::DRIFT_PARTS {
            probe.flown(part.name, || part.is_finite(&x.z));
        }
    }
    result
}

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Method<S, R> for Splitting<K, O> {
    type Proof = O::Proof;
    type Prepared = Sequence<S, R, O, K>;
    type Memory = Open<S::Phase, S::Action>;
    const SINGLY: bool = true;

    fn claims(&self) -> Claims {
        Splitting::claims(self)
    }

    fn name(&self) -> Name {
        Splitting::name(self)
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Sequence::prepare(self, system, h)
    }

    #[inline(always)]
    fn shows(prepared: &Self::Prepared) -> bool {
        O::SHOWS && prepared.last.is_some()
    }

    fn memory() -> Self::Memory {
        Open::unknown()
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        if P::EFFORT.is_thorough() {
            prepared.checked_step(step);
        } else {
            let Step { system, t, end, x, .. } = step;
            if Sequence::<S, R, O, K>::IS_OUT_OF_LINE {
                prepared.single_out_of_line(open, system, [t, end], x);
            } else {
                prepared.single(open, system, [t, end], x);
            }
        }
        Ok(())
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
        prepared.advance(open, system, clock, steps, x);
        Ok(())
    }
}
