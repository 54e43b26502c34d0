//! Contact systems: H(q, p, s, t) moves q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

use super::{Cotangent, PhaseSpace, Separable};
use crate::scalar::{Real, zero};
use crate::space::{Array, ContactState, PerCoordinate, Square};

/// A system with a contact Hamiltonian H(q, p, s, t).
pub trait Contact<R: Real = f64>:
    Cotangent<R> + PhaseSpace<R, Action = R, State = ContactState<<Self as Cotangent<R>>::Coordinates>>
{
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// ∂H/∂q, ∂H/∂p and ∂H/∂s at a point.
    fn gradient(&self, t: R, z: &Self::Phase, s: &R, slopes: &mut Self::Phase, ds: &mut R);

    /// z' and s' at a point; the momenta of a lift stand still.
    #[inline]
    fn rate(&self, t: R, z: &Self::Phase, s: &R, slopes: &mut Self::Phase, ds: &mut R) {
        let mut by_s = zero();
        self.gradient(t, z, s, slopes, &mut by_s);
        *ds = -self.hamiltonian(t, z, s);
        let ([_, p], [q_rate, p_rate]) = (z, slopes);
        let halves = q_rate.as_mut_slice().iter_mut().zip(p_rate.as_mut_slice());
        for (p, (force, velocity)) in p.as_slice().iter().zip(halves) {
            *ds = p.multiply_add(*velocity, *ds);
            (*force, *velocity) = (*velocity, -p.multiply_add(by_s, *force));
        }
    }
}

/// (q, p) moves without s: H = g(t)·s + H₀(q, p, t).
#[diagnostic::on_unimplemented(
    message = "positions and momenta of `{Self}` do not move without the action",
    label = "s acts back on q or p, and has to be followed"
)]
#[doc(alias = "linear damping")]
pub trait Conformal<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// H = T(p, t) + g(t)·s + V(q, t), and the flows of T and V without the damping.
#[diagnostic::on_unimplemented(message = "`{Self}` was not proven to be T(p) + g·s + V(q)")]
pub trait Mechanical<R: Real = f64>: Contact<R> + Separable<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What a kick of given length needs from the parameters.
    type FreeKick: Copy;
    /// What a drift of given length needs from the parameters.
    type FreeDrift: Copy;

    /// Coefficients of a kick of length `h`.
    fn prepare_free_kick(&self, h: R) -> Self::FreeKick;
    /// The flow of V alone.
    fn free_kick(&self, kick: &Self::FreeKick, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut R);
    /// Coefficients of a drift of length `h`.
    fn prepare_free_drift(&self, h: R) -> Self::FreeDrift;
    /// The flow of T alone.
    fn free_drift(&self, drift: &Self::FreeDrift, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut R);
    /// g at time `t`.
    fn damping(&self, t: R) -> R;
}

/// How a flow deals with time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Exactly, from the time on at which it begins.
    Own,
    /// It is frozen at the middle of the step.
    Stage,
}

/// A part of H, or of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its formula.
    pub name: &'static str,
    /// Its time.
    pub clock: Clock,
    /// Whether its flow is not known in closed form, and a symmetric step of order 2 is solved for in its place.
    pub solved: bool,
    /// Whether its flow may end before its time.
    pub may_end: bool,
}

/// The system is a sum of pieces whose flows are known: for the splitting `M`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no pieces for `{M}`",
    label = "this method is for systems that were split into such",
    note = "`PieceSplitting` is for `#[hamiltonian]` where positions and momenta are coupled; `ContactSplitting` for `#[contact_hamiltonian]`; `PoissonSplitting` for `#[hamiltonian(structure = …)]`; `PlanarSplitting` for \
            that and for `#[vector_field(keeps(…))]`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods for T(p) + V(q) without dissipation: `StormerVerlet`, `BlanesMoan4`, …"
)]
pub trait Pieces<M, R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The pieces; the last one is in the middle of a step.
    const PIECES: &'static [Piece];
    /// Whether every flow keeps the structure of phase space: a symplectic, Poisson or contact map.
    const SYMPLECTIC: bool = true;
    /// Whether every flow keeps H, or the first integral.
    const CONSERVES_ENERGY: bool = false;
    /// What flows of given lengths need from the parameters.
    type Flows: Copy + core::fmt::Debug;
    /// Values of flows that depend on the frozen time.
    type Frozen: Copy + core::fmt::Debug;

    /// Coefficients for flows of length `last` of the last piece, and of length `outer` of the others.
    fn prepare_flows(&self, outer: R, last: R) -> Self::Flows;
    /// Freezes time at `t`.
    fn freeze(&self, flows: &Self::Flows, t: R) -> Self::Frozen;
    /// The flow of a piece, from time t on if it is exact in time. Not a number where it ends before.
    fn flow(
        &self,
        piece: usize,
        flows: &Self::Flows,
        frozen: &Self::Frozen,
        t: R,
        z: &mut Self::Phase,
        s: &mut Self::Action,
    );
    /// The increments of `x` by that flow, for compensated sums.
    fn increments(
        &self,
        piece: usize,
        flows: &Self::Flows,
        frozen: &Self::Frozen,
        t: R,
        x: &PerCoordinate<Self::Phase, Self::Action>,
    ) -> PerCoordinate<Self::Phase, Self::Action>;
}

/// Two pieces A and B, in this order, with {B, {B, {B, A}}} = 0: tables of Runge–Kutta–Nyström type keep their order.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no two pieces A and B with {{B, {{B, {{B, A}}}}}} = 0",
    label = "Runge–Kutta–Nyström tables would lose their order",
    note = "tables for any pieces: `BlanesMoan6X.of(PieceSplitting)`, `KahanLi8_17a.of(PieceSplitting)`"
)]
pub trait NystromPieces<R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// The equation d = Φ(d) of a step of the method `M` from x = (q, p, s), in a row, for its increment.
pub trait ContactEquation<M, R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// q, p and s in a row.
    type Unknown: Array<Real = R>;
    /// What depends on parameters and h.
    type Constants: Copy + core::fmt::Debug;
    /// What depends on x and t.
    type Start: Copy + core::fmt::Debug;

    /// What depends on parameters and h.
    fn constants(&self, h: R) -> Self::Constants;
    /// What all evaluations of a step from `x` have in common; `t` is the time of its middle.
    fn begin(&self, constants: &Self::Constants, t: R, x: &Self::Unknown) -> Self::Start;
    /// Φ and 1 − ∂Φ/∂d.
    fn image(
        &self,
        constants: &Self::Constants,
        start: &Self::Start,
        d: &Self::Unknown,
        f: &mut Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    );
    /// What a solution adds to x. Not a number if the step has none.
    fn end(&self, constants: &Self::Constants, start: &Self::Start, d: &Self::Unknown) -> Self::Unknown;
}
