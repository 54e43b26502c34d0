//! First integrals of flows, and sets of invariants for projection and relaxation.

use super::{Hamiltonian, PhaseSpace, VectorField};
use crate::scalar::Real;
use crate::space::Array;

/// A set of functions of the coordinates that the flow of `S` keeps.
///
/// Points and increments are arrays of all coordinates: [q, p], or x. A tuple of two or three single invariants is a set of invariants. `()` is the
/// empty set.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a set of invariants of `{S}`",
    note = "`Energy` is one of every autonomous system whose divided differences are known"
)]
#[doc(alias("conserved quantity", "constant of motion"))]
pub trait Invariants<S, R: Real = f64>: Copy
where
    S: PhaseSpace<R>,
{
    /// One scalar for each invariant: `R`, or an array.
    type Values: Array<Real = R>;
    /// The origin of the set. It decides which checks a projection makes.
    const ORIGIN: Origin = Origin::ByHand;

    /// Returns the changes of the invariants from `x` to `x + d`. Avoid the subtraction of values if possible: the rounding error of the difference becomes
    /// an error of the trajectory.
    fn changes(&self, system: &S, x: &S::Phase, d: &S::Phase) -> Self::Values;

    /// Returns the gradient of each invariant.
    fn gradients(&self, system: &S, x: &S::Phase) -> <Self::Values as Array>::Map<S::Phase>;
}

/// The origin of a set of [`Invariants`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Implemented by hand. A function of the set may read an angle that the system does not know.
    ByHand,
    /// Derived by the macros: the energy, or all first integrals. [`angles`](PhaseSpace::angles) visits all angles that the set reads.
    Derived,
    /// A tuple of both.
    Mixed,
}

impl Origin {
    /// Returns the origin of a tuple of sets.
    pub(crate) const fn of(parts: &[Self]) -> Self {
        let (mut derived, mut by_hand, mut i) = (0, 0, 0);
        while i < parts.len() {
            derived += matches!(parts[i], Self::Derived) as usize;
            by_hand += matches!(parts[i], Self::ByHand) as usize;
            i += 1;
        }
        match (derived, by_hand) {
            (_, n) if n == parts.len() => Self::ByHand,
            (n, _) if n == parts.len() => Self::Derived,
            _ => Self::Mixed,
        }
    }

    /// Returns whether H is a function of the set.
    pub(crate) const fn keeps_energy(self) -> bool {
        !matches!(self, Self::ByHand)
    }
}

/// A field with first integrals: functions I(z, t) that are constant along the flow.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep anything",
    label = "this is for what keeps first integrals, and none was named",
    note = "name what the flow keeps: `#[vector_field(keeps(name = expression))]`"
)]
pub trait FirstIntegrals<R: Real = f64>: VectorField<R> {
    /// One scalar for each integral.
    type Values: Array<Real = R>;
    /// The names of the integrals.
    const NAMES: &'static [&'static str];
    /// Returns the values of the integrals.
    fn integrals(&self, t: R, z: &Self::Phase) -> Self::Values;
}

/// First integrals that do not depend on time: f·∇I = 0. Only these are used for projections. Others would need the time at both ends of a step.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep anything",
    label = "this method keeps first integrals that do not read time, and none was named",
    note = "name what the flow keeps: `#[vector_field(keeps(name = expression))]`"
)]
pub trait SteadyIntegrals<R: Real = f64>: FirstIntegrals<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// One scalar for each integral.
    type Steady: Array<Real = R>;
    /// Returns the gradients of the integrals.
    fn slopes(&self, z: &Self::Phase) -> <Self::Steady as Array>::Map<Self::Phase>;
    /// Returns the changes of the integrals from z to z + dz, by divided differences without cancellation.
    fn changes(&self, z: &Self::Phase, dz: &Self::Phase) -> Self::Steady;
}

/// A flow that keeps an energy. The energy is H, or for a field its integral with the name `energy`, or its first integral.
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
    /// The energy as a set of invariants, for methods that project.
    type Kept: Invariants<Self, R, Values = R> + Default;
    /// Returns the value of the kept energy.
    fn kept_energy(&self, t: R, z: &Self::Phase) -> R {
        self.hamiltonian(t, z, &())
    }
}

/// Momenta that a flow keeps besides its energy. They are polynomials of degree 2 at most in all coordinates.
pub trait KeptMomenta<R: Real = f64>: Hamiltonian<R> {
    /// One scalar for the energy, and one for each momentum.
    type Values: Array<Real = R>;

    /// Returns the gradients of the momenta. The first entry belongs to the energy and is not read.
    fn momenta(&self, z: &Self::Phase) -> <Self::Values as Array>::Map<Self::Phase>;
}
