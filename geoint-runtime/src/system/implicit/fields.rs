//! The differential equation as implicit methods solve it.

use crate::scalar::Real;
use crate::solving::Inverse;
use crate::space::{Array, Square};
use crate::system::{Contact, Keeping, VectorField};

/// The field is a polynomial of degree 2 at most: of an energy, one of degree 3.
#[diagnostic::on_unimplemented(
    message = "the field of `{Self}` was not proven to be a polynomial of degree 2 at most",
    label = "Kahan's method needs such a field: an energy of degree 3",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait QuadraticField<R: Real = f64>: Collocation<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// The differential equation in the form in which implicit methods solve it: y' = f(y, t) for all coordinates y = z; or, if T is
/// quadratic, q'' = M⁻¹f(q, t) with the force f = −∂V/∂q.
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
    /// y: all coordinates, or q alone. f has the same shape.
    type Unknown: Array<Real = R>;
    /// What depends on parameters only.
    type Constants: Copy + core::fmt::Debug;
    /// The order of the differential equation, 1 or 2.
    const DERIVATIVE: usize;

    /// What depends on parameters only.
    fn constants(&self) -> Self::Constants;
    /// y, and what f changes: y, or p.
    fn start(z: &Self::Phase) -> (Self::Unknown, Self::Unknown);
    /// What y' is apart from f: nothing, or q' = ∂T/∂p.
    fn velocity(&self, constants: &Self::Constants, p: &Self::Unknown) -> Self::Unknown;
    /// f and ∂f/∂y.
    fn field(
        &self,
        constants: &Self::Constants,
        t: R,
        y: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// y ← y + w·f, or y + w·M⁻¹f.
    fn add(&self, constants: &Self::Constants, w: R, f: &Self::Unknown, y: &mut Self::Unknown);
    /// The increments of all coordinates: that of y; or that of q = y, and the impulse.
    fn increments(change: &Self::Unknown, impulse: &Self::Unknown) -> Self::Phase;
}

/// How the mean of ∇H along a line is had: exactly, if H is a sum of functions of linear forms and of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mean {
    /// By so many points of Gauss: H is a polynomial.
    Gauss(usize),
    /// By extrapolation of ∇̄H over the parts of the line in 1, 2, … so many; with 1 it is ∇̄H.
    Parts(usize),
    /// No closed form is known.
    NotClosed,
}

/// Start, midpoint and end time of a step. The end equals the start of the next step bit for bit, so changes of time-dependent functions telescope.
/// The length of the step may differ from `end − start` by a rounding.
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
    /// Those of a step of length `h` between its `ends`.
    #[inline(always)]
    pub fn of([start, end]: [R; 2], h: R) -> Self {
        Span { start, middle: start + R::from_f64(0.5) * h, end }
    }

    /// Those of what is evaluated at one moment.
    #[inline(always)]
    pub fn at(t: R) -> Self {
        Span { start: t, middle: t, end: t }
    }
}

/// The field with the tree discrete gradient ∇̄H between y and y + d in place of ∇H: f̄ = J∇̄H; or −∇̄V, if T is quadratic.
/// With damping f̄ = (J − R)∇̄H, R at the mean of the two points.
///
/// The mean gradient of a quadratic T is that of the mean momentum, so that it needs no kernel of its own.
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
    /// What depends on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// What depends on y and on times.
    type Start: Copy + core::fmt::Debug;
    /// [`Inverted`](crate::system::Inverted) where f̄ is affine in d, so that the matrix of a step is constant: H is a polynomial of
    /// degree 2 that does not depend on time, and damping is constant. Elsewhere `()`.
    type Inverse: Inverse<Self::Unknown>;
    /// How the mean of ∇H along the line from y to y + d is had.
    const MEAN: Mean = Mean::NotClosed;

    /// What depends on parameters and h only. f̄ does not depend on h.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// What all evaluations from `y` have in common.
    fn begin(&self, parameters: &Self::Parameters, span: Span<R>, y: &Self::Unknown) -> Self::Start;
    /// f̄ and ∂f̄/∂d.
    fn slope(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// h·f̄, and 1 − ∂(h·f̄)/∂(impulse) for d = impulse, or d = h ∂T/∂p(p + impulse/2).
    ///
    /// A kernel of few unknowns is written with h and masses in its constants instead.
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
        let w = if Self::DERIVATIVE == 1 { h } else { R::from_f64(0.5) * h * h };
        for (i, row) in Self::Unknown::entries::<Self::Unknown>(matrix).iter_mut().enumerate() {
            let slope = core::mem::replace(row, Self::Unknown::nothing());
            self.add(constants, -w, &slope, row);
            row.as_mut_slice()[i] += R::from_f64(1.0);
        }
    }
    /// h ∂T/∂p at the mean of two momenta whose sum this is, if T is quadratic.
    fn drift(&self, parameters: &Self::Parameters, sum: &Self::Unknown) -> Self::Unknown;
}

/// The equation of a step of order 4 that keeps first integrals, z₁ − z₀ = h (F − G(GᵀG)⁻¹GᵀF): the tree discrete gradients of the
/// integrals are the columns of G, and F = (f(z₀) + 4 f(c) + f(z₁))/6 with c = m + h/8 (f(z₀) − f(z₁)) and the middle m.
///
/// The exact mean velocity is orthogonal to every discrete gradient, by the discrete chain rule: the projection leaves it alone, so that
/// the step has the order of F, whatever the integrals are.
#[diagnostic::on_unimplemented(
    message = "`FourthOrder(DiscreteGradient)` has nothing to keep in `{Self}`, or constraints stand in its way",
    label = "it keeps an energy, or first integrals",
    note = "methods for every field: `Gauss`, `ImplicitMidpoint`, `RK4`, `DOP853`",
    note = "with a `constraint`: `Suzuki4.of(DiscreteGradient)`, `Suzuki4.of(Rattle)`"
)]
pub trait FourthOrderField<R: Real = f64>: VectorField<R> + Keeping<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What depends on parameters and h.
    type FourthParameters: Copy + core::fmt::Debug;
    /// What depends on the start of a step.
    type FourthStart: Copy;

    /// What depends on parameters and h.
    fn fourth_parameters(&self, h: R) -> Self::FourthParameters;
    /// What all evaluations of a step from `z` have in common.
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
    /// From now on gradients of momenta that nearly depend on that of the energy take no part, if there are momenta that nobody has named.
    fn fourth_loosen(start: &mut Self::FourthStart) -> bool {
        let _ = start;
        false
    }
}

/// The field of H as contact Gauss methods evaluate it at their stages.
pub trait ContactStages<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// q, p and s in a row; or q and p, where ∂H/∂s depends on time alone, and positions and momenta do not read s.
    type Moved: Array<Real = R>;
    /// What depends on parameters only.
    type StageConstants: Copy + core::fmt::Debug;

    /// What depends on parameters only.
    fn stage_constants(&self) -> Self::StageConstants;
    /// ∂H/∂p, −∂H/∂q, and p·∂H/∂p − H if s is among the unknowns; ∂H/∂s; and the derivatives of both.
    fn stage(
        &self,
        constants: &Self::StageConstants,
        t: R,
        x: &Self::Moved,
        values: (&mut Self::Moved, &mut R),
        derivatives: (&mut Square<Self::Moved>, &mut Self::Moved),
    );
    /// ∂H/∂s alone.
    fn decay(&self, constants: &Self::StageConstants, t: R, x: &Self::Moved) -> R;
    /// s' = p·∂H/∂p − H.
    fn action(&self, constants: &Self::StageConstants, t: R, z: &Self::Phase, s: &R) -> R;
}
