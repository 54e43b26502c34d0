//! Verlet's method for rigid bodies, with rotations about the principal axes in place of the exact flow of a free body.

use super::delegate;
use super::flows::Order;
use super::kicks::{Kicks, Weight, WithoutGradient};
use super::moving::{Moving, Times};
use super::table::{
    Flow::{Drift, Kick},
    Splitting,
};
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::{Point, Summation};
use crate::system::PrincipalAxes;

/// Half a kick, five rotations of every rigid body about its principal axes, half a kick. Order 2, symmetric, symplectic, one torque
/// a step. It needs no series and is cheaper than [`StormerVerlet`](crate::StormerVerlet), whose drift is the exact flow of the free
/// body. The error is about 1.5 times as large.
///
/// The rotations have order 2, so they would lower the order of higher-order tables. Only this method uses them.
/// A. Dullweber, B. Leimkuhler & R. McLachlan, J. Chem. Phys. 107 (1997) 5840.
#[doc(alias("rigid body splitting", "DLM"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FiveRotations;

impl FiveRotations {
    const TABLE: Splitting<1, KickAndRotations> = Splitting::<1, KickAndRotations>::kick_and_rotations();
}

/// The outer flows are kicks, the inner ones rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickAndRotations;

impl Sealed for KickAndRotations {}

impl Splitting<1, KickAndRotations> {
    const fn kick_and_rotations() -> Self {
        Self::of_flows(2, true, [Kick(0.5), Drift(1.0), Kick(0.5)])
    }
}

impl<S: PrincipalAxes<R>, R: Real> Order<S, R> for KickAndRotations {
    const DRIFT_IS_OUTER: bool = false;
    const REPEATS: bool = S::KICKS_REPEAT;
    const SHOWS: bool = false;
    type Proof = <S as PrincipalAxes<R>>::Proof;
    type Outer = S::Kick;
    type Inner = S::Drift;
    fn prepare_outer(system: &S, weight: Weight<R>) -> S::Kick {
        <WithoutGradient as Kicks<S, R>>::prepare(system, weight)
    }
    fn prepare_inner(system: &S, weight: Weight<R>) -> S::Drift {
        system.prepare_drift(weight.h)
    }
    #[inline(always)]
    fn outer<C: Summation<S::Phase>>(flow: &S::Kick, at: Times<R>, x: Moving<'_, S, R, C>) {
        x.kick::<WithoutGradient>(flow, at);
    }
    #[inline(always)]
    fn inner<C: Summation<S::Phase>>(flow: &S::Drift, _: Times<R>, x: Moving<'_, S, R, C>) {
        x.rotate(flow);
    }
}

delegate!([] FiveRotations, PrincipalAxes, Splitting<1, KickAndRotations>, |_this| FiveRotations::TABLE, Name::new(stringify!(FiveRotations)));
