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

use crate::array::{Array, Square};
use crate::composition::substeps;
use crate::linear;
use crate::method::{Claims, Method, Probe, Refusal};
use crate::newton::{self, Newton};
use crate::point::{Compensated, Plain, Point, Summation};
use crate::real::{Real, zero};
use crate::system::{Conservative, DiscreteField};

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
    energy: S,
    system: S::Constants,
    tree: S::Parameters,
    h: R,
    /// The inverse of the step's matrix, if that is constant.
    inverse: Square<S::Unknown>,
}

impl<S: DiscreteField<R>, R: Real> Coefficients<S, R> {
    fn new(system: &S, h: R) -> Self {
        let zero = S::Unknown::zero();
        let (constants, tree) = (system.constants(), system.parameters());
        let mut prepared =
            Coefficients { energy: *system, system: constants, tree, h, inverse: S::Unknown::fill(zero) };
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
        let (mut mean, mut change) = (*changed, S::Unknown::zero());
        mean.add_scaled(R::from_f64(0.5), impulse);
        change.add_scaled(self.h, &S::velocity(&self.system, &mean));
        change
    }

    /// h·(∂f̄/∂d)·(∂d/∂impulse) from ∂f̄/∂d.
    #[inline(always)]
    fn derivative(&self, jacobian: &mut Square<S::Unknown>) {
        let w = if S::DERIVATIVE == 1 { self.h } else { R::from_f64(0.5) * self.h * self.h };
        for row in S::Unknown::entries::<S::Unknown>(jacobian) {
            let slope = core::mem::replace(row, S::Unknown::zero());
            S::add(&self.system, w, &slope, row);
        }
    }

    /// The inverse of a matrix that is the same in all steps. NaN if there is none.
    fn inverse(&self) -> Square<S::Unknown> {
        let origin = S::Unknown::zero();
        let start = S::begin(&self.tree, zero(), &origin);
        let (mut f, mut matrix) = (origin, S::Unknown::fill(origin));
        S::slope(&self.tree, &start, &origin, &mut f, &mut matrix);
        self.derivative(&mut matrix);
        newton::one_minus::<S::Unknown>(&mut matrix);
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
}

impl<S: DiscreteField<R>, R: Real> Look<'_, S, R> {
    /// h·f̄ for an impulse, and ∂f̄/∂d.
    #[inline(always)]
    fn image<P: Probe<S, R>>(&self, probe: &mut P, impulse: &S::Unknown, slope: &mut Square<S::Unknown>) -> S::Unknown {
        let change = self.coefficients.change(self.changed, impulse);
        let mut end = Point::<S::Array, Plain>::new(*self.q, *self.p);
        let [dq, dp] = S::increments(&change, impulse);
        end.add(&dq, &dp);
        probe.visit(self.t, &end.q, &end.p);
        let (mut f, mut image) = (S::Unknown::zero(), S::Unknown::zero());
        S::slope(&self.coefficients.tree, self.start, &change, &mut f, slope);
        image.add_scaled(self.coefficients.h, &f);
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
        let start = S::begin(&prepared.tree, t + half, &y);
        let (mut f, mut slope) = (none, S::Unknown::fill(none));

        if S::LINEAR {
            S::slope(&prepared.tree, &start, &prepared.change(&changed, &none), &mut f, &mut slope);
            let mut impulse = none;
            for (i, row) in S::Unknown::entries::<S::Unknown>(&mut prepared.inverse).iter().enumerate() {
                for (w, f) in row.as_slice().iter().zip(f.as_slice()) {
                    impulse.as_mut_slice()[i] = w.multiply_add(h * *f, impulse.as_slice()[i]);
                }
            }
            let [dq, dp] = S::increments(&prepared.change(&changed, &impulse), &impulse);
            x.add_with(sums, [&dq, &dp], [&S::Array::zero(); 2]);
            return if impulse.is_finite() { Ok(()) } else { Err(Refusal::Singular) };
        }

        // The explicit midpoint rule.
        let explicit = || {
            let (mut rate, mut f) = (S::velocity(&prepared.system, &changed), none);
            let mut slope = S::Unknown::fill(none);
            if S::DERIVATIVE == 1 {
                S::field(&prepared.system, t, &y, &mut rate, &mut slope);
            }
            let (mut middle, mut impulse) = (y, none);
            middle.add_scaled(half, &rate);
            S::field(&prepared.system, t + half, &middle, &mut f, &mut slope);
            impulse.add_scaled(h, &f);
            impulse
        };
        let look = Look { coefficients: prepared, start: &start, t, q: &x.q, p: &x.p, changed: &changed };
        let image = |probe: &mut P, impulse: &S::Unknown| look.image(probe, impulse, &mut S::Unknown::fill(none));
        // −2p turns p round, and its mean is 0.
        let still = if S::DERIVATIVE == 1 { 0.0 } else { -2.0 };
        let (impulse, lost) =
            newton.solve((&changed, still), explicit, probe, image, |probe, impulse, derivative| {
                let image = look.image(probe, impulse, derivative);
                prepared.derivative(derivative);
                image
            })?;
        let [dq, dp] = S::increments(&prepared.change(&changed, &impulse), &impulse);
        let lost = S::increments(if S::DERIVATIVE == 1 { &lost } else { &none }, &lost);
        let (q, p) = (x.q, x.p);
        x.add_with(sums, [&dq, &dp], lost.each_ref());
        Refusal::outside(prepared.energy.hidden_pole_between([t, t + h], [&q, &x.q], [&p, &x.p]))
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
