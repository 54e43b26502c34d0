//! What a system offers: the traits that `#[hamiltonian]` implements.
//!
//! Each trait is a proven property. A method asks for the traits that it needs, so using it on a system without the
//! property is a type error. Kernels are functions of prepared coefficients and of nested arrays; they hold no state.

use crate::array::{Array, Square};
use crate::integrator::Integrator;
use crate::method::Method;
use crate::real::Real;
use crate::state::{Coordinates, State};

/// A system with an energy H(q, p, t): q' = ∂H/∂p, p' = −∂H/∂q.
pub trait Hamiltonian<R: Real = f64>: Copy {
    /// Positions and momenta as the user writes them.
    type Coordinates: Coordinates<Real = R, Array = Self::Array>;
    /// Positions and momenta as kernels see them.
    type Array: Array<Real = R>;

    /// H at a point.
    fn hamiltonian(&self, t: R, q: &Self::Array, p: &Self::Array) -> R;

    /// ∂H/∂q and ∂H/∂p at a point.
    fn gradient(&self, t: R, q: &Self::Array, p: &Self::Array, dq: &mut Self::Array, dp: &mut Self::Array);

    /// The first function of H, if any, that is not defined at a point, and of which term.
    fn outside_domain(&self, t: R, q: &Self::Array, p: &Self::Array) -> Option<&'static str>;

    /// The energy of a state.
    fn energy(&self, state: &State<Self::Coordinates>) -> R {
        self.hamiltonian(state.t, &state.q.into_array(), &state.p.into_array())
    }

    /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
    ///
    /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
    fn integrator<M: Method<Self, R>>(
        self,
        method: M,
        h: R,
        state: State<Self::Coordinates>,
    ) -> Integrator<Self, M, R> {
        Integrator::new(self, method, h, state)
    }
}

/// H = T(p, t) + V(q, t): each part has an exact flow.
#[diagnostic::on_unimplemented(
    message = "kick and drift do not exist for `{Self}`",
    label = "H was not proven to be T(p) + V(q)",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait Separable<R: Real = f64>: Hamiltonian<R> {
    /// What a kick of given length needs from the parameters.
    type Kick: Copy;
    /// What a drift of given length needs from the parameters.
    type Drift: Copy;

    /// Coefficients of a kick of length `h`.
    fn prepare_kick(&self, h: R) -> Self::Kick;
    /// Coefficients of a drift of length `h`.
    fn prepare_drift(&self, h: R) -> Self::Drift;
    /// The flow of V at frozen time: p ← p − h ∂V/∂q.
    fn kick(kick: &Self::Kick, t: R, q: &Self::Array, p: &mut Self::Array);
    /// The flow of T at frozen time: q ← q + h ∂T/∂p.
    fn drift(drift: &Self::Drift, t: R, q: &mut Self::Array, p: &Self::Array);
}

/// T is a quadratic polynomial in p with constant coefficients: \[V, \[V, \[V, T\]\]\] = 0.
///
/// Runge–Kutta–Nyström tables need this; on any other T they would silently fall to order 3 or 4.
#[diagnostic::on_unimplemented(
    message = "the kinetic energy of `{Self}` is not quadratic in `p` with a constant mass matrix",
    label = "Runge–Kutta–Nyström tables lose their order on such a T",
    note = "tables for every separable energy: `StormerVerlet`, `BlanesMoan4`, `BlanesMoan6`, `Yoshida4.of(StormerVerlet)` …"
)]
pub trait QuadraticKinetic<R: Real = f64>: Separable<R> {}

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) for the tree discrete gradient ∇̄H, written in the increment and reduced as far as H allows.
pub trait DiscreteGradientStep<R: Real = f64>: Hamiltonian<R> {
    /// The increment that is solved for: of p alone if T is quadratic (that of q is then a linear function of it), else
    /// of q and p.
    type Increment: Array<Real = R>;
    /// What depends on parameters and h only.
    type Prepared: Copy;
    /// What depends on the start of the step.
    type Start: Copy;

    /// Coefficients for steps of length `h`.
    fn prepare(&self, h: R) -> Self::Prepared;
    /// Everything that Newton's iterations share, and an explicit guess of the increment.
    fn start(prepared: &Self::Prepared, t: R, q: &Self::Array, p: &Self::Array) -> (Self::Start, Self::Increment);
    /// What the increment is added to.
    fn origin(q: &Self::Array, p: &Self::Array) -> Self::Increment;
    /// The equation's left side minus its right side, and the derivative of that.
    fn residual(
        prepared: &Self::Prepared,
        start: &Self::Start,
        increment: &Self::Increment,
        residual: &mut Self::Increment,
        jacobian: &mut Square<Self::Increment>,
    );
    /// The end of the step.
    fn finish(
        prepared: &Self::Prepared,
        start: &Self::Start,
        increment: &Self::Increment,
        q: &mut Self::Array,
        p: &mut Self::Array,
    );
}

/// The differential equation in the form that collocation solves: y' = f(y, t) for y = (q, p); or, if T is quadratic,
/// q'' = M⁻¹f(q, t) with the force f = −∂V/∂q.
pub trait Collocation<R: Real = f64>: Hamiltonian<R> {
    /// y: an array of (q, p), or q alone. f has the same shape.
    type Unknown: Array<Real = R>;
    /// What depends on parameters only.
    type Prepared: Copy;
    /// The order of the differential equation, 1 or 2.
    const DERIVATIVE: usize;

    /// Coefficients.
    fn prepare(&self) -> Self::Prepared;
    /// y at a point; q' if the equation is of second order, else zero; and what f changes: y, or p.
    fn start(
        prepared: &Self::Prepared,
        q: &Self::Array,
        p: &Self::Array,
    ) -> (Self::Unknown, Self::Unknown, Self::Unknown);
    /// f, and its derivative ∂f/∂y (times M⁻¹ if the equation is of second order).
    fn field(
        prepared: &Self::Prepared,
        t: R,
        y: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// y ← y + w·f, or y + w·M⁻¹f.
    fn add(prepared: &Self::Prepared, w: R, f: &Self::Unknown, y: &mut Self::Unknown);
    /// (q, p) ← y; or q ← y, p ← p + impulse.
    fn finish(y: &Self::Unknown, impulse: &Self::Unknown, q: &mut Self::Array, p: &mut Self::Array);
}
