//! Lagrangians whose steps are solved for velocities: v follows from p by an equation, and no energy as a function of p is emitted.

use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::rounding::{Corrections, MAX_ITERATIONS, Verdict};
use crate::solving::size::Sizes;
use crate::space::vector::dot;
use crate::space::{Array, Square};
use crate::system::{ByPolarisation, ByVelocities, Collocated, Graded, Lagrangian};

/// The momenta of L(q, v, s, t), and how they depend on v: by the mass matrix M = ∂²L/∂v².
pub trait MassForm<R: Real = f64>: Lagrangian<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Whether L is quadratic in v, so that one linear equation gives v.
    const QUADRATIC: bool;

    /// Whether M was proven to be positive definite at every state, for these parameters.
    fn is_definite(&self) -> bool {
        false
    }
    /// p = ∂L/∂v, and M.
    fn mass(
        &self,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &Self::Action,
        values: (&mut Self::Array, &mut Square<Self::Array>),
    );
}

/// L(q, v, t) by its derivatives: half of the unknowns of an energy, and no inverse of the mass matrix.
pub trait VelocityForm<R: Real = f64>:
    MassForm<R> + Lagrangian<R, Action = ()> + Collocated<R, Stages = ByVelocities>
{
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What depends on parameters only.
    type Constants: Copy + core::fmt::Debug;

    /// What depends on parameters only.
    fn constants(&self) -> Self::Constants;
    /// p = ∂L/∂v, f = ∂L/∂q less friction, and [∂p/∂q, ∂p/∂v, ∂f/∂q, ∂f/∂v].
    fn stage(
        &self,
        constants: &Self::Constants,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        values: [&mut Self::Array; 2],
        derivatives: &mut [Square<Self::Array>; 4],
    );
    /// f alone.
    fn force(&self, constants: &Self::Constants, t: R, q: &Self::Array, v: &Self::Array) -> Self::Array;
}

/// The polarised discrete gradient of an L that is quadratic in v.
///
/// With Λ(q; v₀, v₁) = ½v₀ᵀM(q)v₁ + a(q)·(v₀ + v₁)/2 − V(q), its tree slopes Λ[q₀, q₁] in q, and friction C:
/// q₁ − q₀ = h v̄, p₁ − p₀ = h(Λ[q₀, q₁; v₀, v₁] − C v̄) with v̄ = (v₀ + v₁)/2, and p = M(q)v + a(q) at both ends. Then
/// p·v − L changes by −h v̄·C v̄.
pub trait PolarisedForm<R: Real = f64>: VelocityForm<R> + Graded<R, Gradient = ByPolarisation> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What depends on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// What depends on the start of a step.
    type Start: Copy + core::fmt::Debug;

    /// What depends on parameters and h only.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// What all evaluations from a point have in common; `t` is the time of the middle of the step.
    fn begin(&self, parameters: &Self::Parameters, t: R, z: &Self::Phase, v: &Self::Array) -> Self::Start;
    /// M(q₁)v₁ + a(q₁) − p₁ and p₁ − p₀, with p₁ as the step gives it, and the derivatives of both by d = v₁ − v₀.
    fn equation(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Array,
        values: [&mut Self::Array; 2],
        derivatives: [&mut Square<Self::Array>; 2],
    );
}

/// v of a point by Newton's iteration for ∂L/∂v = p from `guess` on: one linear equation where L is quadratic. `None` where M is
/// singular, or the iteration leads nowhere.
#[inline]
pub(crate) fn velocity_near<S: MassForm<R>, R: Real>(
    system: &S,
    t: R,
    [q, p]: &S::Phase,
    s: &S::Action,
    guess: S::Array,
) -> Option<S::Array> {
    let minus = R::from_f64(-1.0);
    let (mut v, none) = (guess, S::Array::zero());
    let mut corrections = Corrections::of_order(2);
    for _ in 0..MAX_ITERATIONS {
        let (mut delta, mut mass) = (none, S::Array::fill(none));
        system.mass(t, q, &v, s, (&mut delta, &mut mass));
        delta.add_scaled(minus, p);
        solve_for_velocity(&mut mass, &mut delta)?;
        v.add_scaled(minus, &delta);
        if S::QUADRATIC {
            return v.is_finite().then_some(v);
        }
        let correction = Sizes::new().relative(&delta, &none, &v);
        match corrections.judge::<R>(correction) {
            Verdict::Solved | Verdict::Stuck => return Some(v),
            Verdict::Continue if correction.is_finite() => {}
            Verdict::Continue => return None,
        }
    }
    None
}

/// Solves M·x = p in place of p; `None` where M is singular.
#[inline(always)]
fn solve_for_velocity<A: Array>(mass: &mut Square<A>, p: &mut A) -> Option<()> {
    // Row i gets the unit of the velocity i, which is that of √(E/Mᵢᵢ).
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

/// |Mᵢᵢ|, or the largest magnitude of the row where that is zero.
#[inline(always)]
pub(crate) fn row_scale<A: Array>(row: &A, i: usize) -> A::Real {
    let diagonal = row.as_slice()[i].abs();
    if diagonal.magnitude() > 0.0 {
        return diagonal;
    }
    let largest = row.as_slice().iter().fold(0.0, |largest, x| f64::max(largest, x.magnitude()));
    A::Real::from_f64(if largest > 0.0 { largest } else { 1.0 })
}

/// v at a point; not a number where there is none.
#[inline]
pub fn velocity_of<S: MassForm<R>, R: Real>(system: &S, t: R, z: &S::Phase, s: &S::Action) -> S::Array {
    velocity_near(system, t, z, s, S::Array::zero()).unwrap_or_else(unknown)
}

fn unknown<A: Array>() -> A {
    let mut v = A::zero();
    v.as_mut_slice().fill(A::Real::from_f64(f64::NAN));
    v
}

/// p·v − L at a point.
#[inline]
pub fn energy_of<S: MassForm<R>, R: Real>(system: &S, t: R, z: &S::Phase, s: &S::Action) -> R {
    let v = velocity_of(system, t, z, s);
    let mut energy = -system.lagrangian(t, &z[0], &v, s);
    for (p, v) in z[1].as_slice().iter().zip(v.as_slice()) {
        energy = p.multiply_add(*v, energy);
    }
    energy
}

/// (q', p') at a point.
#[inline]
pub fn rate_of<S: VelocityForm<R>, R: Real>(system: &S, t: R, z: &S::Phase, dz: &mut S::Phase) {
    let v = velocity_of(system, t, z, &());
    *dz = [v, system.force(&system.constants(), t, &z[0], &v)];
}

/// v' at a point, for a first guess: without the change of L in time.
#[inline]
pub(crate) fn acceleration<S: VelocityForm<R>, R: Real>(system: &S, t: R, q: &S::Array, v: &S::Array) -> S::Array {
    let none = S::Array::zero();
    let (mut p, mut f, mut derivatives) = (none, none, [S::Array::fill(none); 4]);
    system.stage(&system.constants(), t, q, v, [&mut p, &mut f], &mut derivatives);
    let [by_q, mass, ..] = derivatives;
    accelerated(f, &by_q, v, mass)
}

/// M⁻¹(p' − ∂p/∂q v), or zeros where M is singular.
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
