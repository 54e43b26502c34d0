//! The invariants that discrete gradient steps of a system keep to rounding.

use crate::scalar::Real;
use crate::system::{Invariants, PhaseSpace};

/// A system with a discrete gradient of its energy, or of its invariants.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no discrete gradient",
    label = "this method is for systems of `#[hamiltonian]` without `attitude`, and for Lagrangians that are quadratic in v or of a known conjugate",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait Keeping<R: Real = f64>: PhaseSpace<R> {
    /// The invariants that steps keep and that do not read time. A run removes the rounding error of many steps from them. `()` if there are none, for
    /// instance with damping.
    type Kept: Invariants<Self, R> + Default;
    /// `true` if an invariant of a field may be steep in a coordinate that has become small. Rounding of this coordinate then changes the invariant by more
    /// than its last digits, and steps need a check. A sum of powers of single coordinates is not steep. Systems with momenta do not read the constant.
    const STEEP: bool = true;
}

/// The invariants that discrete gradient steps of `S` keep.
pub(crate) type KeptBy<S, R> = <S as Keeping<R>>::Kept;
