//! What steps along a discrete gradient keep.

use crate::scalar::Real;
use crate::system::{Invariants, PhaseSpace};

/// A system whose energy, or what it keeps, has a discrete gradient.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no discrete gradient",
    label = "this method is for systems of `#[hamiltonian]` without `attitude`, and for Lagrangians that are quadratic in v or of a known conjugate",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait Keeping<R: Real = f64>: PhaseSpace<R> {
    /// What steps along the discrete gradient keep, and does not read time: rounding of many steps is taken away from that. `()` where damping takes it.
    type Kept: Invariants<Self, R> + Default;
    /// Whether that may be steep in a coordinate which has become small: a sum of powers of single coordinates is not.
    const STEEP: bool = true;
}

/// What steps along the discrete gradient of a system keep.
pub(crate) type KeptBy<S, R> = <S as Keeping<R>>::Kept;
