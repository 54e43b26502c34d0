//! x₁ = x₀ + h (J − R) ∇̄H(x₀, x₁): steps that keep the energy to rounding, or lose what damping R takes.

mod coordinate_increment;
mod energy;
mod fourth_order;
mod gonzalez;
mod itoh_abe;
mod matrix;
mod mean;
mod mean_value;

pub use coordinate_increment::CoordinateIncrement;
pub use energy::{Energy, Slope, Staircase};
pub use fourth_order::FourthOrder;
pub use gonzalez::Gonzalez;
pub use itoh_abe::{ItohAbe, ItohAbeAdjoint, ItohAbePair, SymmetrisedItohAbe};
pub use matrix::Matrix;
pub use mean::MeanGradient;
pub use mean_value::MeanValue;

use crate::method::composition::substeps;
use crate::method::{Claims, Method, Probe, Refusal, check_poles, start};
use crate::scalar::{Real, zero};
use crate::solving::linear;
use crate::solving::newton::Newton;
use crate::space::{Array, Square};
use crate::space::{Compensated, Plain, Point, Summation, exact_sum};
use crate::system::{Conservative, DiscreteField, Guarded};

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with the tree discrete gradient: the energy is kept to rounding for every h.
///
/// Order 2, symmetric, for every H; not symplectic. ∇̄H is the reverse sweep of H with divided differences in place of
/// derivatives, in forms without cancellation. Quadratic and linear momenta that commute with the innermost quadratic
/// and linear forms in which H is written are kept as well: write central forces as functions of `x * x + y * y`. One
/// Newton solve a step, for half of the unknowns if T is quadratic. With damping C the energy falls by exactly h ∇̄H·C ∇̄H
/// instead (in compositions with steps back in time, only that of each of their steps is so balanced). T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020;
/// R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DiscreteGradient;

/// What a step needs.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<S: DiscreteField<R>, R: Real> {
    coefficients: Coefficients<S, R>,
    newton: Newton<S::Unknown>,
    /// The energy is worth compensated sums, which cost a twentieth: at some step sizes the roundings of plain ones have a bias,
    /// and it drifts by 10⁻¹² in a million steps.
    sums: [Compensated<S::Array>; 2],
}

#[derive(Clone, Copy, Debug)]
struct Coefficients<S: DiscreteField<R>, R: Real> {
    energy: Guarded<S>,
    system: S::Constants,
    tree: S::Parameters,
    h: R,
    /// The inverse of the step's matrix, if that is constant.
    inverse: Square<S::Unknown>,
}

impl<S: DiscreteField<R>, R: Real> Coefficients<S, R> {
    fn new(system: &S, h: R) -> Self {
        let zero = S::Unknown::zero();
        let (constants, tree) = (system.constants(), system.parameters(h));
        let mut prepared =
            Coefficients { energy: Guarded::new(system), system: constants, tree, h, inverse: S::Unknown::fill(zero) };
        if S::LINEAR {
            prepared.inverse = prepared.inverse();
        }
        prepared
    }

    /// The increment of y that goes with an impulse h·f̄ on `changed`: the impulse itself; or h ∂T/∂p at the mean momentum.
    ///
    /// That is one product with h/m. h p/m + h dp/2m is not the same: where h is 0.1, roundings of its two products do not
    /// average out, and the energy of a pendulum drifts by 10⁻¹² in a million steps.
    #[inline(always)]
    fn change(&self, changed: &S::Unknown, impulse: &S::Unknown) -> S::Unknown {
        if S::DERIVATIVE == 1 {
            return *impulse;
        }
        let mut mean = *changed;
        mean.add_scaled(R::from_f64(0.5), impulse);
        S::drift(&self.tree, &mean)
    }

    /// h·f̄ and Newton's matrix.
    #[inline(always)]
    fn equation(&self, start: &S::Start, d: &S::Unknown, image: &mut S::Unknown, matrix: &mut Square<S::Unknown>) {
        S::equation((&self.system, self.h), &self.tree, start, d, image, matrix);
    }

    /// What [`change`](Self::change) rounds off in the mean, and what it does not see because `changed` carries it.
    ///
    /// Without this, and with a field at y without its carry, the energy of a pendulum drifts by 4·10⁻²⁰ a step at h = 0.1, and by
    /// 10⁻¹⁹ at 0.2.
    #[inline(always)]
    fn lost(&self, changed: &S::Unknown, carry: &S::Unknown, impulse: &S::Unknown, lost: &S::Unknown) -> S::Unknown {
        if S::DERIVATIVE == 1 {
            return *lost;
        }
        let (mut mean, mut change, half) = (*carry, S::Unknown::zero(), R::from_f64(0.5));
        mean.add_scaled(half, lost);
        for (i, mean) in mean.as_mut_slice().iter_mut().enumerate() {
            *mean += exact_sum(changed.as_slice()[i], half * impulse.as_slice()[i]).1;
        }
        S::add(&self.system, self.h, &mean, &mut change);
        change
    }

    /// The inverse of a matrix that is the same in all steps. NaN if there is none.
    fn inverse(&self) -> Square<S::Unknown> {
        let origin = S::Unknown::zero();
        let start = S::begin(&self.tree, zero(), &origin);
        let (mut f, mut matrix) = (origin, S::Unknown::fill(origin));
        self.equation(&start, &origin, &mut f, &mut matrix);
        let mut inverse = S::Unknown::fill(origin);
        for j in 0..S::Unknown::LEN {
            let (mut lu, mut column) = (matrix, origin);
            column.as_mut_slice()[j] = R::from_f64(1.0);
            let solved = linear::solve::<S::Unknown>(&mut lu, &mut column) == Some(true);
            for (row, x) in S::Unknown::entries::<S::Unknown>(&mut inverse).iter_mut().zip(column.as_slice()) {
                row.as_mut_slice()[j] = if solved { *x } else { R::from_f64(f64::NAN) };
            }
        }
        inverse
    }
}

/// A step that is being solved.
struct Look<'a, S: DiscreteField<R>, R: Real> {
    coefficients: &'a Coefficients<S, R>,
    start: &'a S::Start,
    t: R,
    q: &'a S::Array,
    p: &'a S::Array,
    changed: &'a S::Unknown,
    /// What y is too small by, if it is known.
    carry: Option<&'a S::Unknown>,
}

impl<S: DiscreteField<R>, R: Real> Look<'_, S, R> {
    /// h·f̄ for an impulse, and the matrix of Newton's iteration.
    #[inline(always)]
    fn image<P: Probe<S, R>>(
        &self,
        probe: &mut P,
        impulse: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let mut change = self.coefficients.change(self.changed, impulse);
        let mut end = Point::<S::Array, Plain>::new(*self.q, *self.p);
        let [dq, dp] = S::increments(&change, impulse);
        end.add(&dq, &dp);
        probe.visit(self.t, &end.q, &end.p);
        if let Some(carry) = self.carry {
            // What counts is the mean y + d/2: f̄ depends on d itself only in second order.
            change.add_scaled(R::from_f64(2.0), carry);
        }
        let mut image = S::Unknown::zero();
        self.coefficients.equation(self.start, &change, &mut image, matrix);
        image
    }
}

impl<S: DiscreteField<R>, R: Real> Method<S, R> for DiscreteGradient {
    type Prepared = Prepared<S, R>;

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: false, conserves_energy: true }
    }

    fn prepare(&self, system: &S, h: R) -> Prepared<S, R> {
        Prepared { coefficients: Coefficients::new(system, h), newton: Newton::new(), sums: [Compensated::new(); 2] }
    }

    #[inline(always)]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        Prepared { coefficients: prepared, newton, sums }: &mut Prepared<S, R>,
        t: R,
        x: &mut Point<S::Array, C>,
        probe: &mut P,
    ) -> Result<(), Refusal> {
        let (none, h, half) = (S::Unknown::zero(), prepared.h, R::from_f64(0.5) * prepared.h);
        probe.visit(t, &x.q, &x.p);
        let (y, changed) = S::start(&x.q, &x.p);
        let begun = S::begin(&prepared.tree, t + half, &y);
        let (mut f, mut slope) = (none, S::Unknown::fill(none));

        if S::LINEAR {
            prepared.equation(&begun, &prepared.change(&changed, &none), &mut f, &mut slope);
            let mut impulse = none;
            for (i, row) in S::Unknown::entries::<S::Unknown>(&mut prepared.inverse).iter().enumerate() {
                for (w, f) in row.as_slice().iter().zip(f.as_slice()) {
                    impulse.as_mut_slice()[i] = w.multiply_add(*f, impulse.as_slice()[i]);
                }
            }
            let [dq, dp] = S::increments(&prepared.change(&changed, &impulse), &impulse);
            let before = start::<S, R, C>(x);
            x.add_with(sums, [&dq, &dp], [&S::Array::zero(); 2]);
            if !impulse.is_finite() {
                return Err(Refusal::Singular);
            }
            // Poles that the simplified energy has not.
            return check_poles(&prepared.energy, true, [t, t + h], &before, x, probe);
        }

        // The explicit midpoint rule.
        let system = prepared.system;
        let explicit = move || {
            let (mut rate, mut f) = (S::velocity(&system, &changed), none);
            let mut slope = S::Unknown::fill(none);
            if S::DERIVATIVE == 1 {
                S::field(&system, t, &y, &mut rate, &mut slope);
            }
            let mut middle = y;
            middle.add_scaled(half, &rate);
            S::field(&system, t + half, &middle, &mut f, &mut slope);
            let mut impulse = none;
            impulse.add_scaled(h, &f);
            impulse
        };
        let (carry, carried) = S::start(&x.sums[0].carry(), &x.sums[1].carry());
        let seen = (!C::PLAIN).then_some(&carry);
        let look = Look { coefficients: prepared, start: &begun, t, q: &x.q, p: &x.p, changed: &changed, carry: seen };
        let image = |probe: &mut P, impulse: &S::Unknown| look.image(probe, impulse, &mut S::Unknown::fill(none));
        let derivative =
            |probe: &mut P, impulse: &S::Unknown, matrix: &mut Square<S::Unknown>| look.image(probe, impulse, matrix);
        // −2p turns p round, and its mean is 0.
        let still = P::PATIENT.then_some(if S::DERIVATIVE == 1 { 0.0 } else { -2.0 });
        let (impulse, lost) = newton.solve((&changed, still), explicit, probe, image, derivative)?;
        let [dq, dp] = S::increments(&prepared.change(&changed, &impulse), &impulse);
        let behind =
            if C::PLAIN && S::DERIVATIVE == 2 { none } else { prepared.lost(&changed, &carried, &impulse, &lost) };
        let lost = S::increments(&behind, &lost);
        let before = start::<S, R, C>(x);
        x.add_with(sums, [&dq, &dp], lost.each_ref());
        check_poles(&prepared.energy, true, [t, t + h], &before, x, probe)
    }
}

/// The tree discrete gradient as others use it.
impl MeanGradient for DiscreteGradient {
    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &[S::Array; 2],
        d: &[S::Array; 2],
    ) -> Result<Slope<S::Array>, Refusal> {
        Ok(energy.tree(x, d))
    }
}

substeps!([] DiscreteGradient);
