//! The tableau of a Gauss method for steps of one length h.

use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::scalar::Real;

/// The coefficients A, nodes c and weights b times h, computed once for each h. The tableau has the accuracy of `f64` for every `R`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scaled<R, const S: usize> {
    /// h·A.
    pub(crate) coupling: [[R; S]; S],
    /// h·c.
    pub(crate) nodes: [R; S],
    /// h·b.
    pub(crate) weights: [R; S],
}

impl<R: Real, const S: usize> Scaled<R, S>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Returns the tableau times `h`.
    pub(crate) fn by(h: R) -> Self {
        let Tableau { a, b, c } = Gauss::<S>::TABLEAU;
        let times_h = |x: f64| R::from_f64(x) * h;
        Scaled { coupling: a.map(|row| row.map(times_h)), nodes: c.map(times_h), weights: b.map(times_h) }
    }
}
