//! Methods that keep nothing, as a control: what they lose shows what the others keep.

use crate::method::{Claims, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{PerCoordinate, Summation};
use crate::system::Rates;

/// x₁ = x₀ + h x'(x₀). Order 1, for every H; keeps nothing: an oscillation gains energy with every step.
///
/// For comparisons only. L. Euler 1768.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExplicitEuler;

impl<S: Rates<R>, R: Real> Method<S, R> for ExplicitEuler {
    type Proof = S::Proof;
    /// h.
    type Prepared = R;
    type Memory = ();

    fn claims(&self) -> Claims {
        Claims {
            order: 1,
            symmetric: false,
            symplectic: false,
            conserves_energy: false,
            perturbed: &[],
            forces: Some(1),
        }
    }

    fn name(&self) -> Name {
        Name::new("ExplicitEuler")
    }

    fn prepare(&self, _: &S, h: R) -> R {
        h
    }

    fn memory() {}

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        h: &R,
        (): &mut (),
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        probe.visit(t, &x.z, &x.s);
        let mut increment = system.rates(t, &PerCoordinate { z: x.z, s: x.s });
        increment.times(*h);
        super::end::<S, R, C>(x, &increment);
        Ok(())
    }
}
