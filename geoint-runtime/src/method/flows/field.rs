//! Functions that need the force and its derivative: the modified energy of Verlet's method, and kicks with a force gradient.
//!
//! Both use [`Collocation::field`], the kernel of implicit methods.

use crate::scalar::{Real, zero};
use crate::space::Array;
use crate::space::vector::dot;
use crate::system::{Collocation, Cotangent};

/// Computes the modified energy H + h²H₂ of [`StormerVerlet`](crate::StormerVerlet) for q″ = M⁻¹F(q). With v = ∂T/∂p, H₂ = −(v·F′v/12 + F·M⁻¹F/24).
pub fn modified_verlet<S: Collocation<R>, R: Real>(system: &S, h: R, t: R, z: &S::Phase) -> R {
    let constants = system.constants();
    let (y, momenta) = S::start(z);
    let velocity = system.velocity(&constants, &momenta);
    let (mut force, mut acceleration) = (S::Unknown::zero(), S::Unknown::zero());
    let mut jacobian = S::Unknown::fill(S::Unknown::zero());
    system.field(&constants, t, &y, &mut force, &mut jacobian);
    system.add(&constants, R::from_f64(1.0), &force, &mut acceleration);
    let rows = S::Unknown::entries(&mut jacobian).iter().zip(velocity.as_slice());
    let bent = rows.fold(zero(), |sum: R, (row, v)| v.multiply_add(dot(row, &velocity), sum));
    let second = bent * R::from_f64(1.0 / 12.0) + dot(&force, &acceleration) * R::from_f64(1.0 / 24.0);
    system.hamiltonian(t, z, &()) - h * h * second
}

/// Kick with a force gradient: p ← p + hF + g ∂(F·M⁻¹F)/∂q for the prepared h and g. The gradient is computed as 2 ∂F/∂q·M⁻¹F, because ∂F/∂q is symmetric.
#[inline(always)]
pub fn gradient_kick<S: Collocation<R> + Cotangent<R>, R: Real>(
    system: &S,
    (constants, [h, g]): &(S::Constants, [R; 2]),
    t: R,
    q: &S::Array,
    p: &mut S::Array,
) {
    let (y, _) = S::start(&[*q, *p]);
    let (mut force, mut acceleration) = (S::Unknown::zero(), S::Unknown::zero());
    let mut jacobian = S::Unknown::fill(S::Unknown::zero());
    system.field(constants, t, &y, &mut force, &mut jacobian);
    system.add(constants, *g + *g, &force, &mut acceleration);
    let rows = S::Unknown::entries::<S::Unknown>(&mut jacobian).iter();
    for (p, (row, force)) in p.as_mut_slice().iter_mut().zip(rows.zip(force.as_slice())) {
        let mut impulse = *h * *force;
        for (slope, change) in row.as_slice().iter().zip(acceleration.as_slice()) {
            impulse = slope.multiply_add(*change, impulse);
        }
        *p += impulse;
    }
}
