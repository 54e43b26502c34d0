//! Dissipative and driven systems: what `#[contact_hamiltonian]` implements, and the methods for it.
//!
//! H(q, p, s, t) moves q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H. The flow multiplies the form ds − p dq by a factor,
//! and so do all methods here but those that keep the decay of H instead.

mod discrete_gradient;
mod implicit;
mod leapfrog;
mod midpoint;
mod splitting;

pub use discrete_gradient::ContactDiscreteGradient;
pub use implicit::ImplicitStep;
pub use leapfrog::ContactLeapfrog;
pub use midpoint::ContactMidpoint;
pub use splitting::{ContactSplitting, PieceComposition};

use crate::real::Real;
use crate::system::{PhaseSpace, Separable};

/// A system with a contact Hamiltonian H(q, p, s, t).
pub trait Contact<R: Real = f64>: PhaseSpace<R, Action = R> {
    /// ∂H/∂q, ∂H/∂p and ∂H/∂s at a point.
    #[expect(clippy::too_many_arguments, reason = "a point and its gradient")]
    fn gradient(
        &self,
        t: R,
        q: &Self::Array,
        p: &Self::Array,
        s: &R,
        dq: &mut Self::Array,
        dp: &mut Self::Array,
        ds: &mut R,
    );
}

/// (q, p) moves without s: H = g(t)·s + H₀(q, p, t).
#[diagnostic::on_unimplemented(
    message = "positions and momenta of `{Self}` do not move without the action",
    label = "s acts back on q or p, and has to be followed"
)]
pub trait Conformal<R: Real = f64>: Contact<R> {}

/// H = T(p, t) + g(t)·s + V(q, t).
#[diagnostic::on_unimplemented(message = "`{Self}` was not proven to be T(p) + g·s + V(q)")]
pub trait Mechanical<R: Real = f64>: Contact<R> + Separable<R> {
    /// What a drift of given length needs from the parameters.
    type FreeDrift: Copy;

    /// Coefficients of a drift of length `h`.
    fn prepare_free_drift(&self, h: R) -> Self::FreeDrift;
    /// The flow of T alone.
    fn free_drift(drift: &Self::FreeDrift, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut R);
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

/// A part of H.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its formula.
    pub name: &'static str,
    /// Its time.
    pub clock: Clock,
}

/// H is a sum of pieces whose flows are known in closed form.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no contact Hamiltonian that was split into pieces",
    label = "this method is for those",
    note = "methods for every contact Hamiltonian: `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods for T(p) + V(q) without dissipation: `StormerVerlet`, `BlanesMoan4`, …"
)]
pub trait Pieces<R: Real = f64>: Contact<R> {
    /// The pieces; the last one is in the middle of a step.
    const PIECES: &'static [Piece];
    /// What flows of given lengths need from the parameters.
    type Flows: Copy + core::fmt::Debug;
    /// What they need from the time at which it is frozen.
    type Frozen: Copy + core::fmt::Debug;

    /// Coefficients for flows of length `last` of the last piece, and of length `outer` of the others.
    fn prepare_flows(&self, outer: R, last: R) -> Self::Flows;
    /// Freezes time at `t`.
    fn freeze(flows: &Self::Flows, t: R) -> Self::Frozen;
    /// The flow of a piece, from time t on if it is exact in time. Not a number where it ends before.
    fn flow(
        piece: usize,
        flows: &Self::Flows,
        frozen: &Self::Frozen,
        t: R,
        q: &mut Self::Array,
        p: &mut Self::Array,
        s: &mut R,
    );
}
