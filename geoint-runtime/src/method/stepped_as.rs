//! Chooses the steps of a method by the kind of the system.

use crate::method::Method;
use crate::method::composition::SymmetricMap;
use crate::scalar::Real;
use crate::system::PhaseSpace;

/// A system whose steps of the method `M` are those of the method [`Steps`](Self::Steps). The attribute macros implement it.
///
/// [`ContactSplitting`](crate::ContactSplitting) and [`ContactLeapfrog`](crate::ContactLeapfrog) apply flows in closed form. Beside constraints one of the
/// flows has no closed form. A step of RATTLE replaces it, and the whole step is [`DampedRattle`](crate::method::constrained::DampedRattle).
#[diagnostic::on_unimplemented(
    message = "`{M}` is not a method for `{Self}`",
    label = "this method is for systems of `#[contact_hamiltonian]`, and of `#[lagrangian]` with `s`",
    note = "methods for T(p) + V(q) without dissipation: `StormerVerlet`, `BlanesMoan4`; for coupled q and p: `PieceSplitting`"
)]
pub trait SteppedAs<M, R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`].
    type Proof;
    /// The method of the steps.
    type Steps: Method<Self, R> + SymmetricMap + From<M>;
}
