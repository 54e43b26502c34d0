//! Tables of Runge–Kutta–Nyström type, for a quadratic T.

use super::estimators::{Estimators, Mirrored};
use super::kinds::KickAndDrift;
use super::last_kick::{History, LastKick};
use super::open::Open;
use super::sequence::Sequence;
use super::steps_of;
use super::table::Splitting;
use crate::method::{Claims, Clock, Estimate, Failure, Handling, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Point, Summation};
use crate::system::QuadraticKinetic;
use core::marker::PhantomData;

/// A table that begins with a kick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickFirst;

/// A table that begins with a drift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftFirst;

/// A table of Runge–Kutta–Nyström type. Its order conditions use \[V, \[V, \[V, T\]\]\] = 0, so T must be quadratic.
///
/// `O` states which flow is the first. A table that begins with a drift also applies to two pieces; see [`Nystrom::of`].
#[doc(alias = "second order ODE")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nystrom<const K: usize, O = KickFirst> {
    table: Splitting<K>,
    estimators: Option<&'static Estimators<K>>,
    first: PhantomData<O>,
}

impl<const K: usize> Nystrom<K, KickFirst> {
    /// Returns a palindromic table without an error estimate; see [`Splitting::kick_first`].
    pub(in crate::method) const fn kick_first<const KICKS: usize, const DRIFTS: usize>(
        name: &'static str,
        order: u32,
        kicks: [f64; KICKS],
        drifts: [f64; DRIFTS],
    ) -> Self {
        let table = Splitting::kick_first(name, order, kicks, drifts);
        Nystrom { table, estimators: None, first: PhantomData }
    }
}

impl<const K: usize> Nystrom<K, DriftFirst> {
    /// Returns a palindromic table without an error estimate; see [`Splitting::drift_first`].
    pub(in crate::method) const fn drift_first<const DRIFTS: usize, const KICKS: usize>(
        name: &'static str,
        order: u32,
        drifts: [f64; DRIFTS],
        kicks: [f64; KICKS],
    ) -> Self {
        let table = Splitting::drift_first(name, order, drifts, kicks);
        Nystrom { table, estimators: None, first: PhantomData }
    }
}

impl<const K: usize, O> Nystrom<K, O> {
    /// States the orders of the table for H = A + εB; see [`Splitting::near_integrable`].
    pub(in crate::method) const fn near_integrable(mut self, orders: &'static [u32]) -> Self {
        self.table = self.table.near_integrable(orders);
        self
    }

    /// Adds an error estimate to the method.
    pub(in crate::method) const fn with_estimators(mut self, estimators: &'static Estimators<K>) -> Self {
        self.estimators = Some(estimators);
        self
    }

    /// Computes the weights of the error estimates from the differences dᵢ of the weights of kicks; see [`Estimators`].
    pub(in crate::method) const fn estimators<const HALF: usize>(&self, d: [Mirrored<HALF>; 2]) -> Estimators<K> {
        let (outer, last, inner) = self.table.coefficients();
        // The fractions of h that the drifts have reached at each kick.
        let (mut c, mut reached, mut n) = ([0.0; K], 0.0, 0);
        while n < K {
            if self.table.is_kick_first() {
                c[n] = reached;
                reached += inner[n];
            } else {
                reached += outer[n];
                c[n] = reached;
            }
            n += 1;
        }
        if self.table.is_kick_first() {
            Estimators::new((outer, last, &c), d)
        } else {
            Estimators::new((inner, 0.0, &c), d)
        }
    }

    /// The table.
    pub const fn table(&self) -> &Splitting<K> {
        &self.table
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
    S::Action::LEN == 0 && S::KICK.adds() && S::DRIFT.adds()
}

/// Returns the error of a step of length h from the time t, from the two sums of an estimate. The first sum is the error of the momenta. The second one has the
/// weights dᵢ(1 − cᵢ), and a drift of length h turns it into the error of the positions; see `Weights` in the module `estimators`.
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

impl<S: QuadraticKinetic<R>, R: Real, O: Copy, const K: usize> Method<S, R> for Nystrom<K, O> {
    type Proof = <S as QuadraticKinetic<R>>::Proof;
    type Prepared = Prepared<Sequence<S, R, KickAndDrift, K>, R, K>;
    type Memory = History<S::Array, S::Action>;
    const HANDLING: Handling = Handling::FASTER_SINGLY;

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
    fn shows_domain(prepared: &Self::Prepared) -> bool {
        <Splitting<K> as Method<S, R>>::shows_domain(&prepared.sequence)
    }

    fn memory(_: &S::Phase) -> Self::Memory {
        History { open: Open::unknown(), kick: LastKick::unknown() }
    }

    steps_of!(Splitting<K>, |prepared, memory| (&prepared.sequence, &mut memory.open));

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
        let sequence = &prepared.sequence;
        let mut known = if sequence.repeats { kick.impulse_at(&step.x.z[0]) } else { None };
        let (mut count, mut last) = (0, S::Array::zero());
        for operation in sequence.operations() {
            let impulse = operation.apply_and_report(step.part([step.t, step.end]), known.take());
            if let Some(impulse) = impulse {
                for (sums, weights) in sums.iter_mut().zip(estimators.of_kick(count)) {
                    for (sum, weight) in sums.iter_mut().zip(weights) {
                        sum.add_scaled(R::from_f64(weight), &impulse);
                    }
                }
                (count, last) = (count + 1, impulse);
            }
        }
        *kick = LastKick { known: true, q: step.x.z[0], impulse: last };
        Some(Ok(sums.map(|sums| error(step.system, [step.t, prepared.h], sums))))
    }
}
