//! The step of the polarised discrete gradient of a Lagrangian that is quadratic in v, L = ½vᵀM v + a·v − V, with or without an action s. M, a and V may
//! depend on q, s and the time t.
//!
//! The unknown is the row d of the increments of the velocity v and, if there is an action, of s. The equation relates v₁ to the momentum p₁ = ∂L/∂v at the
//! end of the step:
//!
//! M(q₁)v₁ + a(q₁) = p₁ with q₁ = q₀ + h v̄ and the mean v̄ of v₀ and v₁. [`PolarisedForm`] defines p₁ − p₀ and s₁ − s₀ as functions of d.
//!
//! A step solved for velocities has half of the unknowns of a step for (q, p), and needs no inverse of the mass matrix M. M may be indefinite. A step is
//! refused if a search finds that det M may vanish on its way; see [`Regular`].

use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Failure, Probe};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, extrapolated, moved, resized, scale_rows, scaled, sum};
use crate::space::{Action, Array, Record, Square, Tape};
use crate::system::{MassForm, PolarisedForm, Regular, mass_units, rates_of_velocity, velocity_near};

/// The step along the polarised discrete gradient.
#[derive(Clone, Copy, Debug)]
pub struct PolarisedStep;

/// A point of a run with its velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointWithVelocity<Z: Array, A> {
    /// The time at which M and a were evaluated.
    t: Z::Real,
    z: Z,
    v: A,
    /// 1/|Mᵢᵢ| at the last point for which [`with_velocity`] computed v. They only scale rows, so old values suffice.
    row_scales: A,
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for PointWithVelocity<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.scalar(&mut self.t);
        tape.array(&mut self.z);
        tape.array(&mut self.v);
        tape.array(&mut self.row_scales);
    }
}

/// Values that a step passes to the next one.
#[derive(Clone, Copy, Debug)]
pub struct History<Z: Array, A: Array> {
    /// The check that M stays regular in a run.
    regular: Regular<A>,
    /// The end of the last step, or the start of the current step.
    last: Option<PointWithVelocity<Z, A>>,
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for History<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        self.regular.record(tape);
        let none = || PointWithVelocity { t: zero(), z: Z::zero(), v: A::zero(), row_scales: A::zero() };
        tape.option(&mut self.last, none);
    }
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<C, A, D> {
    /// Coefficients of [`PolarisedForm`] that depend on the start.
    form: C,
    /// The velocity at the start.
    v: A,
    /// Factors of the rows of the equation: 1/|Mᵢᵢ|, so that row i has the unit of the velocity i, and 1 for the row of s. The first factor also has the
    /// sign of det M. The determinant of the equation is then positive for short steps, as the solver requires.
    row_scales: D,
}

/// Coefficients that depend on the parameters of the system and on h.
#[derive(Clone, Debug)]
pub struct Coefficients<P> {
    /// Coefficients of [`PolarisedForm`].
    form: P,
    /// True if M is proven to be positive definite everywhere. The checks of det M are then omitted.
    is_definite: bool,
}

/// The last evaluation: the unknown d, the increments of p and s, and the derivatives of these increments with respect to d.
#[derive(Clone, Copy, Debug)]
pub struct LastEvaluation<D: Array> {
    d: D,
    increments: D,
    by_d: Square<D>,
}

/// Returns whether the system has an action. A step then freezes time in its middle.
const fn has_action<S: PolarisedForm<R>, R: Real>() -> bool {
    <S::Action as Action<R>>::LEN > 0
}

/// Returns the times at which M and a are evaluated for the start and for the end of a step. Both are the time of the middle if there is an action.
#[inline(always)]
fn times<S: PolarisedForm<R>, R: Real>(from: &Departure<'_, S, R>) -> [R; 2] {
    if const { has_action::<S, R>() } { [from.middle(); 2] } else { [from.t, from.end] }
}

/// Returns the entry of s in a row of increments, or zero if there is no action.
#[inline(always)]
fn of_action<S: PolarisedForm<R>, R: Real>(d: &S::Increments) -> R {
    d.as_slice().get(S::Array::LEN).copied().unwrap_or_else(zero)
}

impl<S: PolarisedForm<R>, R: Real> Equation<'_, PolarisedStep, S, R> {
    /// Returns q₁ − q₀ = h (v₀ + d/2).
    #[inline(always)]
    fn shift(&self, d: &S::Increments) -> S::Array {
        scaled(self.from.h, &moved(&self.start.v, R::from_f64(0.5), &resized(d, zero())))
    }

    /// Returns the action s₀ at the start, or zero if there is no action.
    #[inline(always)]
    fn action(&self) -> R {
        self.from.s.scalar().unwrap_or_else(zero)
    }
}

impl<S: PolarisedForm<R>, R: Real> ImplicitStep<S, R> for PolarisedStep {
    type Unknown = S::Increments;
    type Coefficients = Coefficients<S::Parameters>;
    type Start = Start<S::Start, S::Array, S::Increments>;
    type History = History<S::Phase, S::Array>;
    type LastEvaluation = LastEvaluation<S::Increments>;
    type Kept = S::Kept;
    type Solver = Newton<S::Increments>;

    const POLICY: Policy = if has_action::<S, R>() {
        Policy { evaluated: Evaluated::AtTheEnd, ..Policy::of(Units { alike: S::Array::LEN, kinds: 2 }) }
    } else {
        Policy {
            // All solutions satisfy the energy balance. With friction C, H changes by −h v̄·C v̄.
            branch: Branch::OfEnergy,
            // The increment −2v₀ reverses v, so v̄ = 0, and q does not move.
            standstill: -2.0,
            sums: Sums::Compensated,
            evaluated: Evaluated::ByDifferences,
            ..Policy::of(Units { alike: S::Array::LEN, kinds: 1 })
        }
    };

    fn coefficients(self, system: &S, h: R) -> Coefficients<S::Parameters> {
        Coefficients { form: system.parameters(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        History { regular: Regular::unknown(), last: None }
    }

    fn no_evaluation() -> Self::LastEvaluation {
        let none = S::Increments::zero();
        LastEvaluation { d: none, increments: none, by_d: S::Increments::fill(none) }
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, S, R>,
        coefficients: &Self::Coefficients,
        history: &mut Self::History,
    ) -> Result<Self::Start, Failure> {
        let Departure { system, z, s, .. } = from;
        let sign = history.regular.begin(*system, coefficients.is_definite, (from.t, z, s))?;
        let [t, _] = times(from);
        // The velocity of the last end belongs to this start, unless M is evaluated at another time, as always with an action, or the point was moved.
        let point = match history.last {
            Some(last) if last.t == t && last.z == *z => last,
            last => with_velocity(*system, t, (*z, *s), last.map_or_else(S::Array::zero, |last| last.v))?,
        };
        history.last = Some(point);
        let PointWithVelocity { v, row_scales, .. } = point;
        let mut row_scales: S::Increments = resized(&row_scales, R::from_f64(1.0));
        row_scales.as_mut_slice()[0] *= sign;
        Ok(Start { form: system.begin(&coefficients.form, from.middle(), z, s, &v), v, row_scales })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Increments {
        resized(&equation.start.v, equation.action())
    }

    /// Returns the increments for constant rates v' and s'.
    fn guess(Equation { from, start, .. }: &Equation<'_, Self, S, R>) -> S::Increments {
        let [t, _] = times(from);
        let (acceleration, lagrangian) = rates_of_velocity(from.system, t, &from.z[0], &start.v, &from.s);
        scaled(from.h, &resized(&acceleration, lagrangian))
    }

    /// Returns the residual of the equation, with scaled rows, and stores the increments of p and s.
    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::LastEvaluation>,
        d: &S::Increments,
        matrix: &mut Square<S::Increments>,
    ) -> S::Increments {
        let Equation { from, coefficients, start } = equation;
        let s = S::Action::of(equation.action() + of_action::<S, R>(d));
        watch.visit(from.middle(), &[sum(&from.z[0], &equation.shift(d)), from.z[1]], &s);
        let (LastEvaluation { d: last, increments, by_d }, mut residual) = (&mut watch.last, S::Increments::zero());
        *last = *d;
        from.system.equation(&coefficients.form, &start.form, d, [&mut residual, increments], [matrix, by_d]);
        scale_rows(&start.row_scales, &mut residual, matrix);
        residual
    }

    /// Returns the increments. The increments of p and s are those of the last evaluation, corrected to first order by the last correction of d.
    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Increments>,
        LastEvaluation { d: last, increments, by_d }: &Self::LastEvaluation,
    ) -> Result<Increment<S::Phase, S::Action>, Failure> {
        let increments = extrapolated(increments, by_d, &difference(d, last));
        let z = [equation.shift(d), resized(&increments, zero())];
        Ok(Increment::of(z, S::Action::of(of_action::<S, R>(&increments))))
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, coefficients, start }: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Increments>,
        History { regular, last }: &mut Self::History,
        Arrival { z, s, .. }: Arrival<'_, S, R>,
    ) -> Result<(), Failure> {
        let (mut v, [_, t]) = (sum(&start.v, &resized(d, zero())), times(from));
        // Near a singular M the rounding of p changes the velocity. The velocity is therefore computed from the rounded momentum.
        if !coefficients.is_definite {
            regular.follow(from.system, false, [(from.t, &from.z, &from.s), (from.end, z, s)], v)?;
            v = velocity_near(from.system, t, z, s, v).ok_or(Failure::Singular)?;
        }
        *last = last.map(|last| PointWithVelocity { t, z: *z, v, ..last });
        Ok(())
    }
}

/// Returns a point with its velocity, which solves ∂L/∂v = p from `guess`, and with the scales of its rows.
///
/// # Errors
/// [`Failure::Singular`] if M is singular at the point, or the velocity is not finite.
#[inline(never)]
fn with_velocity<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    (z, s): (S::Phase, S::Action),
    guess: S::Array,
) -> Result<PointWithVelocity<S::Phase, S::Array>, Failure> {
    let v = velocity_near(system, t, &z, &s, guess).ok_or(Failure::Singular)?;
    Ok(PointWithVelocity { t, z, v, row_scales: mass_units(system, t, &z, &s, &v) })
}
