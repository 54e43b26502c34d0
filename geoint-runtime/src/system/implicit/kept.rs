//! Invariants of steps along a discrete gradient.

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
    /// Invariants of steps along the discrete gradient that do not read time. The rounding of many steps is removed from these invariants. `()` if
    /// damping changes them.
    type Kept: Invariants<Self, R> + Default;
    /// True if an invariant may be steep in a coordinate that has become small. A sum of powers of single coordinates is not steep.
    const STEEP: bool = true;
}

/// Invariants of steps along the discrete gradient of a system.
pub(crate) type KeptBy<S, R> = <S as Keeping<R>>::Kept;
