//! Hermite interpolation within a step. It replaces a partial step for each state by one polynomial for each step.

use super::Dense;
use crate::running::StepError;
use crate::running::pace::PartialSteps;
use crate::running::run::Run;
use crate::running::trajectory::Scalar;
use crate::scalar::Real;
use crate::space::{PerCoordinate, Snapshot, normalisation};
use crate::system::{PhaseSpace, Rates, StateOf};

/// Maximum number of coefficients: states and rates at seven points, for methods of order 12.
const MOST_COEFFICIENTS: usize = 14;

/// A run whose steps have an interpolating polynomial.
///
/// For a method of order p, the polynomial has the states and rates of the run at p/2 + 1 points of a step. The inner points come from partial steps.
/// The error of the polynomial is O(hᵖ⁺²), above the order of a step. Invariants of the method are conserved at these points, and between them up to
/// this error.
pub trait Interpolated: Dense {
    /// Interpolating polynomial of a step.
    type Curve: Clone + core::fmt::Debug;

    /// Returns the polynomial of the step from `before` to `after`.
    ///
    /// # Errors
    /// Fails if a partial step is refused; see [`StepError`].
    fn curve(before: &Self, after: &Self) -> Result<Self::Curve, StepError>;

    /// Returns the state at a time within this step.
    fn on(&self, curve: &Self::Curve, t: Scalar<Self>) -> Self::State;
}

/// Way to compute states within a step.
pub(crate) trait Within<T: Dense> {
    /// Returns the value before the first step.
    fn new() -> Self;
    /// Called after each step of the run.
    fn stepped(&mut self) {}
    /// Returns the state at a time in the step from `before` to `after`.
    ///
    /// # Errors
    /// See [`StepError`].
    fn state(&mut self, before: &T, after: &T, t: Scalar<T>) -> Result<T::State, StepError>;
}

/// Computes states by [`Dense::between`].
#[derive(Clone, Copy, Debug)]
pub struct Exactly;

impl<T: Dense> Within<T> for Exactly {
    fn new() -> Self {
        Exactly
    }
    fn state(&mut self, before: &T, after: &T, t: Scalar<T>) -> Result<T::State, StepError> {
        T::between(before, after, t)
    }
}

/// Computes states by the polynomial of the last step. Cached, filled on demand.
#[derive(Clone, Debug)]
pub struct Curve<T: Interpolated>(Option<T::Curve>);

impl<T: Interpolated> Within<T> for Curve<T> {
    fn new() -> Self {
        Curve(None)
    }
    fn stepped(&mut self) {
        self.0 = None;
    }
    fn state(&mut self, before: &T, after: &T, t: Scalar<T>) -> Result<T::State, StepError> {
        if self.0.is_none() {
            self.0 = Some(T::curve(before, after)?);
        }
        match &self.0 {
            Some(curve) => Ok(after.on(curve, t)),
            None => T::between(before, after, t),
        }
    }
}

/// Hermite interpolant in Newton's form, with time as a fraction of the step. Every point counts twice.
#[derive(Clone, Copy, Debug)]
pub struct Hermite<Z, S, R> {
    start: R,
    length: R,
    /// Number of points, equally spaced.
    points: usize,
    coefficients: [PerCoordinate<Z, S>; MOST_COEFFICIENTS],
}

/// Computes the polynomial of degree 2n − 1 through states and rates at n points of a step, by divided differences.
fn hermite<T, S, R>(system: &S, order: u32, [before, after]: [&T; 2]) -> Result<CurveOf<S, R>, StepError>
where
    T: Dense<State = StateOf<S, R>>,
    S: PhaseSpace<R> + Rates<R>,
    R: Real,
{
    let n = (order as usize / 2 + 1).clamp(2, MOST_COEFFICIENTS / 2);
    let (start, end) = (before.time(), after.time());
    let length = end - start;
    let part = |i: usize| R::from_f64(i as f64 / (n - 1) as f64);
    let mut columns = [PerCoordinate::zero(); MOST_COEFFICIENTS];
    let mut rates = [PerCoordinate::zero(); MOST_COEFFICIENTS / 2];
    for i in 0..n {
        let state = match i {
            0 => before.state(),
            _ if i == n - 1 => after.state(),
            _ => T::between(before, after, start + part(i) * length)?,
        };
        let (t, z, s) = state.parts();
        let x = PerCoordinate { z, s };
        (columns[2 * i], columns[2 * i + 1]) = (x, x);
        rates[i] = system.rates(t, &x);
        rates[i].times(length);
    }
    // Compute the divided differences column by column, each from its last entry on.
    for order in 1..2 * n {
        for k in (order..2 * n).rev() {
            let gap = part(k / 2) - part((k - order) / 2);
            if gap.magnitude() == 0.0 {
                columns[k] = rates[k / 2];
            } else {
                let before = columns[k - 1];
                columns[k].add_scaled(R::from_f64(-1.0), &before);
                columns[k].times(R::from_f64(1.0) / gap);
            }
        }
    }
    Ok(Hermite { start, length, points: n, coefficients: columns })
}

/// Polynomial of a step of a system.
type CurveOf<S, R> = Hermite<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action, R>;

/// Returns the state of a polynomial at a time.
fn on<S: PhaseSpace<R>, R: Real>(curve: &CurveOf<S, R>, t: R) -> StateOf<S, R> {
    let part = (t - curve.start) / curve.length;
    let last = 2 * curve.points - 1;
    let mut x = curve.coefficients[last];
    for k in (0..last).rev() {
        x.times(part - R::from_f64((k / 2) as f64 / (curve.points - 1) as f64));
        x.add_scaled(R::from_f64(1.0), &curve.coefficients[k]);
    }
    if S::State::ATTITUDES {
        let (one, length) = (R::from_f64(1.0), normalisation::<S, R>(&x.z));
        x.add_scaled(one, &PerCoordinate { z: length, s: <S::Action as crate::space::Action<R>>::zero() });
    }
    S::State::of(t, x.z, x.s)
}

impl<P: PartialSteps> Interpolated for Run<P>
where
    P::System: Rates<P::Real>,
{
    type Curve = CurveOf<P::System, P::Real>;

    fn curve(before: &Self, after: &Self) -> Result<Self::Curve, StepError> {
        hermite(before.system(), before.pace.order(), [before, after])
    }

    fn on(&self, curve: &Self::Curve, t: P::Real) -> Self::State {
        on::<P::System, P::Real>(curve, t)
    }
}
