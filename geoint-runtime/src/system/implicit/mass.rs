//! The momenta of a Lagrangian, p = ∂L/∂v: the mass matrix, and the velocity that belongs to a momentum.
//!
//! The velocity of a state is the solution of ∂L/∂v = p that Newton's iteration finds from v = 0, or from a second guess. A Lagrangian that is not quadratic
//! in v may have other solutions. A function that returns a velocity returns NaN or `None` if the iteration finds none, for instance where the mass matrix is
//! singular.

use crate::scalar::Real;
use crate::solving::Failure;
use crate::solving::linear;
use crate::solving::rounding::{Convergence, Correction, Corrections, Stuck, correct};
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot};
use crate::space::{Array, Square};
use crate::system::Lagrangian;

/// The momenta p = ∂L/∂v of L(q, v, s, t), and the mass matrix M = ∂p/∂v.
pub trait MassForm<R: Real = f64>: Lagrangian<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// `true` if L is quadratic in v. The equation ∂L/∂v = p is then linear in v.
    const QUADRATIC: bool;

    /// Returns whether M was proven to be positive definite at every state, for these parameters. `false` means: not proven.
    fn is_definite(&self) -> bool {
        false
    }
    /// Computes p = ∂L/∂v, and M.
    fn mass(
        &self,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &Self::Action,
        values: (&mut Self::Array, &mut Square<Self::Array>),
    );
}

/// Largest residual of ∂L/∂v = p that counts as rounding, in units of ε times the terms of the equation. A chosen bound: a smaller one would refuse states at
/// which the terms of L cancel.
const ROUNDED_RESIDUAL: f64 = 1024.0;

/// Largest distance of two velocities that counts as rounding, in units of √ε times the velocity. Near a singular M the momentum determines only half of the
/// digits of v, so the unit is not ε.
const SAME_VELOCITY: f64 = 16.0;

/// Solves ∂L/∂v = p for the velocity of a point by Newton's iteration from `guess`. One correction suffices if L is quadratic in v.
///
/// Returns `None` if M is singular on the way, or if the iteration finds no root.
#[inline]
pub(crate) fn velocity_near<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    [q, p]: &S::Phase,
    s: &S::Action,
    guess: S::Array,
) -> Option<S::Array> {
    let none = S::Array::zero();
    let correction = |v: &S::Array| {
        let (mut delta, mut mass) = (none, S::Array::fill(none));
        system.mass(t, q, v, s, (&mut delta, &mut mass));
        delta.add_scaled(R::from_f64(-1.0), p);
        solve_for_velocity(&mut mass, &mut delta).ok_or(Failure::Singular)?;
        // The first correction of a linear equation is its solution.
        let relative = if S::QUADRATIC { 0.0 } else { Sizes::new().relative(&delta, &none, &difference(v, &delta)) };
        Ok(Correction { delta, relative })
    };
    let accept = |Stuck { after, .. }: Stuck<'_, S::Array>| has_momentum(system, t, [q, p], s, after).then_some(*after);
    correct(guess, Corrections::of(Convergence::Quadratic), accept, correction).ok().filter(S::Array::is_finite)
}

/// Returns whether a velocity solves ∂L/∂v = p up to rounding.
#[cold]
#[inline(never)]
fn has_momentum<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    [q, p]: [&S::Array; 2],
    s: &S::Action,
    v: &S::Array,
) -> bool {
    let (mut found, mut mass) = (S::Array::zero(), S::Array::fill(S::Array::zero()));
    system.mass(t, q, v, s, (&mut found, &mut mass));
    let rows = S::Array::entries_of::<S::Array>(&mass).iter().zip(found.as_slice().iter().zip(p.as_slice()));
    rows.into_iter().all(|(row, (found, p))| {
        let products = row.as_slice().iter().zip(v.as_slice()).map(|(entry, v)| (*entry * *v).magnitude());
        let terms = p.magnitude() + products.sum::<f64>();
        (*found - *p).magnitude() <= ROUNDED_RESIDUAL * R::epsilon() * terms
    })
}

/// Solves M·x = p in place of p. Returns `None` if M is singular.
#[inline(always)]
fn solve_for_velocity<A: Array>(mass: &mut Square<A>, p: &mut A) -> Option<()> {
    // Row i gets the unit of the velocity i: the unit of 1/√Mᵢᵢ, up to a factor that all rows share.
    let mut sizes = A::zero();
    let rows = A::entries::<A>(mass).iter_mut();
    for (i, ((p, row), size)) in p.as_mut_slice().iter_mut().zip(rows).zip(sizes.as_mut_slice()).enumerate() {
        let scale = row_scale(row, i);
        *size = A::Real::from_f64(1.0 / Real::sqrt(scale.magnitude()));
        let scale = A::Real::from_f64(1.0) / scale;
        *p *= scale;
        for x in row.as_mut_slice() {
            *x *= scale;
        }
    }
    linear::solve(mass, p, &Sizes::of_magnitudes(sizes)).map(drop)
}

/// Returns 1/|Mᵢᵢ| at a point with the velocity `v`. Row i of ∂L/∂v = p times this factor has the unit of the velocity i.
pub(crate) fn mass_units<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    z: &S::Phase,
    s: &S::Action,
    v: &S::Array,
) -> S::Array {
    let none = S::Array::zero();
    let (mut p, mut mass) = (none, S::Array::fill(none));
    system.mass(t, &z[0], v, s, (&mut p, &mut mass));
    row_units(&mass)
}

/// Returns 1/|Mᵢᵢ| for the rows of a mass matrix. See [`row_scale`] for |Mᵢᵢ| = 0.
#[inline(always)]
pub(crate) fn row_units<A: Array>(mass: &Square<A>) -> A {
    let mut units = A::zero();
    for (i, (unit, row)) in units.as_mut_slice().iter_mut().zip(A::entries_of::<A>(mass)).enumerate() {
        *unit = A::Real::from_f64(1.0) / row_scale(row, i);
    }
    units
}

/// Returns |Mᵢᵢ| of row i. If it is zero, returns the largest magnitude of the row, or 1 for a row of zeros.
#[inline(always)]
pub(crate) fn row_scale<A: Array>(row: &A, i: usize) -> A::Real {
    let diagonal = row.as_slice()[i].abs();
    if diagonal.magnitude() > 0.0 {
        return diagonal;
    }
    let largest = row.as_slice().iter().fold(0.0, |largest, x| f64::max(largest, x.magnitude()));
    A::Real::from_f64(if largest > 0.0 { largest } else { 1.0 })
}

/// Returns the velocity of a state, by Newton's iteration from v = 0. If L is not quadratic and this iteration fails, [`velocity_beyond`] tries another
/// guess. Returns `None` if no velocity is found.
#[inline]
pub(crate) fn velocity_from_rest<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    z: &S::Phase,
    s: &S::Action,
) -> Option<S::Array> {
    let found = velocity_near(system, t, z, s, S::Array::zero());
    if S::QUADRATIC || found.is_some() { found } else { velocity_beyond(system, t, z, s) }
}

/// Returns the velocity of a state, by Newton's iteration from −v₁, where v₁ is the first point of the iteration from v = 0. If M changes its sign between
/// v = 0 and the velocity, v₁ lies in the wrong direction.
#[cold]
#[inline(never)]
fn velocity_beyond<S: MassForm<R>, R: Real>(system: &S, t: R, z: &S::Phase, s: &S::Action) -> Option<S::Array> {
    let none = S::Array::zero();
    let (mut opposite, mut mass) = (none, S::Array::fill(none));
    system.mass(t, &z[0], &none, s, (&mut opposite, &mut mass));
    opposite.add_scaled(R::from_f64(-1.0), &z[1]);
    solve_for_velocity(&mut mass, &mut opposite)?;
    velocity_near(system, t, z, s, opposite)
}

/// Returns the velocity of a state, or NaN if Newton's iteration finds none.
#[inline]
pub fn velocity_of<S: MassForm<R>, R: Real>(system: &S, t: R, z: &S::Phase, s: &S::Action) -> S::Array {
    velocity_from_rest(system, t, z, s).unwrap_or_else(unknown)
}

/// Returns the momentum ∂L/∂v of a velocity, or NaN if [`velocity_of`] finds another velocity for this momentum, or none. A run that starts with this momentum
/// would not have the velocity `v`.
pub fn own_momentum<S: MassForm<R>, R: Real>(system: &S, t: R, q: &S::Array, v: &S::Array, s: &S::Action) -> S::Array {
    let p = system.momentum(t, q, v, s);
    if S::QUADRATIC || !p.is_finite() {
        return p;
    }
    let mut away = difference(&velocity_of(system, t, &[*q, p], s), v);
    let (mut units, mut mass, mut size) = (S::Array::zero(), S::Array::fill(S::Array::zero()), *v);
    system.mass(t, q, v, s, (&mut units, &mut mass));
    // Mᵢᵢ has the unit of an energy over the square of the velocity i. Velocities times √Mᵢᵢ therefore have one unit.
    for (i, row) in S::Array::entries_of::<S::Array>(&mass).iter().enumerate() {
        let unit = R::from_f64(Real::sqrt(row_scale(row, i).magnitude()));
        away.as_mut_slice()[i] *= unit;
        size.as_mut_slice()[i] *= unit;
    }
    let largest = |x: &S::Array| x.as_slice().iter().map(|x| x.magnitude()).fold(0.0, f64::max);
    // If `away` has a NaN, the result is NaN.
    let is_same = away.is_finite() && largest(&away) <= SAME_VELOCITY * Real::sqrt(R::epsilon()) * largest(&size);
    if is_same { p } else { unknown() }
}

/// Returns NaN for all entries.
fn unknown<A: Array>() -> A {
    let mut v = A::zero();
    v.as_mut_slice().fill(A::Real::from_f64(f64::NAN));
    v
}

/// Returns the energy p·v − L at a point, or NaN if no velocity is found.
#[inline]
pub fn energy_of<S: MassForm<R>, R: Real>(system: &S, t: R, z: &S::Phase, s: &S::Action) -> R {
    let v = velocity_of(system, t, z, s);
    let mut energy = -system.lagrangian(t, &z[0], &v, s);
    for (p, v) in z[1].as_slice().iter().zip(v.as_slice()) {
        energy = p.multiply_add(*v, energy);
    }
    energy
}

/// Returns v' = M⁻¹(p' − ∂p/∂q v) from p' = `rate` and ∂p/∂q = `by_q`, or zeros if M is singular. For first guesses, which may be wrong.
#[inline]
pub(crate) fn accelerated<A: Array>(mut rate: A, by_q: &Square<A>, v: &A, mut mass: Square<A>) -> A {
    for (f, row) in rate.as_mut_slice().iter_mut().zip(A::entries_of::<A>(by_q)) {
        *f -= dot(row, v);
    }
    match solve_for_velocity(&mut mass, &mut rate) {
        Some(()) => rate,
        None => A::zero(),
    }
}
