//! Tables of Runge–Kutta–Nyström type, for a quadratic T.

use super::estimators::{Estimators, Mirrored};
use super::flows::{DriftFirst, KickFirst, Order};
use super::last_kick::{History, LastKick};
use super::sequence::Sequence;
use super::steps_of;
use super::table::Splitting;
use crate::method::open::Open;
use crate::method::{Claims, Clock, Estimate, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Point, Summation};
use crate::system::QuadraticKinetic;

/// A table of Runge–Kutta–Nyström type. Its order conditions use \[V, \[V, \[V, T\]\]\] = 0, so T must be quadratic.
#[doc(alias = "second order ODE")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nystrom<const K: usize, O = KickFirst> {
    table: Splitting<K, O>,
    estimators: Option<&'static Estimators<K>>,
}

impl<const K: usize, O> Nystrom<K, O> {
    /// Returns a method without an error estimate.
    pub(in crate::method) const fn new(table: Splitting<K, O>) -> Self {
        Nystrom { table, estimators: None }
    }

    /// Adds an error estimate to the method.
    pub(in crate::method) const fn estimated(mut self, estimators: &'static Estimators<K>) -> Self {
        self.estimators = Some(estimators);
        self
    }

    /// The table.
    pub const fn table(&self) -> &Splitting<K, O> {
        &self.table
    }
}

impl<const K: usize> Nystrom<K, KickFirst> {
    /// Computes the weights of the error estimates from the differences dᵢ of the weights of kicks; see [`Estimators`].
    pub(in crate::method) const fn estimators<const HALF: usize>(&self, d: [Mirrored<HALF>; 2]) -> Estimators<K> {
        let (mut c, mut n) = ([0.0; K], 1);
        while n < K {
            c[n] = c[n - 1] + self.table.inner[n - 1];
            n += 1;
        }
        Estimators::new((&self.table.outer, self.table.last, &c), d)
    }
}

impl<const K: usize> Nystrom<K, DriftFirst> {
    /// Computes the weights of the error estimates from the differences dᵢ of the weights of kicks; see [`Estimators`].
    pub(in crate::method) const fn estimators<const HALF: usize>(&self, d: [Mirrored<HALF>; 2]) -> Estimators<K> {
        let (mut c, mut n) = (self.table.outer, 1);
        while n < K {
            c[n] += c[n - 1];
            n += 1;
        }
        Estimators::new((&self.table.inner, 0.0, &c), d)
    }
}

/// Coefficients of a table for steps of length h, and the weights of its error estimates.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<T, R, const K: usize> {
    sequence: T,
    h: R,
    estimators: Option<&'static Estimators<K>>,
}

/// Returns whether kicks only add to momenta, drifts only add to positions, and there is no action. The impulses of kicks are then multiples of forces, as the
/// estimates need.
const fn has_pure_impulses<S: QuadraticKinetic<R>, R: Real>() -> bool {
    S::Action::LEN == 0 && S::KICKS_ADD && S::DRIFTS_SHIFT
}

/// Returns the error of a step of length h from the time t, from the two sums of an estimate. The first sum is the error of the momenta. The drift of the
/// second sum over h is the error of the positions; see `Weights` in the module `estimators`.
fn error<S: QuadraticKinetic<R>, R: Real>(
    system: &S,
    [t, h]: [R; 2],
    [momenta, before_drift]: [S::Array; 2],
) -> PerCoordinate<S::Phase, S::Action> {
    let drift = system.prepare_drift(h);
    let moved = |mut p: S::Array| {
        let (mut q, mut s) = (S::Array::zero(), S::Action::zero());
        system.drift(&drift, t, &mut q, &mut p, &mut s);
        q
    };
    let mut positions = moved(before_drift);
    positions.add_scaled(R::from_f64(-1.0), &moved(S::Array::zero()));
    PerCoordinate { z: [positions, momenta], s: S::Action::zero() }
}

impl<S: QuadraticKinetic<R>, R: Real, O: Order<S, R>, const K: usize> Method<S, R> for Nystrom<K, O> {
    type Proof = <S as QuadraticKinetic<R>>::Proof;
    type Prepared = Prepared<Sequence<S, R, O, K>, R, K>;
    type Memory = History<S::Array, S::Action>;
    const SINGLY: bool = true;

    fn claims(&self) -> Claims {
        self.table.claims()
    }

    fn name(&self) -> Name {
        self.table.name()
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { sequence: Method::prepare(&self.table, system, h), h, estimators: self.estimators }
    }

    #[inline(always)]
    fn shows(prepared: &Self::Prepared) -> bool {
        <Splitting<K, O> as Method<S, R>>::shows(&prepared.sequence)
    }

    fn memory() -> Self::Memory {
        History { open: Open::unknown(), kick: LastKick::unknown() }
    }

    steps_of!(Splitting<K, O>, |prepared, memory| (&prepared.sequence, &mut memory.open));

    fn order_of_estimate(&self) -> Option<u32> {
        self.estimators.filter(|_| const { has_pure_impulses::<S, R>() }).map(|_| self.table.claims().order)
    }

    #[inline]
    fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        History { kick, .. }: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Failure>> {
        let estimators = prepared.estimators.filter(|_| const { has_pure_impulses::<S, R>() })?;
        let mut sums = [[S::Array::zero(); 2]; 2];
        prepared.sequence.step_reporting_kicks(kick, step.part([step.t, step.end]), |n, impulse| {
            for (sums, weights) in sums.iter_mut().zip(estimators.of_kick(n)) {
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    sum.add_scaled(R::from_f64(weight), impulse);
                }
            }
        });
        Some(Ok(sums.map(|sums| error(step.system, [step.t, prepared.h], sums))))
    }
}
