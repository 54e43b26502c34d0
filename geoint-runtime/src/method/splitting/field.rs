//! What else the kernel of implicit methods is good for: it has the force with its derivative.

use crate::scalar::{Real, zero};
use crate::space::Array;
use crate::space::vector::dot;
use crate::system::{Collocation, Cotangent};

/// H + h²H₂ of [`StormerVerlet`](crate::StormerVerlet) for q″ = M⁻¹F(q): H₂ = −(v·F′v/12 + F·M⁻¹F/24) with v = ∂T/∂p.
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

/// p ← p + hF + g ∂(F·M⁻¹F)/∂q, with h and g as they are prepared: 2 ∂F/∂q·M⁻¹F, because ∂F/∂q is symmetric.
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
