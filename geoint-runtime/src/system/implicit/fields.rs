//! The kernels of energies and vector fields for implicit methods: the field at a point, discrete gradients, and the stages of contact Hamiltonians.
//!
//! The attributes implement these traits for a system. Methods in the module `method` evaluate them.

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
    /// z' = f(z, t). y is z.
    First,
    /// q'' = M⁻¹f(q, t). y is q.
    Second,
}

impl EquationOrder {
    /// Returns whether the equation has the order 1.
    pub const fn is_first(self) -> bool {
        matches!(self, EquationOrder::First)
    }
}

/// The differential equation in the form in which implicit methods solve it: y' = f(y, t) for all coordinates y = z. If H = T(p) + V(q) with a quadratic T,
/// the form is q'' = M⁻¹f(q, t) with y = q, the force f = −∂V/∂q and the mass matrix M.
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
    /// Returns y, and the coordinates that f changes: y, or p.
    fn start(z: &Self::Phase) -> (Self::Unknown, Self::Unknown);
    /// Returns the part of y' apart from f: zero, or q' = ∂T/∂p at the momentum `p`.
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
    /// Computes y ← y + w·f, or y + w·M⁻¹f.
    fn add(&self, constants: &Self::Constants, w: R, f: &Self::Unknown, y: &mut Self::Unknown);
    /// Returns the increments of all coordinates: `change` if y = z, or `change` for q and `impulse` for p.
    fn increments(change: &Self::Unknown, impulse: &Self::Unknown) -> Self::Phase;
}

/// The computation of the mean of ∇H along a line, for [`MeanValue`](crate::MeanValue). The mean is exact if H is a sum of functions of linear forms and of
/// a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mean {
    /// H is a polynomial. The quadrature of Gauss with this number of points is exact.
    Gauss(usize),
    /// The mean is an extrapolation. The line is divided into 1, 2, … up to this number of parts, and ∇̄H is averaged over the parts. With 1 the mean is
    /// ∇̄H.
    Parts(usize),
    /// No exact mean is known.
    NotClosed,
}

/// Start, midpoint and end time of a step. The end equals the start of the next step bit for bit, so changes of time-dependent functions telescope. The
/// length h may differ from `end − start` by a rounding.
#[derive(Clone, Copy, Debug)]
pub struct Span<R> {
    /// The time of the first point.
    pub start: R,
    /// The time of the middle.
    pub middle: R,
    /// The time of the last point.
    pub end: R,
}

impl<R: Real> Span<R> {
    /// Returns the times of a step of length `h` between its `ends`.
    #[inline(always)]
    pub fn of([start, end]: [R; 2], h: R) -> Self {
        Span { start, middle: start + R::from_f64(0.5) * h, end }
    }

    /// Returns the times of an evaluation at one moment.
    #[inline(always)]
    pub fn at(t: R) -> Self {
        Span { start: t, middle: t, end: t }
    }
}

/// The field f̄ with the tree discrete gradient ∇̄H between y and y + d in place of ∇H: f̄ = J∇̄H with the structure matrix J, or −∇̄V if T is quadratic.
/// With a damping matrix R, f̄ = (J − R)∇̄H, and R is taken at the mean of the two points.
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
    /// Coefficients that depend on y and on the times of the step.
    type Start: Copy + core::fmt::Debug;
    /// [`Inverted`](crate::system::Inverted) if f̄ is affine in d, so that the matrix of a step is the same in all steps. H is then a polynomial of degree
    /// 2 that does not depend on time, and damping is constant. Otherwise `()`.
    type Inverse: Inverse<Self::Unknown>;
    /// Computation of the mean of ∇H along the line from y to y + d.
    const MEAN: Mean = Mean::NotClosed;

    /// Computes the coefficients that depend on parameters and h only. f̄ does not depend on h.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// Computes the coefficients that all evaluations from `y` have in common.
    fn begin(&self, parameters: &Self::Parameters, span: Span<R>, y: &Self::Unknown) -> Self::Start;
    /// Computes f̄ and ∂f̄/∂d.
    fn slope(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// Computes the impulse h·f̄, and 1 − ∂(h·f̄)/∂(impulse). The increment d is the impulse itself, or d = h ∂T/∂p(p + impulse/2).
    ///
    /// The attributes override this function for few unknowns: h and the masses are then part of the constants of the kernel.
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
        let w = if Self::EQUATION_ORDER.is_first() { h } else { R::from_f64(0.5) * h * h };
        for (i, row) in Self::Unknown::entries::<Self::Unknown>(matrix).iter_mut().enumerate() {
            let slope = core::mem::replace(row, Self::Unknown::nothing());
            self.add(constants, -w, &slope, row);
            row.as_mut_slice()[i] += R::from_f64(1.0);
        }
    }
    /// Returns h ∂T/∂p at the mean of two momenta with this sum, if T is quadratic.
    fn drift(&self, parameters: &Self::Parameters, sum: &Self::Unknown) -> Self::Unknown;
}

/// The equation of a step of order 4 that keeps first integrals, z₁ − z₀ = h (F − G(GᵀG)⁻¹GᵀF). The columns of G are the tree discrete gradients of the
/// integrals between z₀ and z₁. F is Simpson's rule for the mean velocity: F = (f(z₀) + 4 f(c) + f(z₁))/6. Here c = m + h/8 (f(z₀) − f(z₁)), and m is the
/// mean of z₀ and z₁. Canonical systems use a metric in place of the unit matrix of the projection; see `method/discrete_gradient/canonical.rs`.
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
    /// Coefficients that depend on parameters and h.
    type FourthParameters: Copy + core::fmt::Debug;
    /// Coefficients that depend on the start of a step.
    type FourthStart: Copy;

    /// Computes the coefficients that depend on parameters and h.
    fn fourth_parameters(&self, h: R) -> Self::FourthParameters;
    /// Computes the coefficients that all evaluations of a step from `z` have in common.
    fn fourth_begin(&self, parameters: &Self::FourthParameters, span: Span<R>, z: &Self::Phase) -> Self::FourthStart;
    /// Writes h times the mean velocity to `image`, and 1 − ∂(image)/∂d to `matrix`.
    fn fourth_slope(
        &self,
        parameters: &Self::FourthParameters,
        start: &Self::FourthStart,
        d: &Self::Phase,
        image: &mut Self::Phase,
        matrix: &mut Square<Self::Phase>,
    );
    /// Makes all later evaluations of the step exclude conserved momenta whose gradients nearly depend on the gradient of the energy, because GᵀG is nearly
    /// singular with them. Only momenta that the user has not named are excluded. Returns `false` if the system has no such momenta.
    fn fourth_loosen(start: &mut Self::FourthStart) -> bool {
        let _ = start;
        false
    }
}

/// The field of a contact Hamiltonian H at the stages of Gauss methods.
pub trait ContactStages<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The unknowns of a stage: q, p and s in a row. The row has no s if ∂H/∂s depends on time alone, and positions and momenta do not read s.
    type Moved: Array<Real = R>;
    /// Coefficients that depend on parameters only.
    type StageConstants: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters only.
    fn stage_constants(&self) -> Self::StageConstants;
    /// Computes two values at a stage: the row ∂H/∂p, −∂H/∂q, and p·∂H/∂p − H if s is an unknown; and σ = ∂H/∂s. Computes the derivatives of both by the
    /// unknowns.
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
