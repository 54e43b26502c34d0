//! How the equations of implicit steps are posed: by a field in positions and momenta, or by a Lagrangian in velocities.

use crate::scalar::Real;
use crate::system::{Contact, Invariants, PhaseSpace};

/// A system whose steps of Gauss collocation can be solved for.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`, or has a `constraint`, an `attitude` or an action `s`",
    label = "this method does not fit this kind of system",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`"
)]
pub trait Collocated<R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// [`ByField`], [`ByVelocities`] or [`ByCanonical`].
    type Stages;
}

/// Stages are solved for values of the field: see [`Collocation`](super::Collocation).
#[derive(Clone, Copy, Debug)]
pub struct ByField;

/// Stages are solved for velocities: see [`VelocityForm`](super::VelocityForm).
#[derive(Clone, Copy, Debug)]
pub struct ByVelocities;

/// Stages are solved for points, moved by their canonical coordinates: see [`CanonicalForm`](super::CanonicalForm).
#[derive(Clone, Copy, Debug)]
pub struct ByCanonical;

/// A system whose energy, or what it keeps, has a discrete gradient.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no discrete gradient",
    label = "this method is for systems of `#[hamiltonian]` without `attitude`, and for Lagrangians that are quadratic in v or of a known conjugate",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait Graded<R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// [`ByTree`], [`ByPolarisation`] or [`ByConstraint`].
    type Gradient;
    /// What steps along it keep, and does not read time: rounding of many steps is taken away from that. `()` where damping takes it.
    type Kept: Invariants<Self, R> + Default;
    /// Whether that may be steep in a coordinate which has become small: a sum of powers of single coordinates is not.
    const STEEP: bool = true;
}

/// What steps along the discrete gradient of a system keep.
pub(crate) type KeptBy<S, R> = <S as Graded<R>>::Kept;

/// The tree discrete gradient: see [`DiscreteField`](super::DiscreteField).
#[derive(Clone, Copy, Debug)]
pub struct ByTree;

/// With constraints: see [`ConstrainedStep`](super::ConstrainedStep).
#[derive(Clone, Copy, Debug)]
pub struct ByConstraint;

/// The polarised one: see [`PolarisedForm`](super::PolarisedForm).
#[derive(Clone, Copy, Debug)]
pub struct ByPolarisation;

/// A contact system whose steps of Gauss collocation can be solved for: momenta are followed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no contact Gauss methods",
    label = "this method is for contact Hamiltonians whose momenta are followed: not for a `lift`, nor with `rayleigh` or `force` beside an action",
    note = "methods for a lift: `ContactSplitting` and its compositions",
    note = "methods with forces beside an action: `DOP853`, `RK4`, and Taylor series by `system.taylor`"
)]
pub trait ContactCollocated<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What [`ContactGauss`](crate::ContactGauss) solves for: [`ByField`] or [`ByVelocities`].
    type Stages;
    /// The same of [`ContactMidpoint`](crate::ContactMidpoint).
    type Midpoint;
}

/// A contact system whose energy has a discrete gradient.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no discrete gradient of a contact system",
    label = "this method is for contact Hamiltonians whose momenta are followed: not for a `lift`, nor with `rayleigh` or `force` beside an action",
    note = "methods for a lift: `ContactSplitting` and its compositions",
    note = "methods with forces beside an action: `DOP853`, `RK4`, and Taylor series by `system.taylor`"
)]
pub trait ContactGraded<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// [`ByTree`] or [`ByPolarisation`].
    type Gradient;
}
