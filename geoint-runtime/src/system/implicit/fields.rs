//! The differential equation as implicit methods solve it.

use crate::scalar::Real;
use crate::solving::Inverse;
use crate::space::{Array, Square};
use crate::system::{ByTree, Collocated, Graded, VectorField};

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
    message = "`{Self}` is no system of `#[hamiltonian]` without constraints",
    label = "this method is for those",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`"
)]
pub trait Collocation<R: Real = f64>: VectorField<R> + Collocated<R> {
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

/// When a step starts, when it is half way, and when it ends, which is when the next one starts: to the last bit, so that what a function of
/// time changes by in many steps is what it changes by in all of them. The length of a step is not that of its time, which is rounded.
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
    message = "`{Self}` is no system of `#[hamiltonian]` without constraints",
    label = "this method is for those",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for every contact Hamiltonian: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`"
)]
pub trait DiscreteField<R: Real = f64>: Collocation<R> + Graded<R, Gradient = ByTree> {
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
