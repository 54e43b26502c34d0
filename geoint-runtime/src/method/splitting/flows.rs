//! Kick and drift as the outer and the inner flow of a table.

use super::between::Between;
use super::kicks::{Kicks, Weight, WithoutGradient};
use super::moving::{Moving, Times};
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::{Array, Summation};
use crate::system::Separable;
use core::marker::PhantomData;

/// The outer flows are kicks of the kind `F`, the inner flows are drifts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickFirst<F = WithoutGradient>(PhantomData<F>);

/// The outer flows are drifts, the inner flows are kicks of the kind `F`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftFirst<F = WithoutGradient>(PhantomData<F>);

impl<F> Sealed for KickFirst<F> {}
impl<F> Sealed for DriftFirst<F> {}

/// The alternation of a table: states which of kick and drift is the outer flow.
///
/// Sealed.
pub trait Order<S: Separable<R>, R: Real>: Sealed + Copy {
    /// Whether drifts are the outer flows.
    const DRIFT_IS_OUTER: bool;
    /// Whether the outer flow only adds an impulse that depends on positions alone. The last kick of a step and the first kick of the next are then equal.
    const REPEATS: bool;
    /// Whether the outer flow makes momenta non-finite at positions where the energy is not defined.
    const SHOWS: bool;
    /// The properties that the flows need of the system; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of an outer flow.
    type Outer: Copy;
    /// Coefficients of an inner flow.
    type Inner: Copy;
    /// Prepares an outer flow.
    fn prepare_outer(system: &S, weight: Weight<R>) -> Self::Outer;
    /// Prepares an inner flow.
    fn prepare_inner(system: &S, weight: Weight<R>) -> Self::Inner;
    /// Applies an outer flow.
    fn outer<C: Summation<S::Phase>>(flow: &Self::Outer, at: Times<R>, x: Moving<'_, S, R, C>);
    /// Applies an inner flow.
    fn inner<C: Summation<S::Phase>>(flow: &Self::Inner, at: Times<R>, x: Moving<'_, S, R, C>);
    /// Applies an inner flow and the outer flow after it.
    #[inline(always)]
    fn both<C: Summation<S::Phase>>(
        (inner, inner_at): (&Self::Inner, Times<R>),
        (outer, outer_at): (&Self::Outer, Times<R>),
        mut x: Moving<'_, S, R, C>,
    ) {
        Self::inner(inner, inner_at, x.again());
        Self::outer(outer, outer_at, x);
    }
    /// Ends a step that [is ahead](Self::is_ahead). The state gets the last inner flow and, if there is one, the last outer flow. The point of the next step
    /// gets the last inner flow and `merged`, the last outer flow together with the first one of the next step.
    #[inline(always)]
    fn end_ahead<C: Summation<S::Phase>>(
        (inner, inner_at): (&Self::Inner, Times<R>),
        (_, merged): (Option<&Self::Outer>, &Self::Outer),
        at: Times<R>,
        mut step: Between<'_, S, R, C>,
    ) {
        Self::inner(inner, inner_at, step.moving());
        step.show();
        // The merged kick consists of two equal kicks, so the state has half of its impulse. One evaluation of the force serves both points.
        if C::PLAIN {
            Self::outer(merged, at, step.beyond());
            for i in 0..S::Array::LEN {
                let p = &mut step.x.z[1].as_mut_slice()[i];
                *p = R::from_f64(0.5) * (*p + step.from.z[1].as_slice()[i]);
            }
        } else {
            let before = *step.x;
            let impulse = step.beyond().kick_and_report(|x| Self::outer(merged, at, x));
            step.leave();
            *step.x = before;
            Moving::of(step.system, step.x).kick_and_report(|x| x.p.add_scaled(R::from_f64(0.5), &impulse));
        }
    }
    /// Returns whether a step also applies the first flow of the next step, because both steps need the same force. `repeats` states that the last flow of a
    /// step equals the first flow of the next.
    #[inline(always)]
    fn is_ahead<C: Summation<S::Phase>>(repeats: bool) -> bool {
        repeats
    }
}

impl<S: Separable<R>, R: Real, F: Kicks<S, R>> Order<S, R> for KickFirst<F> {
    const DRIFT_IS_OUTER: bool = false;
    const REPEATS: bool = S::KICKS_REPEAT;
    const SHOWS: bool = S::KICKS_SHOW;
    type Proof = F::Proof;
    type Outer = F::Kick;
    type Inner = S::Drift;
    fn prepare_outer(system: &S, weight: Weight<R>) -> F::Kick {
        F::prepare(system, weight)
    }
    fn prepare_inner(system: &S, weight: Weight<R>) -> S::Drift {
        system.prepare_drift(weight.h)
    }
    #[inline(always)]
    fn outer<C: Summation<S::Phase>>(flow: &F::Kick, at: Times<R>, x: Moving<'_, S, R, C>) {
        x.kick::<F>(flow, at);
    }
    #[inline(always)]
    fn inner<C: Summation<S::Phase>>(flow: &S::Drift, at: Times<R>, x: Moving<'_, S, R, C>) {
        x.drift(flow, at);
    }
}

impl<S: Separable<R>, R: Real, F: Kicks<S, R>> Order<S, R> for DriftFirst<F> {
    const DRIFT_IS_OUTER: bool = true;
    const REPEATS: bool = false;
    const SHOWS: bool = false;
    type Proof = F::Proof;
    type Outer = S::Drift;
    type Inner = F::Kick;
    fn prepare_outer(system: &S, weight: Weight<R>) -> S::Drift {
        system.prepare_drift(weight.h)
    }
    fn prepare_inner(system: &S, weight: Weight<R>) -> F::Kick {
        F::prepare(system, weight)
    }
    #[inline(always)]
    fn outer<C: Summation<S::Phase>>(flow: &S::Drift, at: Times<R>, x: Moving<'_, S, R, C>) {
        x.drift(flow, at);
    }
    #[inline(always)]
    fn inner<C: Summation<S::Phase>>(flow: &F::Kick, at: Times<R>, x: Moving<'_, S, R, C>) {
        x.kick::<F>(flow, at);
    }
    #[inline(always)]
    fn both<C: Summation<S::Phase>>(
        (kick, kick_at): (&F::Kick, Times<R>),
        (drift, drift_at): (&S::Drift, Times<R>),
        mut x: Moving<'_, S, R, C>,
    ) {
        if Self::is_ahead::<C>(false) {
            let dp = x.again().impulse::<F>(kick, kick_at);
            x.drift_after(drift, drift_at, &dp);
        } else {
            Self::inner(kick, kick_at, x.again());
            Self::outer(drift, drift_at, x);
        }
    }
    #[inline(always)]
    fn end_ahead<C: Summation<S::Phase>>(
        (kick, kick_at): (&F::Kick, Times<R>),
        (last, merged): (Option<&S::Drift>, &S::Drift),
        at: Times<R>,
        mut step: Between<'_, S, R, C>,
    ) {
        let dp = step.moving().impulse::<F>(kick, kick_at);
        step.show();
        step.beyond().drift_after(merged, at, &dp);
        match last {
            Some(last) => Moving::of(step.system, step.x).drift_after(last, at, &dp),
            None => step.x.z[1].add_scaled(R::from_f64(1.0), &dp),
        }
    }
    /// A linear drift includes the impulse of the kick before it, for sums without compensation.
    #[inline(always)]
    fn is_ahead<C: Summation<S::Phase>>(_: bool) -> bool {
        C::PLAIN && S::KICKS_ADD && S::DRIFTS_TAKE_KICKS
    }
}
