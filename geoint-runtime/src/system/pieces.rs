//! Systems that are sums of pieces with known flows.

use super::PhaseSpace;
use crate::scalar::Real;
use crate::space::PerCoordinate;

/// The time at which the flow of a piece evaluates explicit time dependence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// The flow is exact in time, from the time at which it starts.
    Own,
    /// Time is frozen at the middle of the step, or of the substep of a composition.
    Stage,
}

/// A term of H, or of a field, in a splitting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The formula of the piece.
    pub name: &'static str,
    /// The time of the flow.
    pub clock: Clock,
    /// Whether the flow has no closed form. An implicit symmetric step of order 2 then replaces it.
    pub solved: bool,
    /// Whether the flow may cease to exist before the end of the step.
    pub may_end: bool,
}

/// A system that is a sum of pieces with known flows, for the splitting method `M`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no pieces for `{M}`",
    label = "this method is for systems that were split into such",
    note = "`PieceSplitting` is for `#[hamiltonian]` where positions and momenta are coupled; `ContactSplitting` for `#[contact_hamiltonian]`; `PoissonSplitting` for `#[hamiltonian(structure = …)]`; `PlanarSplitting` for \
            that and for `#[vector_field(keeps(…))]`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods that keep a `constraint` beside `s`: `ContactSplitting`, `ContactLeapfrog`, `ContactDiscreteGradient`",
    note = "methods for T(p) + V(q) without dissipation: `StormerVerlet`, `BlanesMoan4`, …"
)]
pub trait Pieces<M, R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The pieces. A step applies all but the last one in this order for h/2, the last one for h, and the others in reverse order for h/2.
    const PIECES: &'static [Piece];
    /// Whether each flow is a symplectic, Poisson or contact map.
    const SYMPLECTIC: bool = true;
    /// Whether each flow keeps H, or the first integral.
    const CONSERVES_ENERGY: bool = false;
    /// Coefficients of flows of given lengths, constant as long as h is.
    type Flows: Copy + core::fmt::Debug;
    /// Coefficients that depend on the frozen time, computed anew in every substep.
    type Frozen: Copy + core::fmt::Debug;

    /// Computes the coefficients for a flow of length `last` of the last piece, and for flows of length `outer` of the others.
    fn prepare_flows(&self, outer: R, last: R) -> Self::Flows;
    /// Computes the coefficients for time frozen at `t`.
    fn freeze(&self, flows: &Self::Flows, t: R) -> Self::Frozen;
    /// Applies the flow of a piece. It starts at time `t` if it is exact in time. The result is NaN if the flow ends within the step.
    fn flow(
        &self,
        piece: usize,
        flows: &Self::Flows,
        frozen: &Self::Frozen,
        t: R,
        z: &mut Self::Phase,
        s: &mut Self::Action,
    );
    /// Returns the increments of `x` by [`flow`](Pieces::flow), for compensated sums.
    fn increments(
        &self,
        piece: usize,
        flows: &Self::Flows,
        frozen: &Self::Frozen,
        t: R,
        x: &PerCoordinate<Self::Phase, Self::Action>,
    ) -> PerCoordinate<Self::Phase, Self::Action>;
}

/// Two pieces A and B, in this order, whose Poisson brackets satisfy {B, {B, {B, A}}} = 0, as for A = T quadratic in p and B = V(q). Tables of
/// Runge–Kutta–Nyström type keep their order on such systems.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no two pieces A and B with {{B, {{B, {{B, A}}}}}} = 0",
    label = "Runge–Kutta–Nyström tables would lose their order",
    note = "tables for any pieces: `BlanesMoan6X.of(PieceSplitting)`, `KahanLi8_17a.of(PieceSplitting)`"
)]
pub trait NystromPieces<R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}
