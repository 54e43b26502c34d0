//! What Störmer and Verlet's steps keep, by kernels that are there for implicit methods.

use crate::array::Array;
use crate::real::{Real, zero};
use crate::system::Collocation;

/// H + h²H₂ of [`StormerVerlet`](crate::StormerVerlet) for q″ = M⁻¹F(q): H₂ = −(v·F′v/12 + F·M⁻¹F/24) with v = ∂T/∂p.
pub fn verlet<S: Collocation<R>, R: Real>(system: &S, h: R, t: R, q: &S::Array, p: &S::Array) -> R {
    let constants = system.constants();
    let (y, momenta) = S::start(q, p);
    let velocity = S::velocity(&constants, &momenta);
    let (mut force, mut acceleration) = (S::Unknown::zero(), S::Unknown::zero());
    let mut jacobian = S::Unknown::fill(S::Unknown::zero());
    S::field(&constants, t, &y, &mut force, &mut jacobian);
    S::add(&constants, R::from_f64(1.0), &force, &mut acceleration);
    let dot = |a: &S::Unknown, b: &S::Unknown| {
        a.as_slice().iter().zip(b.as_slice()).fold(zero(), |sum: R, (a, b)| a.multiply_add(*b, sum))
    };
    let rows = S::Unknown::entries(&mut jacobian).iter().zip(velocity.as_slice());
    let bent = rows.fold(zero(), |sum: R, (row, v)| v.multiply_add(dot(row, &velocity), sum));
    let second = bent * R::from_f64(1.0 / 12.0) + dot(&force, &acceleration) * R::from_f64(1.0 / 24.0);
    system.hamiltonian(t, q, p, &()) - h * h * second
}
