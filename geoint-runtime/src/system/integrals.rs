//! What a flow keeps, and the mean velocities that keep it to order 4.

use super::{Graded, Hamiltonian, PhaseSpace, Span, VectorField};
use crate::scalar::Real;
use crate::space::{Array, Square};

/// One or more functions of the coordinates that the flow of `S` keeps.
///
/// Points and increments are arrays of all coordinates: [q, p], or x. Tuples of two or three single invariants are invariants, and `()` is none.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a set of invariants of `{S}`",
    note = "`Energy` is one of every autonomous system whose divided differences are known"
)]
pub trait Invariants<S, R: Real = f64>: Copy
where
    S: PhaseSpace<R>,
{
    /// One scalar an invariant: `R`, or an array.
    type Values: Array<Real = R>;
    /// Whether H is a function of the invariants.
    const KEEP_ENERGY: bool = false;

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

/// The equation of a step of order 4 that keeps first integrals, z₁ − z₀ = h (F − G(GᵀG)⁻¹GᵀF): the tree discrete gradients of the
/// integrals are the columns of G, and F = (f(z₀) + 4 f(c) + f(z₁))/6 with c = m + h/8 (f(z₀) − f(z₁)) and the middle m.
///
/// The exact mean velocity is orthogonal to every discrete gradient, by the discrete chain rule: the projection leaves it alone, so that
/// the step has the order of F, whatever the integrals are.
#[diagnostic::on_unimplemented(
    message = "`FourthOrder(DiscreteGradient)` has nothing to keep in `{Self}`, or constraints stand in its way",
    label = "it keeps an energy, or first integrals",
    note = "methods for every field: `Gauss`, `ImplicitMidpoint`, `RK4`, `DOP853`",
    note = "with a `constraint`: `Suzuki4.of(DiscreteGradient)`, `Suzuki4.of(Rattle)`"
)]
pub trait FourthOrderField<R: Real = f64>: VectorField<R> + Graded<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What depends on parameters and h.
    type FourthParameters: Copy + core::fmt::Debug;
    /// What depends on the start of a step.
    type FourthStart: Copy;

    /// What depends on parameters and h.
    fn fourth_parameters(&self, h: R) -> Self::FourthParameters;
    /// What all evaluations of a step from `z` have in common.
    fn fourth_begin(&self, parameters: &Self::FourthParameters, span: Span<R>, z: &Self::Phase) -> Self::FourthStart;
    /// h times the mean velocity, and 1 − ∂(that)/∂d; or `NEARLY` that, as far as two terms of a series for a correction need it: with less to do for
    /// an energy beside which no momenta are kept.
    fn fourth_slope<const NEARLY: bool>(
        &self,
        parameters: &Self::FourthParameters,
        start: &Self::FourthStart,
        d: &Self::Phase,
        image: &mut Self::Phase,
        matrix: &mut Square<Self::Phase>,
    );
    /// From now on gradients of momenta that nearly depend on that of the energy take no part, if there are momenta that nobody has named.
    fn fourth_loosen(start: &mut Self::FourthStart) -> bool {
        let _ = start;
        false
    }
}
