//! The driver: a table multiplied by h, one step, and many steps with neighbouring flows merged.

use super::flows::{Moving, Order, Times, Weight};
use super::last_kick::LastKick;
use super::table::Splitting;
use crate::method::{Claims, Clock, Method, Name, Probe, Refusal, Step, Unwatched};
use crate::scalar::Real;
use crate::space::{Array, Point, Summation};
use crate::system::Separable;

/// Up to so many coordinates a call costs more than it saves.
const FEW: usize = 4;

/// A table multiplied by h: the flows of a step and the times in it at which they happen.
#[derive(Clone, Copy, Debug)]
pub struct Sequence<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> {
    pub(super) first: O::Outer,
    pub(super) inner: [O::Inner; K],
    /// What follows each inner flow while the steps go on: the last flow of a step is merged with the first of the next.
    pub(super) outer: [O::Outer; K],
    /// What follows the last inner flow where the steps end.
    pub(super) last: Option<O::Outer>,
    inner_at: [R; K],
    outer_at: [R; K],
    /// A step begins with the flow that the one before ended with, and that is what it was.
    pub(super) repeats: bool,
}

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Sequence<S, R, O, K> {
    const MANY: bool = S::Array::LEN > FEW;

    fn prepare(table: &Splitting<K, O>, system: &S, h: R) -> Self {
        let part = |fraction: f64| R::from_f64(fraction) * h;
        let (mut inner_at, mut outer_at) = ([h; K], [h; K]);
        let (mut outers, mut inners) = (0.0, 0.0);
        for i in 0..K {
            outers += table.outer[i];
            inners += table.inner[i];
            inner_at[i] = part(outers);
            if i + 1 < K {
                outer_at[i] = part(inners);
            }
        }
        let cube = h * h * h;
        let weight = |fraction: f64, gradient: f64| Weight {
            h: part(fraction),
            gradient: (gradient != 0.0).then(|| R::from_f64(gradient) * cube),
        };
        let outer = |(fraction, gradient)| O::prepare_outer(system, weight(fraction, gradient));
        let start = (table.outer[0], table.gradients[0]);
        let last = (table.last != 0.0).then_some((table.last, table.gradients[0]));
        let merged = last.map_or(start, |last| (start.0 + last.0, start.1 + last.1));
        let inner = |(fraction, gradient)| O::prepare_inner(system, weight(fraction, gradient));
        let between = |i| match i + 1 {
            next if next < K => (table.outer[next], table.gradients[next]),
            _ => merged,
        };
        let first = outer(start);
        Sequence {
            inner: mirrored(|i| (table.inner[i], table.gradients[i]), K, inner),
            outer: mirrored(between, K - 1, outer),
            last: last.map(|last| if last == start { first } else { outer(last) }),
            first,
            inner_at,
            outer_at,
            repeats: O::REPEATS && table.last == table.outer[0],
        }
    }

    /// The times of the i-th inner flow of a step from `t`, and of the outer flow behind it.
    #[inline(always)]
    pub(super) fn times(&self, t: R, i: usize) -> [Times<R>; 2] {
        let before = if i == 0 { t } else { t + self.outer_at[i - 1] };
        let (outers, inners) = (t + self.inner_at[i], t + self.outer_at[i]);
        [Times { own: before, other: outers }, Times { own: outers, other: inners }]
    }

    /// inner₁, outer₂, inner₂, …, inner_K.
    #[inline(always)]
    fn between<C: Summation<S::Phase>, P: Probe<S, R>>(&self, Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>) {
        for i in 0..K {
            let [inner_at, outer_at] = self.times(t, i);
            let (inner, outer) = (&self.inner[i], &self.outer[i]);
            if !P::PATIENT && i + 1 < K {
                O::both((inner, inner_at), (outer, outer_at), moving(system, x));
                continue;
            }
            seen(!O::DRIFT_IS_OUTER, Step::at(inner_at.other, (system, x, probe)), |x| O::inner(inner, inner_at, x));
            if i + 1 < K {
                seen(O::DRIFT_IS_OUTER, Step::at(outer_at.other, (system, x, probe)), |x| O::outer(outer, outer_at, x));
            }
        }
    }

    /// The same and last.
    #[inline(always)]
    fn finish<C: Summation<S::Phase>, P: Probe<S, R>>(&self, mut step: Step<'_, S, R, C, P>) {
        self.between(step.part([step.t; 2]));
        let Step { system, t, x, probe, .. } = step;
        if let Some(last) = &self.last {
            let [_, at] = self.times(t, K - 1);
            seen(O::DRIFT_IS_OUTER, Step::at(at.other, (system, x, probe)), |x| O::outer(last, at, x));
        }
    }

    /// The same for large systems, for the reason that [`end`](Self::end) has.
    #[inline(never)]
    fn single_apart<C: Summation<S::Phase>>(
        &self,
        kick: &mut LastKick<S::Array>,
        system: &S,
        t: R,
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        self.single(kick, system, t, x);
    }

    /// One step by itself. Its first kick is the last one of the step before, if that ended here: one force less.
    #[inline(always)]
    fn single<C: Summation<S::Phase>>(
        &self,
        kick: &mut LastKick<S::Array>,
        system: &S,
        t: R,
        x: &mut Point<S::Phase, C, S::Action>,
    ) {
        let (Some(last), true) = (&self.last, self.repeats && C::PLAIN) else {
            return self.step(Step::at(t, (system, x, &mut Unwatched)));
        };
        let one = R::from_f64(1.0);
        if kick.is_from(&x.z[0]) {
            x.z[1].add_scaled(one, &kick.impulse);
        } else {
            O::outer(&self.first, Times { own: t, other: t }, moving(system, x));
        }
        self.between(Step::at(t, (system, x, &mut Unwatched)));
        // Acting on zero, the flow gives the increment.
        (kick.known, kick.impulse) = (true, S::Array::nothing());
        kick.q.copy_from(&x.z[0]);
        let [_, at] = self.times(t, K - 1);
        let Point { z: [q, p], s, sums, compensation, .. } = x;
        O::outer(last, at, Moving { system, q, p: &mut kick.impulse, s, sums, compensation });
        p.add_scaled(one, &kick.impulse);
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(&self, step: Step<'_, S, R, C, P>) {
        let Step { system, t, x, probe, .. } = step;
        let at = Times { own: t, other: t };
        seen(O::DRIFT_IS_OUTER, Step::at(t, (system, x, probe)), |x| O::outer(&self.first, at, x));
        self.finish(Step::at(t, (system, x, probe)));
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        &self,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        point: &mut Point<S::Phase, C, S::Action>,
    ) {
        let Some(final_step) = steps.checked_sub(1) else { return };
        // In locals of this loop, q and p stay in registers.
        let ([mut q, mut p], mut s) = (point.z, point.s);
        let (mut sums, mut compensation) = (point.sums, point.compensation);
        macro_rules! x {
            () => {
                Moving { system, q: &mut q, p: &mut p, s: &mut s, sums: &mut sums, compensation: &mut compensation }
            };
        }
        let start = clock.at(0);
        O::outer(&self.first, Times { own: start, other: start }, x!());
        for n in 0..final_step {
            let t = clock.at(n);
            for i in 0..K {
                let [inner_at, outer_at] = self.times(t, i);
                O::both((&self.inner[i], inner_at), (&self.outer[i], outer_at), x!());
            }
        }
        (point.z, point.s) = ([q, p], s);
        (point.sums, point.compensation) = (sums, compensation);
        self.end(system, clock.at(final_step), point);
    }

    /// Apart from the loop, whose flows are then the only ones that the optimiser arranges registers for: inlined, this
    /// makes the loop over six bodies up to a fifth slower.
    #[inline(never)]
    fn end<C: Summation<S::Phase>>(&self, system: &S, t: R, x: &mut Point<S::Phase, C, S::Action>) {
        self.finish(Step::at(t, (system, x, &mut Unwatched)));
    }
}

/// What is prepared with some weights, of which the first ones are a palindrome or not: what is there already is copied, because a matrix takes
/// long to prepare.
fn mirrored<W: PartialEq, T: Copy, const K: usize>(
    weight: impl Fn(usize) -> W,
    palindrome: usize,
    prepare: impl Fn(W) -> T,
) -> [T; K] {
    let mut all = [prepare(weight(0)); K];
    for i in 1..K {
        let before = i < palindrome && palindrome <= 2 * i;
        all[i] = if before && weight(palindrome - 1 - i) == weight(i) {
            all[palindrome - 1 - i]
        } else {
            prepare(weight(i))
        };
    }
    all
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
    let named = P::PATIENT && const { !S::DRIFT_PARTS.is_empty() } && is_drift && x.is_finite();
    let told = flow(moving(system, x));
    if P::PATIENT && const { !S::DRIFT_PARTS.is_empty() } && named {
        for part in S::DRIFT_PARTS {
            probe.flown(part.name, || part.is_finite(&x.z));
        }
    }
    told
}

#[inline(always)]
fn moving<'a, S: Separable<R>, R: Real, C>(
    system: &'a S,
    x: &'a mut Point<S::Phase, C, S::Action>,
) -> Moving<'a, S, R, C> {
    let [q, p] = &mut x.z;
    Moving { system, q, p, s: &mut x.s, sums: &mut x.sums, compensation: &mut x.compensation }
}

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Method<S, R> for Splitting<K, O> {
    type Proof = O::Proof;
    type Prepared = Sequence<S, R, O, K>;
    type Memory = LastKick<S::Array>;
    const FORGETFUL: bool = true;

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
        LastKick::unknown()
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        kick: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        if P::PATIENT {
            prepared.step(step);
        } else if Sequence::<S, R, O, K>::MANY {
            prepared.single_apart(kick, step.system, step.t, step.x);
        } else {
            prepared.single(kick, step.system, step.t, step.x);
        }
        Ok(())
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        _: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Refusal> {
        prepared.advance(system, clock, steps, x);
        Ok(())
    }
}
