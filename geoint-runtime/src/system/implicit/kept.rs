//! Systems with discrete gradient steps, and the invariants that these steps keep to rounding.

use crate::scalar::Real;
use crate::system::{Invariants, PhaseSpace};

/// A system with discrete gradient steps. It names the invariants that these steps keep to rounding: energy and momenta, or first integrals of a field.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no discrete gradient",
    label = "this method is for systems of `#[hamiltonian]` without `attitude`, and for Lagrangians that are quadratic in v or of a known conjugate",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait Keeping<R: Real = f64>: PhaseSpace<R> {
    /// The kept invariants that do not read time. A run removes the drift that rounding causes in them, after each 1024 steps. Invariants that read time drift. `()` if no invariant remains,
    /// for instance with damping.
    type Kept: Invariants<Self, R> + Default;
    /// Whether an invariant of a field may be steep: a coordinate that a step makes much smaller keeps the absolute rounding error of its earlier size, and this
    /// error times the derivative may exceed the rounding of the invariant. `check_step` in `method/corrected/rounded.rs` then marks a fast step for repetition
    /// if a coordinate changes its magnitude.
    ///
    /// A sum with one power c xᵢⁿ of each coordinate, n ≥ 1, is not steep: the rounding error of xᵢ is ε max|xᵢ|, the derivative is at most n c max|xᵢ|ⁿ⁻¹, and the
    /// product is n ε times the largest term. Steps of systems with momenta do not read the constant. `true` is always safe.
    const STEEP: bool = true;
}

/// [`Keeping::Kept`] of a system.
pub(crate) type KeptBy<S, R> = <S as Keeping<R>>::Kept;
