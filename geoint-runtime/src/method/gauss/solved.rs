//! The bound of systems that have Gauss methods with every number of stages.

use super::{Gauss, ImplicitMidpoint};
use crate::method::implicit::SolvedBy;
use crate::scalar::Real;
use crate::system::PhaseSpace;

/// A system with [`Gauss`] methods of 1 to 6 stages, and [`ImplicitMidpoint`]. Implemented automatically, as one bound for generic code.
pub trait SolvedByGauss<R: Real = f64>:
    PhaseSpace<R>
    + SolvedBy<Gauss<1>, R>
    + SolvedBy<Gauss<2>, R>
    + SolvedBy<Gauss<3>, R>
    + SolvedBy<Gauss<4>, R>
    + SolvedBy<Gauss<5>, R>
    + SolvedBy<Gauss<6>, R>
    + SolvedBy<ImplicitMidpoint, R>
{
}

impl<Y, R: Real> SolvedByGauss<R> for Y where
    Y: PhaseSpace<R>
        + SolvedBy<Gauss<1>, R>
        + SolvedBy<Gauss<2>, R>
        + SolvedBy<Gauss<3>, R>
        + SolvedBy<Gauss<4>, R>
        + SolvedBy<Gauss<5>, R>
        + SolvedBy<Gauss<6>, R>
        + SolvedBy<ImplicitMidpoint, R>
{
}
