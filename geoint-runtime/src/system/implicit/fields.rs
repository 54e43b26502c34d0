//! The kernels of energies and vector fields for implicit methods: the field at a point, tree discrete gradients
//! ([`DiscreteGradient`](crate::DiscreteGradient)), and the stages of contact Hamiltonians.
//!
//! The attribute macros emit these traits for a system. Methods in the module `method` evaluate them. An associated `Proof` is `()`; a system without the
//! property lacks it.

use crate::scalar::Real;
use crate::solving::Inverse;
use crate::space::{Array, Square};
use crate::system::{Contact, Keeping, VectorField};

/// A system whose field is a polynomial of degree 2 at most. If the field belongs to an energy, the energy is a polynomial of degree 3 at most.
#[diagnostic::on_unimplemented(
    message = "the field of `{Self}` was not proven to be a polynomial of degree 2 at most",
    label = "Kahan's method needs such a field: an energy of degree 3",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait QuadraticField<R: Real = f64>: Collocation<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// The order of a differential equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EquationOrder {
    /// z' = f(z, t), for y = z.
    First,
    /// q'' = M⁻¹f(q, t), for y = q.
    Second,
}

impl EquationOrder {
    /// Returns whether the equation has the order 1.
    pub const fn is_first(self) -> bool {
        matches!(self, EquationOrder::First)
    }
}

/// The differential equation in the form in which implicit methods solve it: y' = f(y, t) for all coordinates y = z. The form is q'' = M⁻¹f(q, t) for y = q if
/// H = T(p) + V(q) with a quadratic T, and nothing is damped or forced. f = −∂V/∂q is then the force, and M the constant mass matrix.
///
/// Emitted by `#[vector_field]`, by `#[hamiltonian]` without constraint and attitude, and by `#[lagrangian]` without constraint and action. A Hamiltonian must have
/// a formula that the macro expands, and a Lagrangian such a Hamiltonian, or be linear in the velocities.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`, or has a `constraint`, an `attitude` or an action `s`",
    label = "this method does not fit this kind of system",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`"
)]
pub trait Collocation<R: Real = f64>: VectorField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// y: all coordinates, or q alone. f has the shape of y.
    type Unknown: Array<Real = R>;
    /// Coefficients that depend on parameters only.
    type Constants: Copy + core::fmt::Debug;
    /// The order of the differential equation for y.
    const EQUATION_ORDER: EquationOrder;

    /// Computes the coefficients that depend on parameters only.
    fn constants(&self) -> Self::Constants;
    /// Returns y, and the coordinates that f changes: (z, z) for [`EquationOrder::First`], (q, p) for [`EquationOrder::Second`].
    fn start(z: &Self::Phase) -> (Self::Unknown, Self::Unknown);
    /// Returns the part of y' apart from f: zero for the first order, q' = ∂T/∂p at the momentum `p` for the second.
    fn velocity(&self, constants: &Self::Constants, p: &Self::Unknown) -> Self::Unknown;
    /// Computes f and ∂f/∂y at the time `t`.
    fn field(
        &self,
        constants: &Self::Constants,
        t: R,
        y: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// Computes y ← y + w·f for the first order, y ← y + w·M⁻¹f for the second.
    fn add(&self, constants: &Self::Constants, w: R, f: &Self::Unknown, y: &mut Self::Unknown);
    /// Returns the increments of all coordinates: `change` for the first order, (`change`, `impulse`) of (q, p) for the second.
    fn increments(change: &Self::Unknown, impulse: &Self::Unknown) -> Self::Phase;
}

/// The computation of the mean of ∇H along a line, for [`MeanValue`](crate::MeanValue). An exact mean is known if H is the sum of a polynomial and of functions
/// of one linear form each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mean {
    /// H is a polynomial. Gauss's quadrature is exact with this number of points or more.
    Gauss(usize),
    /// The line is divided into 1, 2, … up to this number of parts, and the tree discrete gradient ∇̄H is averaged over the parts. The extrapolation of these
    /// averages is exact. With 1 the mean is ∇̄H.
    Parts(usize),
    /// No exact mean is known. Gauss's quadrature approximates it.
    NotClosed,
}

/// Start, middle and end time of a step. The end equals the start of the next step bit for bit, so changes of time-dependent functions telescope. The
/// length h may differ from `end − start` by a rounding.
#[derive(Clone, Copy, Debug)]
pub struct Span<R> {
    /// The time t at the start.
    pub start: R,
    /// t + h/2. Discrete gradients of H, damping and forces read this time.
    pub middle: R,
    /// The time at the end. First integrals that depend on time, and steps of order 4, read it and `start`.
    pub end: R,
}

impl<R: Real> Span<R> {
    /// Returns the times of a step of length `h` between its `ends`.
    #[inline(always)]
    pub fn of([start, end]: [R; 2], h: R) -> Self {
        Span { start, middle: start + R::from_f64(0.5) * h, end }
    }

    /// Returns one time three times, for an evaluation at frozen time.
    #[inline(always)]
    pub fn at(t: R) -> Self {
        Span { start: t, middle: t, end: t }
    }
}

/// The field f̄ with the tree discrete gradient ∇̄H between y and y + d in place of ∇H. It is f̄ = J∇̄H with the structure matrix J for
/// [`EquationOrder::First`], and f̄ = −∇̄V for [`EquationOrder::Second`]. With a damping matrix C, f̄ = (J − C)∇̄H. J, C and other forces are taken at the
/// mean of the two points. If a field has first integrals but no known J and H, f̄ is the field at the mean, projected so that a step keeps the integrals.
///
/// The discrete gradient of a quadratic T is the gradient at the mean momentum. It needs no kernel of its own.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`, or has a `constraint`, an `attitude` or an action `s`",
    label = "this method does not fit this kind of system",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`"
)]
pub trait DiscreteField<R: Real = f64>: Collocation<R> + Keeping<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients that depend on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// Coefficients that also depend on y and on the times of the step.
    type Start: Copy + core::fmt::Debug;
    /// `Inverted` if ∂f̄/∂d depends on parameters only, so that the matrix of a step is the same in all steps. Otherwise `()`.
    /// The macros choose it if H is a polynomial of degree 2 at most without time, damping is constant, and no other force acts.
    type Inverse: Inverse<Self::Unknown>;
    /// Computation of the mean of ∇H along the line from y to y + d.
    const MEAN: Mean = Mean::NotClosed;

    /// Computes the coefficients that depend on parameters and h only. f̄ does not depend on h, but [`equation`](Self::equation) and [`drift`](Self::drift) do.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// Computes the coefficients that all evaluations from `y` have in common.
    fn begin(&self, parameters: &Self::Parameters, span: Span<R>, y: &Self::Unknown) -> Self::Start;
    /// Computes f̄, and ∂f̄/∂d in `jacobian`.
    fn slope(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// Computes the right-hand side of a step, u = h·f̄(d(u)) with the impulse u as unknown: h·f̄ in `image`, and 1 − ∂(h·f̄)/∂u in `matrix`. The increment is
    /// d = u for the first order, and d = h ∂T/∂p(p + u/2) for the second.
    ///
    /// For at most twelve unknowns, but not for y = (q, p), the macros override this function by a kernel whose constants contain h and the masses.
    #[inline(always)]
    fn equation(
        &self,
        (constants, h): (&Self::Constants, R),
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        image: &mut Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    ) {
        self.slope(parameters, start, d, image, matrix);
        for f in image.as_mut_slice() {
            *f = h * *f;
        }
        // ∂d/∂u is 1, or h/2 M⁻¹. Another factor h multiplies f̄.
        let w = if Self::EQUATION_ORDER.is_first() { h } else { R::from_f64(0.5) * h * h };
        for (i, row) in Self::Unknown::entries::<Self::Unknown>(matrix).iter_mut().enumerate() {
            // M⁻¹ is symmetric, so `add` computes the product of the row and M⁻¹.
            let slope = core::mem::replace(row, Self::Unknown::nothing());
            self.add(constants, -w, &slope, row);
            row.as_mut_slice()[i] += R::from_f64(1.0);
        }
    }
    /// Returns h ∂T/∂p((p₀ + p₁)/2) from `sum` = p₀ + p₁. Called for [`EquationOrder::Second`] only.
    fn drift(&self, parameters: &Self::Parameters, sum: &Self::Unknown) -> Self::Unknown;
}

/// The equation of a step of order 4 that keeps first integrals, z₁ − z₀ = h v. The projected mean velocity is v = F − G(GᵀG)⁻¹GᵀF. The columns of G are the
/// tree discrete gradients of the integrals between z₀ and z₁. F is Simpson's rule for the mean velocity: F = (f(z₀) + 4 f(c) + f(z₁))/6. Here
/// c = m + h/8 (f(z₀) − f(z₁)), and m is the mean of z₀ and z₁. Canonical systems use a metric in place of the unit matrix of the projection; see
/// `method/discrete_gradient/canonical.rs`.
///
/// By the discrete chain rule, the exact mean velocity is orthogonal to every discrete gradient. The projection does not change it, so the step has the
/// order of F.
#[diagnostic::on_unimplemented(
    message = "`FourthOrder(DiscreteGradient)` has nothing to keep in `{Self}`, or constraints stand in its way",
    label = "it keeps an energy, or first integrals",
    note = "methods for every field: `Gauss`, `ImplicitMidpoint`, `RK4`, `DOP853`",
    note = "with a `constraint`: `Suzuki4.of(DiscreteGradient)`, `Suzuki4.of(Rattle)`"
)]
pub trait FourthOrderField<R: Real = f64>: VectorField<R> + Keeping<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients that depend on parameters and h only.
    type FourthParameters: Copy + core::fmt::Debug;
    /// Coefficients that also depend on the start of a step.
    type FourthStart: Copy;

    /// Computes the coefficients that depend on parameters and h only.
    fn fourth_parameters(&self, h: R) -> Self::FourthParameters;
    /// Computes the coefficients that all evaluations of a step from `z` have in common.
    fn fourth_begin(&self, parameters: &Self::FourthParameters, span: Span<R>, z: &Self::Phase) -> Self::FourthStart;
    /// Writes h times the projected mean velocity between z and z + d to `image`, and 1 − ∂(image)/∂d to `matrix`.
    fn fourth_slope(
        &self,
        parameters: &Self::FourthParameters,
        start: &Self::FourthStart,
        d: &Self::Phase,
        image: &mut Self::Phase,
        matrix: &mut Square<Self::Phase>,
    );
    /// Excludes momenta whose gradients, columns of G, nearly depend on the columns before them, from all later evaluations of the step: with them GᵀG is nearly
    /// singular. The first column belongs to the energy, and stays. Returns `false` if the system keeps no momenta that the macros have found.
    fn fourth_loosen(start: &mut Self::FourthStart) -> bool {
        let _ = start;
        false
    }
}

/// The field of a contact Hamiltonian H at the stages of Gauss methods.
pub trait ContactStages<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The unknowns of a stage: q, p and s in a row. The row has no s if ∂H/∂s depends on time alone.
    type Moved: Array<Real = R>;
    /// Coefficients that depend on parameters only.
    type StageConstants: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters only.
    fn stage_constants(&self) -> Self::StageConstants;
    /// Computes the row ∂H/∂p, −∂H/∂q, and p·∂H/∂p − H if s is an unknown, and σ = ∂H/∂s. Computes the derivatives of both by the unknowns. The row has no
    /// friction −σp, because stages advance r·p with the factor r' = rσ, and (r·p)' = −r ∂H/∂q.
    fn stage(
        &self,
        constants: &Self::StageConstants,
        t: R,
        x: &Self::Moved,
        values: (&mut Self::Moved, &mut R),
        derivatives: (&mut Square<Self::Moved>, &mut Self::Moved),
    );
    /// Returns σ = ∂H/∂s alone.
    fn decay(&self, constants: &Self::StageConstants, t: R, x: &Self::Moved) -> R;
    /// Returns s' = p·∂H/∂p − H.
    fn action(&self, constants: &Self::StageConstants, t: R, z: &Self::Phase, s: &R) -> R;
}
