//! Methods that keep nothing, as a control: what they lose shows what the others keep.

use crate::method::{Claims, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::Summation;
use crate::system::VectorField;

/// x₁ = x₀ + h x'(x₀). Order 1, for every H; keeps nothing: an oscillation gains energy with every step.
///
/// For comparisons only. L. Euler 1768.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExplicitEuler;

impl<S: VectorField<R>, R: Real> Method<S, R> for ExplicitEuler {
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
        Step { system, t, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        probe.visit(t, &x.z, &());
        let (mut rate, mut dz) = (S::Phase::zero(), S::Phase::zero());
        system.rate(t, &x.z, &mut rate);
        dz.add_scaled(*h, &rate);
        x.add(&dz);
        Ok(())
    }
}
