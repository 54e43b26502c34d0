//! The step of the polarised discrete gradient of a Lagrangian that is quadratic in v, with or without an action. The unknowns are the increments d of v, and of s:
//!
//! M(q₁)v₁ + a(q₁) = p₁ with q₁ = q₀ + h v̄, v₁ = v₀ + d and v̄ = v₀ + d/2. [`PolarisedForm`] defines p₁ − p₀ and s₁ − s₀.

use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, extrapolated, moved, resized, scale_rows, scaled, sum};
use crate::space::{Action, Array, Record, Square, Tape};
use crate::system::{MassForm, PolarisedForm, Regular, mass_units, rates_of_velocity, velocity_near};

/// The step along the polarised discrete gradient.
#[derive(Clone, Copy, Debug)]
pub struct PolarisedStep;

/// A point with its velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known<Z: Array, A> {
    /// The time at which M and a are evaluated.
    t: Z::Real,
    z: Z,
    v: A,
    /// 1/|Mᵢᵢ| at the last point whose velocity was solved for from p. These are scales only, so they need not be new.
    units: A,
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for Known<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.scalar(&mut self.t);
        tape.array(&mut self.z);
        tape.array(&mut self.v);
        tape.array(&mut self.units);
    }
}

/// The mass matrix of the run, and the end of the last step.
#[derive(Clone, Copy, Debug)]
pub struct History<Z: Array, A: Array> {
    regular: Regular<A>,
    last: Option<Known<Z, A>>,
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for History<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        self.regular.record(tape);
        tape.option(&mut self.last, || Known { t: zero(), z: Z::zero(), v: A::zero(), units: A::zero() });
    }
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<K, A, D> {
    kernel: K,
    v: A,
    /// Scales of the rows: a row over |Mᵢᵢ| has the unit of the velocity, and the row of s has the scale 1. The sign of det M on the first row makes the determinant
    /// of the equation positive.
    scales: D,
}

/// Values that depend on parameters and h.
#[derive(Clone, Debug)]
pub struct Constants<P> {
    parameters: P,
    /// The mass matrix is positive definite everywhere.
    is_definite: bool,
}

/// The last evaluation: d, the increments of p and s, and their derivatives by d.
#[derive(Clone, Copy, Debug)]
pub struct Seen<D: Array> {
    d: D,
    increments: D,
    by_d: Square<D>,
}

/// Whether the system has an action. Time is then frozen in the middle of a step.
const fn has_action<S: PolarisedForm<R>, R: Real>() -> bool {
    <S::Action as Action<R>>::LEN > 0
}

/// Returns the times at which M and a are evaluated at the start and at the end of a step.
#[inline(always)]
fn times<S: PolarisedForm<R>, R: Real>(from: &Departure<'_, S, R>) -> [R; 2] {
    if const { has_action::<S, R>() } { [from.middle(); 2] } else { [from.t, from.end] }
}

/// Returns the part of a row that belongs to s.
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

    /// Returns s₀, or zero.
    #[inline(always)]
    fn action(&self) -> R {
        self.from.s.scalar().unwrap_or_else(zero)
    }
}

impl<S: PolarisedForm<R>, R: Real> ImplicitStep<S, R> for PolarisedStep {
    type Unknown = S::Increments;
    type Constants = Constants<S::Parameters>;
    type Start = Start<S::Start, S::Array, S::Increments>;
    type History = History<S::Phase, S::Array>;
    type Seen = Seen<S::Increments>;
    type Kept = S::Kept;
    type Solver = Newton<S::Increments>;

    const POLICY: Policy = if has_action::<S, R>() {
        Policy::of(Units { alike: S::Array::LEN, kinds: 2 })
    } else {
        Policy {
            // All solutions satisfy the energy balance: it changes by −h v̄·C v̄.
            branch: Branch::OfEnergy,
            // −2v₀ turns v round: nothing moves.
            standstill: -2.0,
            sums: Sums::Compensated,
            evaluated: Evaluated::ByDifferences,
            ..Policy::of(Units { alike: S::Array::LEN, kinds: 1 })
        }
    };

    fn constants(self, system: &S, h: R) -> Constants<S::Parameters> {
        Constants { parameters: system.parameters(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        History { regular: Regular::unknown(), last: None }
    }

    fn unseen() -> Self::Seen {
        let none = S::Increments::zero();
        Seen { d: none, increments: none, by_d: S::Increments::fill(none) }
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, S, R>,
        constants: &Self::Constants,
        history: &mut Self::History,
    ) -> Result<Self::Start, Refusal> {
        let Departure { system, z, s, .. } = from;
        let sign = history.regular.begin(*system, constants.is_definite, (from.t, z, s))?;
        let [t, _] = times(from);
        // The velocity of the last step is that of this point, unless time was frozen, or something else has moved the point, such as a projection.
        let known = match history.last {
            Some(known) if known.t == t && known.z == *z => known,
            last => known(*system, t, (*z, *s), last.map_or_else(S::Array::zero, |last| last.v))?,
        };
        history.last = Some(known);
        let Known { v, units, .. } = known;
        let mut scales: S::Increments = resized(&units, R::from_f64(1.0));
        scales.as_mut_slice()[0] *= sign;
        Ok(Start { kernel: system.begin(&constants.parameters, from.middle(), z, s, &v), v, scales })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Increments {
        resized(&equation.start.v, equation.action())
    }

    /// The increments for constant v' and s'.
    fn guess(Equation { from, start, .. }: &Equation<'_, Self, S, R>) -> S::Increments {
        let [t, _] = times(from);
        let (acceleration, lagrangian) = rates_of_velocity(from.system, t, &from.z[0], &start.v, &from.s);
        scaled(from.h, &resized(&acceleration, lagrangian))
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
        d: &S::Increments,
        matrix: &mut Square<S::Increments>,
    ) -> S::Increments {
        let Equation { from, constants, start } = equation;
        let s = S::Action::of(equation.action() + of_action::<S, R>(d));
        watch.visit(from.middle(), &[sum(&from.z[0], &equation.shift(d)), from.z[1]], &s);
        let (Seen { d: last, increments, by_d }, mut residual) = (&mut watch.seen, S::Increments::zero());
        *last = *d;
        from.system.equation(&constants.parameters, &start.kernel, d, [&mut residual, increments], [matrix, by_d]);
        scale_rows(&start.scales, &mut residual, matrix);
        residual
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Increments>,
        Seen { d: last, increments, by_d }: &Self::Seen,
    ) -> Result<Increment<S::Phase, S::Action>, Refusal> {
        let increments = extrapolated(increments, by_d, &difference(d, last));
        let z = [equation.shift(d), resized(&increments, zero())];
        Ok(Increment { z, s: S::Action::of(of_action::<S, R>(&increments)), lost: S::Phase::zero() })
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Increments>,
        History { regular, last }: &mut Self::History,
        Arrival { z, s, .. }: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        let (mut v, [_, t]) = (sum(&start.v, &resized(d, zero())), times(from));
        // Near a singular M the rounding of p matters: the velocity is that of the rounded momentum.
        if !constants.is_definite {
            regular.follow(from.system, false, [(from.t, &from.z, &from.s), (from.end, z, s)], v)?;
            v = velocity_near(from.system, t, z, s, v).ok_or(Refusal::Singular)?;
        }
        *last = last.map(|known| Known { t, z: *z, v, ..known });
        Ok(())
    }
}

/// Returns the velocity of a point, which is near `guess`, and units.
#[cold]
#[inline(never)]
fn known<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    (z, s): (S::Phase, S::Action),
    guess: S::Array,
) -> Result<Known<S::Phase, S::Array>, Refusal> {
    let v = velocity_near(system, t, &z, &s, guess).ok_or(Refusal::Singular)?;
    Ok(Known { t, z, v, units: mass_units(system, t, &z, &s, &v) })
}
