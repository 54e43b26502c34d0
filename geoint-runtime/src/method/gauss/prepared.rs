//! What every Gauss method prepares.

use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::scalar::Real;
use crate::system::{PhaseSpace, Poles};

/// The coefficients of one step, whatever its stages are solved for.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    pub(in crate::method) poles: Poles,
    pub(in crate::method) constants: P,
    pub(in crate::method) h: R,
    /// h·A.
    pub(in crate::method) coupling: [[R; S]; S],
    /// h·c.
    pub(in crate::method) nodes: [R; S],
    /// h·b.
    pub(in crate::method) weights: [R; S],
}

impl<P, R: Real, const S: usize> Prepared<P, R, S>
where
    Gauss<S>: GaussTableau<S>,
{
    pub(in crate::method) fn new<Y: PhaseSpace<R>>(system: &Y, constants: P, h: R) -> Self {
        let Tableau { a, b, c } = Gauss::<S>::TABLEAU;
        let times_h = |x: f64| R::from_f64(x) * h;
        Prepared {
            poles: Poles::of(system),
            constants,
            h,
            coupling: a.map(|row| row.map(times_h)),
            nodes: c.map(times_h),
            weights: b.map(times_h),
        }
    }
}

/// The coefficients of one step of a differential equation of first or second order.
#[derive(Clone, Copy, Debug)]
pub struct PreparedFields<P, R, const S: usize> {
    pub(super) stages: Prepared<P, R, S>,
    /// What stage j adds to stage i: h·A, or h²·A².
    pub(super) coupling: [[R; S]; S],
    /// What a stage adds to the end: h·b, or h²·b(1 − c).
    pub(super) increments: [R; S],
}
