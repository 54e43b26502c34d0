//! The driver: one step, and many steps. Neighbouring ones share a flow, in one call and in many.

use super::between::Between;
use super::flows::Order;
use super::moving::{Moving, Times};
use super::sequence::Sequence;
use super::table::Splitting;
use crate::method::open::Open;
use crate::method::{Claims, Clock, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{Array, Point, Summation};
use crate::system::Separable;

/// Up to so many coordinates a call costs more than it saves.
const FEW: usize = 4;

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Sequence<S, R, O, K> {
    const MANY: bool = S::Array::LEN > FEW;

    /// Whether rounds of a step go from a drift to a kick although it begins with a drift: then that is followed by a kick, and steps end behind
    /// one. From a kick to a drift rounds of six bodies take up to a fifth longer. Drifts that take what kicks add stay behind these.
    #[inline(always)]
    fn behind_a_kick<C: Summation<S::Phase>>(&self) -> bool {
        O::DRIFT_IS_OUTER && !O::is_ahead::<C>(self.repeats)
    }

    /// outer₁, together with the last flow of the step that ended here, if one did: that began at the time `before`.
    #[inline(always)]
    fn begin<C: Summation<S::Phase>>(&self, before: Option<R>, t: R, step: &mut Between<'_, S, R, C>) {
        step.enter(before.is_some());
        match before {
            None => O::outer(&self.first, Times { own: t, other: t }, step.moving()),
            Some(_) if O::is_ahead::<C>(self.repeats) => {}
            Some(before) => self.outer(K - 1, before, step.moving()),
        }
        if self.behind_a_kick::<C>() {
            self.inner(0, t, step.moving());
        }
    }

    /// inner₁, outer₂, inner₂, …, outer_K.
    #[inline(always)]
    fn between<C: Summation<S::Phase>>(&self, t: R, mut x: Moving<'_, S, R, C>) {
        for i in 0..K - 1 {
            self.round(i, [t; 2], x.again());
        }
    }

    /// inner_i and the outer flow behind it, in a step from the time `t`, or that one and the next inner one, perhaps of a step from the time `next`.
    #[inline(always)]
    fn round<C: Summation<S::Phase>>(&self, i: usize, [t, next]: [R; 2], mut x: Moving<'_, S, R, C>) {
        if self.behind_a_kick::<C>() {
            self.outer(i, t, x.again());
            self.inner((i + 1) % K, next, x);
        } else {
            let [inner_at, outer_at] = self.times(t, i);
            O::both((&self.inner[i], inner_at), (&self.outer[i], outer_at), x);
        }
    }

    /// inner_K, behind which the next step goes on, and the last flow to the state.
    #[inline(always)]
    fn end<C: Summation<S::Phase>>(&self, t: R, mut step: Between<'_, S, R, C>) {
        let [inner_at, outer_at] = self.times(t, K - 1);
        let (inner, last) = (&self.inner[K - 1], self.last.as_ref());
        if O::is_ahead::<C>(self.repeats) {
            return O::end_ahead((inner, inner_at), (last, &self.outer[K - 1]), outer_at, step);
        }
        if !self.behind_a_kick::<C>() {
            O::inner(inner, inner_at, step.moving());
        }
        step.leave();
        step.show();
        if let Some(last) = last {
            O::outer(last, outer_at, Moving::of(step.system, step.x));
        }
    }

    /// One step.
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

    /// The same in a function of its own.
    #[inline(never)]
    fn single_apart<C: Summation<S::Phase>>(
        &self,
        open: &mut Open<S::Phase, S::Action>,
        system: &S,
        times: [R; 2],
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        self.single(open, system, times, x);
    }

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

    /// One step under the eyes of a probe, by itself.
    fn watched<C: Summation<S::Phase>, P: Probe<S, R>>(&self, Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>) {
        let mut outer = |flow, at: Times<R>, x: &mut _| {
            seen(O::DRIFT_IS_OUTER, Step::at(at.other, (system, x, &mut *probe)), |x| O::outer(flow, at, x));
        };
        outer(&self.first, Times { own: t, other: t }, x);
        for i in 0..K {
            let [inner_at, outer_at] = self.times(t, i);
            let step = Step::at(inner_at.other, (system, &mut *x, &mut *probe));
            seen(!O::DRIFT_IS_OUTER, step, |x| O::inner(&self.inner[i], inner_at, x));
            let flow = if i + 1 < K { Some(&self.outer[i]) } else { self.last.as_ref() };
            if let Some(flow) = flow {
                let step = Step::at(outer_at.other, (system, &mut *x, &mut *probe));
                seen(O::DRIFT_IS_OUTER, step, |x| O::outer(flow, outer_at, x));
            }
        }
    }

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
        apart(|| {
            let before = open.reopen(clock.at(0), x);
            self.begin(before, clock.at(0), &mut Between::of(system, open, x));
        });
        self.go_on(system, clock, final_step, Between::of(system, open, x).moving());
        apart(|| {
            let [t, end] = [clock.at(final_step), clock.at(steps)];
            let mut step = Between::of(system, open, x);
            self.between(t, step.moving());
            self.end(t, step);
            open.end([t, end], x);
        });
    }

    /// The i-th inner flow of a step from time `t`.
    #[inline(always)]
    fn inner<C: Summation<S::Phase>>(&self, i: usize, t: R, x: Moving<'_, S, R, C>) {
        O::inner(&self.inner[i], self.times(t, i)[0], x);
    }

    /// The outer flow behind it.
    #[inline(always)]
    fn outer<C: Summation<S::Phase>>(&self, i: usize, t: R, x: Moving<'_, S, R, C>) {
        O::outer(&self.outer[i], self.times(t, i)[1], x);
    }

    /// Steps that neither begin nor end: in a function of its own, whatever the caller does. Of its arguments, other than of what a closure holds,
    /// the optimiser knows that they are apart.
    #[inline(never)]
    fn go_on<C: Summation<S::Phase>>(&self, system: &S, clock: &Clock<R>, steps: u64, x: Moving<'_, S, R, C>) {
        // A loop that may not run at all is arranged in another way: Verlet's of two degrees of freedom takes a fifth longer.
        if steps == 0 {
            return;
        }
        // One coordinate moves where it is: as a local it is written and read back before the sine of each kick, a tenth of a pendulum's step.
        if S::Array::LEN == 1 {
            return self.rounds(clock, steps, x);
        }
        // In locals of this loop, q and p of more coordinates stay in registers: six bodies take two thirds of the time.
        let (mut q, mut p, mut s) = (*x.q, *x.p, *x.s);
        let (mut sums, mut compensation) = (*x.sums, *x.compensation);
        let here = Moving { system, q: &mut q, p: &mut p, s: &mut s, sums: &mut sums, compensation: &mut compensation };
        self.rounds(clock, steps, here);
        (*x.q, *x.p, *x.s) = (q, p, s);
        (*x.sums, *x.compensation) = (sums, compensation);
    }

    /// Their flows.
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

/// Work in a function of its own: the optimiser then arranges registers for that alone. Beside other flows the loop over six bodies is up to
/// a fifth slower.
#[inline(never)]
fn apart(work: impl FnOnce()) {
    work();
}

/// A flow under the eyes of a probe: a part of a drift that ends before its time is named.
#[inline(always)]
pub(super) fn seen<S: Separable<R>, R: Real, C: Summation<S::Phase>, P: Probe<S, R>, T>(
    is_drift: bool,
    Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    flow: impl FnOnce(Moving<'_, S, R, C>) -> T,
) -> T {
    probe.visit(t, &x.z, &x.s);
    // The constant first: nothing is compiled of what is not asked.
    let named = P::EFFORT.is_thorough() && const { !S::DRIFT_PARTS.is_empty() } && is_drift && x.is_finite();
    let told = flow(Moving::of(system, x));
    if P::EFFORT.is_thorough() && const { !S::DRIFT_PARTS.is_empty() } && named {
        for part in S::DRIFT_PARTS {
            probe.flown(part.name, || part.is_finite(&x.z));
        }
    }
    told
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
    ) -> Result<(), Refusal> {
        if P::EFFORT.is_thorough() {
            prepared.watched(step);
        } else {
            let Step { system, t, end, x, .. } = step;
            if Sequence::<S, R, O, K>::MANY {
                prepared.single_apart(open, system, [t, end], x);
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
    ) -> Result<(), Refusal> {
        prepared.advance(open, system, clock, steps, x);
        Ok(())
    }
}
