//! Methods that keep nothing, as a control: what they lose shows what the others keep.

use crate::array::Array;
use crate::method::{Claims, Method, NotConverged, Probe};
use crate::real::Real;
use crate::system::Hamiltonian;

/// x₁ = x₀ + h J∇H(x₀). Order 1, for every H; keeps nothing: an oscillation gains energy with every step.
///
/// For comparisons only. L. Euler 1768.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExplicitEuler;

impl<S: Hamiltonian<R>, R: Real> Method<S, R> for ExplicitEuler {
    type Prepared = (S, R);

    fn claims(&self) -> Claims {
        Claims { order: 1, symmetric: false, symplectic: false, conserves_energy: false }
    }

    fn prepare(&self, system: &S, h: R) -> (S, R) {
        (*system, h)
    }

    #[inline(always)]
    fn step<P: Probe<S, R>>(
        (system, h): &(S, R),
        t: R,
        q: &mut S::Array,
        p: &mut S::Array,
        probe: &mut P,
    ) -> Result<(), NotConverged> {
        probe.visit(t, q, p);
        let (mut slope_q, mut slope_p) = (S::Array::zero(), S::Array::zero());
        system.gradient(t, q, p, &mut slope_q, &mut slope_p);
        for i in 0..S::Array::LEN {
            q.as_mut_slice()[i] += *h * slope_p.as_slice()[i];
            p.as_mut_slice()[i] -= *h * slope_q.as_slice()[i];
        }
        Ok(())
    }
}
