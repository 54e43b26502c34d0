//! The step of the polarised discrete gradient of a Lagrangian that is quadratic in v. The unknown is d = v₁ − v₀:
//!
//! M(q₁)v₁ + a(q₁) = p₁ with q₁ = q₀ + h v̄, p₁ = p₀ + h (Λ[q₀, q₁; v₀, v₁] − C v̄) and v̄ = v₀ + d/2. [`PolarisedForm`] defines Λ.

use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, extrapolated, moved, scale_rows, scaled, sum};
use crate::space::{Array, Record, Square, Tape};
use crate::system::{KeptBy, PolarisedForm, Regular, acceleration, mass_units, velocity_near};

/// The step along the polarised discrete gradient.
#[derive(Clone, Copy, Debug)]
pub struct PolarisedStep;

/// The end of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known<Z, A> {
    z: Z,
    v: A,
    /// 1/|Mᵢᵢ| at the last point whose velocity was solved for from p. These are scales only, so they need not be new.
    units: A,
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for Known<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.array(&mut self.z);
        tape.array(&mut self.v);
        tape.array(&mut self.units);
    }
}

/// The mass matrix of the run, and the end of the last step.
#[derive(Clone, Copy, Debug)]
pub struct History<Z, A: Array> {
    regular: Regular<A>,
    last: Option<Known<Z, A>>,
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for History<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        self.regular.record(tape);
        tape.option(&mut self.last, || Known { z: Z::zero(), v: A::zero(), units: A::zero() });
    }
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<K, A> {
    kernel: K,
    v: A,
    /// Scales of the rows: a row over |Mᵢᵢ| has the unit of the velocity. The sign of det M on the first row makes the determinant of the equation positive.
    units: A,
}

/// Values that depend on parameters and h.
#[derive(Clone, Debug)]
pub struct Constants<P> {
    parameters: P,
    /// The mass matrix is positive definite everywhere.
    is_definite: bool,
}

/// The last evaluation: d, the impulse p₁ − p₀, and its derivative by d.
#[derive(Clone, Copy, Debug)]
pub struct Seen<A: Array> {
    d: A,
    impulse: A,
    by_d: Square<A>,
}

impl<S: PolarisedForm<R>, R: Real> Equation<'_, PolarisedStep, S, R> {
    /// Returns q₁ − q₀ = h (v₀ + d/2).
    #[inline(always)]
    fn shift(&self, d: &S::Array) -> S::Array {
        scaled(self.from.h, &moved(&self.start.v, R::from_f64(0.5), d))
    }
}

impl<S: PolarisedForm<R>, R: Real> ImplicitStep<S, R> for PolarisedStep {
    type Unknown = S::Array;
    type Constants = Constants<S::Parameters>;
    type Start = Start<S::Start, S::Array>;
    type History = History<S::Phase, S::Array>;
    type Seen = Seen<S::Array>;
    type Kept = KeptBy<S, R>;
    type Solver = Newton<S::Array>;

    const POLICY: Policy = Policy {
        // All solutions satisfy the energy balance: it changes by −h v̄·C v̄.
        branch: Branch::OfEnergy,
        // −2v₀ turns v round: nothing moves.
        standstill: -2.0,
        sums: Sums::Compensated,
        evaluated: Evaluated::ByDifferences,
        ..Policy::of(Units { alike: S::Array::LEN, kinds: 1 })
    };

    fn constants(self, system: &S, h: R) -> Constants<S::Parameters> {
        Constants { parameters: system.parameters(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        History { regular: Regular::unknown(), last: None }
    }

    fn unseen() -> Seen<S::Array> {
        let none = S::Array::zero();
        Seen { d: none, impulse: none, by_d: S::Array::fill(none) }
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, S, R>,
        constants: &Self::Constants,
        history: &mut Self::History,
    ) -> Result<Self::Start, Refusal> {
        let sign = history.regular.begin(from.system, constants.is_definite, (from.t, &from.z, &()))?;
        // The velocity of the last step is that of this point, unless something else has moved the point, such as a projection.
        let known = match history.last {
            Some(known) if known.z == from.z => known,
            _ => known(from.system, from.t, from.z)?,
        };
        history.last = Some(known);
        let Known { v, mut units, .. } = known;
        units.as_mut_slice()[0] *= sign;
        Ok(Start { kernel: from.system.begin(&constants.parameters, from.middle(), &from.z, &v), v, units })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Array {
        equation.start.v
    }

    fn guess(Equation { from, start, .. }: &Equation<'_, Self, S, R>) -> S::Array {
        scaled(from.h, &acceleration(from.system, from.t, &from.z[0], &start.v))
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
        d: &S::Array,
        matrix: &mut Square<S::Array>,
    ) -> S::Array {
        let Equation { from, constants, start } = equation;
        watch.visit(from.t, &[sum(&from.z[0], &equation.shift(d)), from.z[1]], &());
        let (Seen { d: last, impulse, by_d }, mut residual) = (&mut watch.seen, S::Array::zero());
        *last = *d;
        from.system.equation(&constants.parameters, &start.kernel, d, [&mut residual, impulse], [matrix, by_d]);
        scale_rows(&start.units, &mut residual, matrix);
        residual
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Array>,
        Seen { d: last, impulse, by_d }: &Self::Seen,
    ) -> Result<Increment<S::Phase, ()>, Refusal> {
        Ok(Increment::of([equation.shift(d), extrapolated(impulse, by_d, &difference(d, last))]))
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Array>,
        History { regular, last }: &mut Self::History,
        Arrival { z, .. }: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        let (mut v, later) = (sum(&start.v, d), from.t + from.h);
        // Near a singular M the rounding of p matters: the velocity is that of the rounded momentum.
        if !constants.is_definite {
            regular.follow(from.system, false, [(from.t, &from.z, &()), (later, z, &())], v)?;
            v = velocity_near(from.system, later, z, &(), v).ok_or(Refusal::Singular)?;
        }
        *last = last.map(|known| Known { z: *z, v, ..known });
        Ok(())
    }
}

/// Returns the velocity of a point, and units.
#[cold]
#[inline(never)]
fn known<S: PolarisedForm<R>, R: Real>(system: &S, t: R, z: S::Phase) -> Result<Known<S::Phase, S::Array>, Refusal> {
    let v = velocity_near(system, t, &z, &(), S::Array::zero()).ok_or(Refusal::Singular)?;
    Ok(Known { z, v, units: mass_units(system, t, &z, &(), &v) })
}
