//! The tree discrete gradient: the method, its equation for the impulse, and the compensation of its sums.

use super::energy::{Energy, Slope};
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::{Claims, Method, Probe, Refusal, Step};
use crate::scalar::{Real, zero};
use crate::solving::linear;
use crate::solving::newton::Newton;
use crate::solving::size::Sizes;
use crate::space::{Array, Square};
use crate::space::{Compensated, Plain, Point, Summation, exact_sum};
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

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<S: DiscreteField<R>, R: Real> {
    newton: Newton<S::Unknown>,
    /// The energy is worth compensated sums, which cost a twentieth: at some step sizes the roundings of plain ones have a bias,
    /// and it drifts by 10⁻¹² in a million steps.
    sums: [Compensated<S::Array>; 2],
}

/// Coefficients of a step.
#[derive(Clone, Debug)]
pub struct Prepared<S: DiscreteField<R>, R: Real> {
    constants: S::Constants,
    parameters: S::Parameters,
    h: R,
    /// The inverse of the step's matrix, if that is constant.
    inverse: Square<S::Unknown>,
}

/// The equation of a step: the system, and what was prepared for it.
struct Equation<'a, S: DiscreteField<R>, R: Real> {
    system: &'a S,
    prepared: &'a Prepared<S, R>,
}

impl<S: DiscreteField<R>, R: Real> Clone for Equation<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: DiscreteField<R>, R: Real> Copy for Equation<'_, S, R> {}

impl<S: DiscreteField<R>, R: Real> Equation<'_, S, R> {
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
        self.system.drift(&self.prepared.parameters, &mean)
    }

    /// h·f̄ and Newton's matrix.
    #[inline(always)]
    fn evaluate(&self, start: &S::Start, d: &S::Unknown, image: &mut S::Unknown, matrix: &mut Square<S::Unknown>) {
        let Prepared { constants, parameters, h, .. } = self.prepared;
        self.system.equation((constants, *h), parameters, start, d, image, matrix);
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
        self.system.add(&self.prepared.constants, self.prepared.h, &mean, &mut change);
        change
    }

    /// The inverse of a matrix that is the same in all steps. NaN if there is none.
    fn inverse(&self) -> Square<S::Unknown> {
        let origin = S::Unknown::zero();
        let start = self.system.begin(&self.prepared.parameters, zero(), &origin);
        let (mut f, mut matrix) = (origin, S::Unknown::fill(origin));
        self.evaluate(&start, &origin, &mut f, &mut matrix);
        let mut inverse = S::Unknown::fill(origin);
        let sizes = Sizes::<S::Unknown>::of_blocks(&matrix);
        for j in 0..S::Unknown::LEN {
            let (mut lu, mut column) = (matrix, origin);
            column.as_mut_slice()[j] = R::from_f64(1.0);
            let solved = linear::solve(&mut lu, &mut column, &sizes) == Some(true);
            for (row, x) in S::Unknown::entries::<S::Unknown>(&mut inverse).iter_mut().zip(column.as_slice()) {
                row.as_mut_slice()[j] = if solved { *x } else { R::from_f64(f64::NAN) };
            }
        }
        inverse
    }
}

/// A step that is being solved.
struct Solving<'a, S: DiscreteField<R>, R: Real> {
    equation: Equation<'a, S, R>,
    start: &'a S::Start,
    t: R,
    q: &'a S::Array,
    p: &'a S::Array,
    changed: &'a S::Unknown,
    /// What y is too small by, if it is known.
    carry: Option<&'a S::Unknown>,
}

impl<S: DiscreteField<R>, R: Real> Solving<'_, S, R> {
    /// h·f̄ for an impulse, and the matrix of Newton's iteration.
    #[inline(always)]
    fn image<P: Probe<S, R>>(
        &self,
        probe: &mut P,
        impulse: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let mut change = self.equation.change(self.changed, impulse);
        let mut end = Point::<S::Array, Plain>::new(*self.q, *self.p);
        let [dq, dp] = S::increments(&change, impulse);
        end.add(&dq, &dp);
        probe.visit(self.t, &end.q, &end.p, &());
        if let Some(carry) = self.carry {
            // What counts is the mean y + d/2: f̄ depends on d itself only in second order.
            change.add_scaled(R::from_f64(2.0), carry);
        }
        let mut image = S::Unknown::zero();
        self.equation.evaluate(self.start, &change, &mut image, matrix);
        image
    }
}

impl<S: DiscreteField<R>, R: Real> Method<S, R> for DiscreteGradient {
    type Prepared = Prepared<S, R>;
    type Memory = Memory<S, R>;

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: false, conserves_energy: true }
    }

    fn prepare(&self, system: &S, h: R) -> Prepared<S, R> {
        let zero = S::Unknown::zero();
        let (constants, parameters) = (system.constants(), system.parameters(h));
        let mut prepared = Prepared { constants, parameters, h, inverse: S::Unknown::fill(zero) };
        if S::LINEAR {
            prepared.inverse = Equation { system, prepared: &prepared }.inverse();
        }
        prepared
    }

    fn memory() -> Memory<S, R> {
        Memory { newton: Newton::new(S::Array::LEN, 2), sums: [Compensated::new(); 2] }
    }

    #[inline(always)]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        prepared: &Prepared<S, R>,
        Memory { newton, sums }: &mut Memory<S, R>,
        Step { system, t, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let equation = Equation { system, prepared };
        let (none, h, half) = (S::Unknown::zero(), prepared.h, R::from_f64(0.5) * prepared.h);
        probe.visit(t, &x.q, &x.p, &());
        let (y, changed) = S::start(&x.q, &x.p);
        let start = system.begin(&prepared.parameters, t + half, &y);
        let (mut f, mut slope) = (none, S::Unknown::fill(none));

        if S::LINEAR {
            equation.evaluate(&start, &equation.change(&changed, &none), &mut f, &mut slope);
            let mut impulse = none;
            for (i, row) in S::Unknown::entries_of::<S::Unknown>(&prepared.inverse).iter().enumerate() {
                for (w, f) in row.as_slice().iter().zip(f.as_slice()) {
                    impulse.as_mut_slice()[i] = w.multiply_add(*f, impulse.as_slice()[i]);
                }
            }
            let [dq, dp] = S::increments(&equation.change(&changed, &impulse), &impulse);
            x.add_with(sums, [&dq, &dp], [&S::Array::zero(); 2]);
            return if impulse.is_finite() { Ok(()) } else { Err(Refusal::Singular) };
        }

        // The explicit midpoint rule.
        let constants = &prepared.constants;
        let explicit = move || {
            let (mut rate, mut f) = (system.velocity(constants, &changed), none);
            let mut slope = S::Unknown::fill(none);
            if S::DERIVATIVE == 1 {
                system.field(constants, t, &y, &mut rate, &mut slope);
            }
            let mut middle = y;
            middle.add_scaled(half, &rate);
            system.field(constants, t + half, &middle, &mut f, &mut slope);
            let mut impulse = none;
            impulse.add_scaled(h, &f);
            impulse
        };
        let (carry, carried) = S::start(&x.sums[0].carry(), &x.sums[1].carry());
        let seen = (!C::PLAIN).then_some(&carry);
        let solving = Solving { equation, start: &start, t, q: &x.q, p: &x.p, changed: &changed, carry: seen };
        let image = |probe: &mut P, impulse: &S::Unknown| solving.image(probe, impulse, &mut S::Unknown::fill(none));
        let derivative = |probe: &mut P, impulse: &S::Unknown, matrix: &mut Square<S::Unknown>| {
            solving.image(probe, impulse, matrix)
        };
        // −2p turns p round, and its mean is 0.
        let still = P::PATIENT.then_some(if S::DERIVATIVE == 1 { 0.0 } else { -2.0 });
        let (impulse, lost) = newton.solve((&changed, still), explicit, probe, image, derivative)?;
        let [dq, dp] = S::increments(&equation.change(&changed, &impulse), &impulse);
        let behind =
            if C::PLAIN && S::DERIVATIVE == 2 { none } else { equation.lost(&changed, &carried, &impulse, &lost) };
        let lost = S::increments(&behind, &lost);
        let (q, p) = (x.q, x.p);
        x.add_with(sums, [&dq, &dp], lost.each_ref());
        Refusal::outside(system.hidden_pole_between([t, t + h], [&q, &x.q], [&p, &x.p], [&(), &()]))
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
