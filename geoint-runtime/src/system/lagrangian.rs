//! Systems that are given by a Lagrangian L(q, v, s, t).

use super::{Constrained, Cotangent, Hamiltonian, VectorField};
use crate::scalar::Real;
use crate::space::vector::{difference, moved, scaled};
use crate::space::{Array, Snapshot};

/// A system with the energy H(q, p, s, t) = p·v − L(q, v, s, t) and the momenta p = ∂L/∂v.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[lagrangian]`",
    label = "velocities belong to a Lagrangian; of an energy H(q, p) they are ∂H/∂p"
)]
#[doc(alias("mechanism", "robot arm"))]
pub trait Lagrangian<R: Real = f64>: Cotangent<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Returns L.
    fn lagrangian(&self, t: R, q: &Self::Array, v: &Self::Array, s: &Self::Action) -> R;
    /// Returns p = ∂L/∂v.
    fn momentum(&self, t: R, q: &Self::Array, v: &Self::Array, s: &Self::Action) -> Self::Array;
    /// Returns v = ∂H/∂p at a point. NaN if no velocity has this momentum.
    fn velocity(&self, t: R, z: &Self::Phase, s: &Self::Action) -> Self::Array;
}

/// Returns the momentum at the end of a step of the implicit midpoint rule from position q₀ to position q₁. `t` is the time at the end.
///
/// The result is p₁ = p̄ + ½h p̄' with p̄ = ∂L/∂v at the midpoint and at the mean velocity. This equals ∂/∂q₁ of h L((q₀ + q₁)/2, (q₁ − q₀)/h).
pub fn from_positions<S: Lagrangian<R> + VectorField<R>, R: Real>(
    system: &S,
    t: R,
    [before, now]: [&S::Array; 2],
    h: R,
) -> S::Array {
    let half = R::from_f64(0.5);
    let shift = difference(now, before);
    let (middle, q) = (t - half * h, moved(before, half, &shift));
    let p = system.momentum(middle, &q, &scaled(R::from_f64(1.0) / h, &shift), &());
    let mut rate = [S::Array::zero(); 2];
    system.rate(middle, &[q, p], &mut rate);
    moved(&p, half * h, &rate[1])
}

/// Returns the Lagrangian p·∂H/∂p − H of a state.
pub fn lagrangian_of<S: Hamiltonian<R>, R: Real>(system: &S, state: &S::State) -> R {
    let (t, z, _) = state.parts();
    let mut slopes = S::Phase::zero();
    system.gradient(t, &z, &mut slopes);
    lagrangian_with(system, state, &slopes[1])
}

/// Returns the Lagrangian p·∂H/∂p − H of a state with constraints.
pub fn constrained_lagrangian_of<S: Constrained<R>, R: Real>(system: &S, state: &S::State) -> R {
    let (t, z, _) = state.parts();
    let (mut velocity, mut inverse_mass) = (S::Array::zero(), S::Array::fill(S::Array::zero()));
    system.velocity(t, &z, &mut velocity, &mut inverse_mass);
    lagrangian_with(system, state, &velocity)
}

fn lagrangian_with<S: Cotangent<R>, R: Real>(system: &S, state: &S::State, velocity: &S::Array) -> R {
    let (t, z, s) = state.parts();
    let power = z[1].as_slice().iter().zip(velocity.as_slice());
    power.fold(-system.hamiltonian(t, &z, &s), |sum, (p, v)| p.multiply_add(*v, sum))
}
