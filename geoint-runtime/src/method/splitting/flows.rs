//! Kick and drift as the flows of a table: the outer flow and the inner flow.

use super::between::Between;
use super::kicks::{Kicks, Weight, WithoutGradient};
use super::moving::{Moving, Times};
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::{Array, Summation};
use crate::system::Separable;
use core::marker::PhantomData;

/// The outer flows are kicks, of the kind `F`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickFirst<F = WithoutGradient>(PhantomData<F>);

/// The outer flows are drifts; kicks are of the kind `F`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftFirst<F = WithoutGradient>(PhantomData<F>);

impl<F> Sealed for KickFirst<F> {}
impl<F> Sealed for DriftFirst<F> {}

/// Which of kick and drift is the outer flow.
///
/// Sealed: there are two flows.
pub trait Order<S: Separable<R>, R: Real>: Sealed + Copy {
    /// Whether drifts are the outer flows.
    const DRIFT_IS_OUTER: bool;
    /// Whether the outer flow adds to the momenta what positions alone decide.
    const REPEATS: bool;
    /// Whether the outer flow, where the energy is not defined, leaves momenta that are not finite.
    const SHOWS: bool;
    /// What it needs of the system; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of an outer flow.
    type Outer: Copy;
    /// Coefficients of an inner flow.
    type Inner: Copy;
    /// Prepares an outer flow.
    fn prepare_outer(system: &S, weight: Weight<R>) -> Self::Outer;
    /// Prepares an inner flow.
    fn prepare_inner(system: &S, weight: Weight<R>) -> Self::Inner;
    /// An outer flow.
    fn outer<C: Summation<S::Phase>>(flow: &Self::Outer, at: Times<R>, x: Moving<'_, S, R, C>);
    /// An inner flow.
    fn inner<C: Summation<S::Phase>>(flow: &Self::Inner, at: Times<R>, x: Moving<'_, S, R, C>);
    /// An inner flow and the outer one behind it.
    #[inline(always)]
    fn both<C: Summation<S::Phase>>(
        (inner, inner_at): (&Self::Inner, Times<R>),
        (outer, outer_at): (&Self::Outer, Times<R>),
        mut x: Moving<'_, S, R, C>,
    ) {
        Self::inner(inner, inner_at, x.again());
        Self::outer(outer, outer_at, x);
    }
    /// The last flows of a step that [is ahead](Self::is_ahead): inner and, if there is one, outer. `merged` is that one together with the first
    /// of the next step, which goes on behind it.
    #[inline(always)]
    fn end_ahead<C: Summation<S::Phase>>(
        (inner, inner_at): (&Self::Inner, Times<R>),
        (_, merged): (Option<&Self::Outer>, &Self::Outer),
        at: Times<R>,
        mut step: Between<'_, S, R, C>,
    ) {
        Self::inner(inner, inner_at, step.moving());
        step.show();
        // Both kicks are the same, and the state is in the middle of them: one force.
        if C::PLAIN {
            Self::outer(merged, at, step.beyond());
            for i in 0..S::Array::LEN {
                let p = &mut step.x.z[1].as_mut_slice()[i];
                *p = R::from_f64(0.5) * (*p + step.from.z[1].as_slice()[i]);
            }
        } else {
            let before = *step.x;
            let impulse = step.beyond().told(|x| Self::outer(merged, at, x));
            step.leave();
            *step.x = before;
            Moving::of(step.system, step.x).told(|x| x.p.add_scaled(R::from_f64(0.5), &impulse));
        }
    }
    /// Whether a step has done the first flow of the next one, because both steps need what that is computed from. `repeats` says that the last
    /// flow of a step and the first of the next are the same.
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
    /// Linear drifts take what the kick before has added.
    #[inline(always)]
    fn is_ahead<C: Summation<S::Phase>>(_: bool) -> bool {
        C::PLAIN && S::KICKS_ADD && S::DRIFTS_TAKE_KICKS
    }
}
