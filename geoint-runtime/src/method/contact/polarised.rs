//! Step of the polarised discrete gradient of a Lagrangian with an action. The unknowns are the increments of v and s. The equations are ∂L/∂v = p₁ at
//! the end, and the increment of s. See [`ContactPolarised`].

use crate::method::implicit::{Arrival, Departure, Equation, ImplicitStep, Increment, Policy, Units, Watch};
use crate::method::{Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, extrapolated, moved, scale_rows, scaled, sum};
use crate::space::{Array, Record, Square, Tape};
use crate::system::{ContactPolarised, ContactStage, Regular, mass_units, velocity_near};

/// The step along the polarised discrete gradient of a contact system.
#[derive(Clone, Copy, Debug)]
pub struct ContactPolarisedStep;

/// Coefficients that depend on parameters and h.
#[derive(Clone, Copy, Debug)]
pub struct Constants<P> {
    parameters: P,
    /// True if the mass matrix is positive definite everywhere.
    is_definite: bool,
}

/// Mass matrix of the run, and velocity at the end of the last step.
#[derive(Clone, Copy, Debug)]
pub struct History<A: Array> {
    regular: Regular<A>,
    v: A,
}

impl<A: Array> Record<A::Real> for History<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.regular.record(tape);
        tape.array(&mut self.v);
    }
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<K, A, D> {
    kernel: K,
    v: A,
    /// Units of the rows: 1/|Mᵢᵢ| for rows of momenta, and 1 for the row of the action. The first unit has the sign of the determinant of M.
    units: D,
}

/// Last evaluated increments of p and s, with their argument d and their derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Seen<D: Array> {
    d: D,
    increments: D,
    by_d: Square<D>,
}

impl<S: ContactPolarised<R>, R: Real> Equation<'_, ContactPolarisedStep, S, R> {
    /// Returns q₁ − q₀ = h (v₀ + d/2).
    #[inline(always)]
    fn shift(&self, d: &S::Unknown) -> S::Array {
        scaled(self.from.h, &moved(&self.start.v, R::from_f64(0.5), &apart::<S, R>(d).0))
    }
}

impl<S: ContactPolarised<R>, R: Real> ImplicitStep<S, R> for ContactPolarisedStep {
    type Unknown = S::Unknown;
    type Constants = Constants<S::Parameters>;
    type Start = Start<S::Start, S::Array, S::Unknown>;
    type History = History<S::Array>;
    type Seen = Seen<S::Unknown>;
    type Kept = ();
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy::of(Units { alike: S::Array::LEN, kinds: 2 });

    fn constants(self, system: &S, h: R) -> Self::Constants {
        Constants { parameters: system.parameters(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        History { regular: Regular::unknown(), v: S::Array::zero() }
    }

    fn unseen() -> Self::Seen {
        let none = S::Unknown::zero();
        Seen { d: none, increments: none, by_d: S::Unknown::fill(none) }
    }

    /// Begins a step, with time frozen in its middle.
    #[inline(always)]
    fn begin(
        from: &Departure<'_, S, R>,
        constants: &Self::Constants,
        history: &mut Self::History,
    ) -> Result<Self::Start, Refusal> {
        let Departure { system, t, z, s, .. } = from;
        let sign = history.regular.begin(*system, constants.is_definite, (*t, z, s))?;
        let v = velocity_near(*system, from.middle(), z, s, history.v).ok_or(Refusal::Singular)?;
        let mut units = together::<S, R>(&mass_units(*system, from.middle(), z, s, &v), R::from_f64(1.0));
        units.as_mut_slice()[0] *= sign;
        Ok(Start { kernel: system.begin(&constants.parameters, from.middle(), z, s, &v), v, units })
    }

    #[inline(always)]
    fn origin(Equation { from, start, .. }: &Equation<'_, Self, S, R>) -> S::Unknown {
        together::<S, R>(&start.v, from.s)
    }

    /// Returns the increments for constant v' and s'.
    fn guess(equation: &Equation<'_, Self, S, R>) -> S::Unknown {
        let Equation { from: from @ Departure { system, z, s, h, .. }, start: Start { v, .. }, .. } = equation;
        let mut at = ContactStage::none();
        system.stage(&system.stage_constants(), from.middle(), &z[0], v, s, &mut at);
        scaled(*h, &together::<S, R>(&at.acceleration(v), at.lagrangian))
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
        d: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let Equation { from, constants, start } = equation;
        let s = from.s + apart::<S, R>(d).1;
        watch.visit(from.middle(), &[sum(&from.z[0], &equation.shift(d)), from.z[1]], &s);
        let (Seen { d: last, increments, by_d }, mut residual) = (&mut watch.seen, S::Unknown::zero());
        *last = *d;
        from.system.equation(&constants.parameters, &start.kernel, d, [&mut residual, increments], [matrix, by_d]);
        scale_rows(&start.units, &mut residual, matrix);
        residual
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Unknown>,
        Seen { d: last, increments, by_d }: &Self::Seen,
    ) -> Result<Increment<S::Phase, R>, Refusal> {
        let (impulse, s) = apart::<S, R>(&extrapolated(increments, by_d, &difference(d, last)));
        Ok(Increment { z: [equation.shift(d), impulse], s, lost: S::Phase::zero() })
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        Solution { x: d, .. }: &Solution<S::Unknown>,
        History { regular, v }: &mut Self::History,
        Arrival { z, s, .. }: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        *v = sum(&start.v, &apart::<S, R>(d).0);
        let ends = [(from.t, &from.z, &from.s), (from.t + from.h, z, s)];
        regular.follow(from.system, constants.is_definite, ends, *v)
    }
}

/// Splits a row into the entries of the coordinates and of the action.
#[inline(always)]
fn apart<S: ContactPolarised<R>, R: Real>(d: &S::Unknown) -> (S::Array, R) {
    let mut v = S::Array::zero();
    v.as_mut_slice().copy_from_slice(&d.as_slice()[..S::Array::LEN]);
    (v, d.as_slice().last().copied().unwrap_or_else(zero))
}

/// Joins the entries of the coordinates and of the action in a row.
#[inline(always)]
fn together<S: ContactPolarised<R>, R: Real>(v: &S::Array, s: R) -> S::Unknown {
    let mut row = S::Unknown::zero();
    row.as_mut_slice().fill(s);
    row.as_mut_slice()[..S::Array::LEN].copy_from_slice(v.as_slice());
    row
}
