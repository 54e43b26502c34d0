//! What a flow keeps, and the mean velocities that keep it to order 4.

use super::{Hamiltonian, PhaseSpace, VectorField};
use crate::scalar::Real;
use crate::space::Array;

/// One or more functions of the coordinates that the flow of `S` keeps.
///
/// Points and increments are arrays of all coordinates: [q, p], or x. Tuples of two or three single invariants are invariants, and `()` is none.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a set of invariants of `{S}`",
    note = "`Energy` is one of every autonomous system whose divided differences are known"
)]
#[doc(alias("conserved quantity", "constant of motion"))]
pub trait Invariants<S, R: Real = f64>: Copy
where
    S: PhaseSpace<R>,
{
    /// One scalar an invariant: `R`, or an array.
    type Values: Array<Real = R>;
    /// Whether H is a function of the invariants.
    const KEEP_ENERGY: bool = false;
    /// Whether all angles that the invariants read are visited by [`angles`](PhaseSpace::angles): the macros have derived the invariants.
    #[doc(hidden)]
    const DERIVED: bool = false;

    /// What they change by between `x` and `x + d`. Write it without subtracting values where you can: what is lost in that
    /// difference is added to the trajectory.
    fn changes(&self, system: &S, x: &S::Phase, d: &S::Phase) -> Self::Values;

    /// The gradient of each.
    fn gradients(&self, system: &S, x: &S::Phase) -> <Self::Values as Array>::Map<S::Phase>;
}

/// A field with first integrals: functions I(z, t) that stay as they are along its flow.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep anything",
    label = "this is for what keeps first integrals, and none was named",
    note = "name what the flow keeps: `#[vector_field(keeps(name = expression))]`"
)]
pub trait FirstIntegrals<R: Real = f64>: VectorField<R> {
    /// One scalar an integral.
    type Values: Array<Real = R>;
    /// What they are called.
    const NAMES: &'static [&'static str];
    /// Their values.
    fn integrals(&self, t: R, z: &Self::Phase) -> Self::Values;
}

/// First integrals that do not read time, f·∇I = 0: a projection onto the others would need to know the time at both ends of a step.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep anything",
    label = "this method keeps first integrals that do not read time, and none was named",
    note = "name what the flow keeps: `#[vector_field(keeps(name = expression))]`"
)]
pub trait SteadyIntegrals<R: Real = f64>: FirstIntegrals<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// One scalar an integral.
    type Steady: Array<Real = R>;
    /// Their gradients.
    fn slopes(&self, z: &Self::Phase) -> <Self::Steady as Array>::Map<Self::Phase>;
    /// What they change by from z to z + dz, by divided differences: without cancellation.
    fn changes(&self, z: &Self::Phase, dz: &Self::Phase) -> Self::Steady;
}

/// A flow that keeps an energy: H, or of a field what it keeps under that name, or keeps first.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no energy that steps could be led back to",
    label = "this needs an energy that is kept, with divided differences",
    note = "an energy is not kept if it depends on time, or is damped",
    note = "of rigid bodies (`attitude = r`) no divided differences are taken: use tables of kicks and drifts such as `BlanesMoanSrkn14a`",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`"
)]
pub trait KeepsEnergy<R: Real = f64>: VectorField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The energy as methods that project know it.
    type Kept: Invariants<Self, R, Values = R> + Default;
    /// Its value.
    fn kept_energy(&self, t: R, z: &Self::Phase) -> R {
        self.hamiltonian(t, z, &())
    }
}

/// Momenta of degree 2 at most in all coordinates that a flow keeps beside its energy.
pub trait KeptMomenta<R: Real = f64>: Hamiltonian<R> {
    /// One scalar for the energy, and one for each momentum.
    type Values: Array<Real = R>;

    /// The gradients of momenta, behind an entry that is not read.
    fn momenta(&self, z: &Self::Phase) -> <Self::Values as Array>::Map<Self::Phase>;
}
