//! The explicit Euler method. It keeps neither the energy nor the symplectic form, and serves as a control for comparisons.

use crate::method::explicit::{check_mass, may_be_singular};
use crate::method::{Claims, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{PerCoordinate, Summation};
use crate::system::{Poles, Rates};

/// x₁ = x₀ + h x'(x₀). Order 1, for every system with rates. It keeps linear invariants, such as a total momentum, but not the
/// energy: an oscillation gains energy with every step. Quaternions are normalised.
///
/// For comparisons only. L. Euler 1768.
#[doc(alias = "forward Euler")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExplicitEuler;

/// The step size, and the poles of the mass matrix that a step must not cross.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<R> {
    h: R,
    poles: Poles,
}

impl<S: Rates<R>, R: Real> Method<S, R> for ExplicitEuler {
    type Proof = S::Proof;
    type Prepared = Prepared<R>;
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

    fn prepare(&self, system: &S, h: R) -> Prepared<R> {
        Prepared { h, poles: Poles::of(system) }
    }

    fn memory(_: &S::Phase) {}

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { h, poles }: &Prepared<R>,
        (): &mut (),
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        probe.visit(t, &x.z, &x.s);
        let mut increment = system.rates(t, &PerCoordinate { z: x.z, s: x.s });
        increment.times(*h);
        // The rates have a pole where the mass matrix is singular.
        if may_be_singular::<S, R>() {
            check_mass(poles, system, [t, end], x, &increment)?;
        }
        super::add_and_normalise::<S, R, C>(x, &increment);
        Ok(())
    }
}
