//! What a system offers: the traits that `#[hamiltonian]` implements.
//!
//! Each trait is a proven property. A method asks for the traits that it needs, so using it on a system without the
//! property is a type error. Kernels are functions of prepared coefficients and of nested arrays; they hold no state.

use crate::adaptive::Adaptive;
use crate::array::{Array, Square};
use crate::integrator::Integrator;
use crate::method::Method;
use crate::real::Real;
use crate::state::{Action, Coordinates};

/// A phase space with an energy on it.
pub trait PhaseSpace<R: Real = f64>: Copy {
    /// Positions and momenta as the user writes them.
    type Coordinates: Coordinates<Real = R, Array = Self::Array>;
    /// Positions and momenta as kernels see them.
    type Array: Array<Real = R>;
    /// What phase space has beside them: the action `R` of a contact system, or nothing.
    type Action: Action<R>;

    /// H at a point.
    fn hamiltonian(&self, t: R, q: &Self::Array, p: &Self::Array, s: &Self::Action) -> R;

    /// The first function of H, if any, that is not defined at a point, and of which term.
    fn outside_domain(&self, t: R, q: &Self::Array, p: &Self::Array, s: &Self::Action) -> Option<&'static str>;

    /// The first pole of H, if any, between two points, each with its time: what H divides by, or takes a logarithm of, is zero
    /// there and has another sign at the second point than at the first.
    ///
    /// A step that looks at H on both sides only would not notice. Implicit methods ask before they take one.
    #[inline(always)]
    fn pole_between(
        &self,
        _t: [R; 2],
        _q: [&Self::Array; 2],
        _p: [&Self::Array; 2],
        _s: [&Self::Action; 2],
    ) -> Option<&'static str> {
        None
    }

    /// The same as [`pole_between`](PhaseSpace::pole_between) of the poles of contact systems in time alone, asked before every step
    /// is accepted: a flow at frozen time does not notice them.
    #[inline(always)]
    fn singular_time_between(
        &self,
        _t: [R; 2],
        _q: [&Self::Array; 2],
        _p: [&Self::Array; 2],
        _s: [&Self::Action; 2],
    ) -> Option<&'static str> {
        None
    }

    /// The energy of a state.
    fn energy(&self, state: &StateOf<Self, R>) -> R {
        let (t, q, p, s) = Self::Action::parts(*state);
        self.hamiltonian(t, &q.into_array(), &p.into_array(), &s)
    }

    /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
    ///
    /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
    fn integrator<M: Method<Self, R>>(self, method: M, h: R, state: StateOf<Self, R>) -> Integrator<Self, M, R> {
        Integrator::new(self, method, h, state)
    }
}

/// What a step of order 2 keeps in place of H, to the next order.
///
/// Of [`StormerVerlet`](crate::StormerVerlet), or of [`ContactSplitting`](crate::ContactSplitting) for a contact system: the steps are
/// those of the exact flow of H + h²H₂, but for an error of h⁵ a step. Thus h²H₂ says how far H itself goes off, and what
/// H + h²H₂ goes off by how long the step still is. E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006),
/// section IX.4.
pub trait ModifiedEnergy<R: Real = f64>: PhaseSpace<R> {
    /// H + h²H₂ at a point.
    fn modified_hamiltonian(&self, h: R, t: R, q: &Self::Array, p: &Self::Array, s: &Self::Action) -> R;

    /// H + h²H₂ of a state.
    fn modified_energy(&self, h: R, state: &StateOf<Self, R>) -> R {
        let (t, q, p, s) = Self::Action::parts(*state);
        self.modified_hamiltonian(h, t, &q.into_array(), &p.into_array(), &s)
    }
}

/// Points of the phase space of a system: [`State`](crate::State), or [`ContactState`](crate::ContactState).
pub type StateOf<S, R> = <<S as PhaseSpace<R>>::Action as Action<R>>::State<<S as PhaseSpace<R>>::Coordinates>;

/// A system with an energy H(q, p, t): q' = ∂H/∂p, p' = −∂H/∂q, less C ∂H/∂p if it is damped.
pub trait Hamiltonian<R: Real = f64>: PhaseSpace<R, Action = ()> {
    /// ∂H/∂q and ∂H/∂p at a point.
    fn gradient(&self, t: R, q: &Self::Array, p: &Self::Array, dq: &mut Self::Array, dp: &mut Self::Array);

    /// q' and p' at a point.
    #[inline(always)]
    fn rate(&self, t: R, q: &Self::Array, p: &Self::Array, dq: &mut Self::Array, dp: &mut Self::Array) {
        self.gradient(t, q, p, dp, dq);
        for slope in dp.as_mut_slice() {
            *slope = -*slope;
        }
    }

    /// The same as [`pole_between`](PhaseSpace::pole_between) of poles that divided differences do not notice either: 1/q has none across
    /// its pole, but 1/|q| has.
    #[inline(always)]
    fn hidden_pole_between(
        &self,
        _t: [R; 2],
        _q: [&Self::Array; 2],
        _p: [&Self::Array; 2],
        _s: [&(); 2],
    ) -> Option<&'static str> {
        None
    }

    /// This system under a method with steps as long as the tolerance of a step's error allows, from `state` on.
    ///
    /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
    fn adaptive<M: Method<Self, R>>(
        self,
        method: M,
        tolerance: f64,
        state: crate::state::State<Self::Coordinates>,
    ) -> Adaptive<Self, M, R> {
        Adaptive::new(self, method, tolerance, state)
    }
}

/// Nothing damps the system: H changes with explicit time alone.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep its energy",
    label = "this method keeps the energy, and must not be used where damping takes it away",
    note = "methods for damped systems: `DiscreteGradient`, `ImplicitMidpoint`, `Gauss`"
)]
pub trait Conservative<R: Real = f64>: Hamiltonian<R> {}

/// The flow keeps H: time does not appear in it, and nothing damps.
#[diagnostic::on_unimplemented(
    message = "the flow of `{Self}` was not proven to keep the energy",
    label = "H depends on time, or is damped: there is nothing to project onto"
)]
pub trait Autonomous<R: Real = f64>: Conservative<R> {}

/// H = T(p, t) + V(q, t): each part has an exact flow. In contact systems T + g·s is one part, with quadratic T.
#[diagnostic::on_unimplemented(
    message = "kick and drift do not exist for `{Self}`",
    label = "H was not proven to be T(p) + V(q)",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait Separable<R: Real = f64>: PhaseSpace<R> {
    /// What a kick of given length needs from the parameters.
    type Kick: Copy;
    /// What a drift of given length needs from the parameters.
    type Drift: Copy;
    /// Whether a drift from t on is exact in its own time, or takes place at the frozen time t of the kicks.
    const DRIFTS_ARE_EXACT_IN_TIME: bool = false;

    /// Coefficients of a kick of length `h`.
    fn prepare_kick(&self, h: R) -> Self::Kick;
    /// Coefficients of a drift of length `h`.
    fn prepare_drift(&self, h: R) -> Self::Drift;
    /// The flow of V at frozen time: p ← p − h ∂V/∂q, s ← s − hV.
    fn kick(kick: &Self::Kick, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);
    /// The flow of T: q ← q + h ∂T/∂p; of T + g·s: p ← e^(−gh)·p, …
    fn drift(drift: &Self::Drift, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);
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

/// T is a quadratic polynomial in p: \[V, \[T, V\]\] is a function of q alone, and has an exact flow together with V.
///
/// With the force F = −∂V/∂q and the mass matrix M that function is F·M⁻¹F.
#[diagnostic::on_unimplemented(
    message = "the kinetic energy of `{Self}` is not quadratic in `p` with a constant mass matrix",
    label = "on such a T force gradients are no kicks",
    note = "tables for every separable energy: `StormerVerlet`, `BlanesMoan4`, `BlanesMoan6`, `Yoshida4.of(StormerVerlet)` …"
)]
pub trait ForceGradient<R: Real = f64>: QuadraticKinetic<R> {
    /// What a kick of given weights needs from the parameters.
    type GradientKick: Copy;

    /// Coefficients of a kick with `h` of the force and `g` of its gradient, both with their powers of the step size.
    fn prepare_gradient_kick(&self, h: R, g: R) -> Self::GradientKick;
    /// The flow of U = hV − g F·M⁻¹F at frozen time: p ← p + hF + g ∇(F·M⁻¹F), s ← s − U.
    fn gradient_kick(kick: &Self::GradientKick, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);
}

/// H is a polynomial of degree 3 at most in (q, p).
#[diagnostic::on_unimplemented(
    message = "the energy of `{Self}` was not proven to be a polynomial of degree 3 at most",
    label = "Kahan's method needs such an energy",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait Cubic<R: Real = f64>: Collocation<R> {}

/// The differential equation in the form in which implicit methods solve it: y' = f(y, t) for y = (q, p); or, if T is
/// quadratic, q'' = M⁻¹f(q, t) with the force f = −∂V/∂q.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`",
    label = "this method is for those",
    note = "methods for every contact Hamiltonian: `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait Collocation<R: Real = f64>: Hamiltonian<R> {
    /// y: an array of (q, p), or q alone. f has the same shape.
    type Unknown: Array<Real = R>;
    /// What depends on parameters only.
    type Constants: Copy + core::fmt::Debug;
    /// The order of the differential equation, 1 or 2.
    const DERIVATIVE: usize;

    /// What depends on parameters only.
    fn constants(&self) -> Self::Constants;
    /// y, and what f changes: y, or p.
    fn start(q: &Self::Array, p: &Self::Array) -> (Self::Unknown, Self::Unknown);
    /// What y' is apart from f: nothing, or q' = ∂T/∂p.
    fn velocity(constants: &Self::Constants, p: &Self::Unknown) -> Self::Unknown;
    /// f and ∂f/∂y.
    fn field(
        constants: &Self::Constants,
        t: R,
        y: &Self::Unknown,
        f: &mut Self::Unknown,
        jacobian: &mut Square<Self::Unknown>,
    );
    /// y ← y + w·f, or y + w·M⁻¹f.
    fn add(constants: &Self::Constants, w: R, f: &Self::Unknown, y: &mut Self::Unknown);
    /// The increments of (q, p): that of y; or that of q = y, and the impulse.
    fn increments(change: &Self::Unknown, impulse: &Self::Unknown) -> [Self::Array; 2];
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

/// The field with the tree discrete gradient ∇̄H between y and y + d in place of ∇H: f̄ = J∇̄H; or −∇̄V, if T is quadratic.
/// With damping f̄ = (J − R)∇̄H, R at the mean of the two points.
///
/// The mean gradient of a quadratic T is that of the mean momentum, so that it needs no kernel of its own.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`",
    label = "this method is for those",
    note = "methods for every contact Hamiltonian: `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait DiscreteField<R: Real = f64>: Collocation<R> {
    /// What depends on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// What depends on y and t.
    type Start: Copy + core::fmt::Debug;
    /// Whether H is a polynomial of degree 2 that does not depend on time, and damping is constant: f̄ is affine in d.
    const LINEAR: bool;
    /// How the mean of ∇H along the line from y to y + d is had.
    const MEAN: Mean = Mean::NotClosed;

    /// What depends on parameters and h only. f̄ does not depend on h.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// What all evaluations from `y` have in common.
    fn begin(parameters: &Self::Parameters, t: R, y: &Self::Unknown) -> Self::Start;
    /// f̄ and ∂f̄/∂d.
    fn slope(
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
        (constants, h): (&Self::Constants, R),
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        image: &mut Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    ) {
        Self::slope(parameters, start, d, image, matrix);
        for f in image.as_mut_slice() {
            *f = h * *f;
        }
        let w = if Self::DERIVATIVE == 1 { h } else { R::from_f64(0.5) * h * h };
        for (i, row) in Self::Unknown::entries::<Self::Unknown>(matrix).iter_mut().enumerate() {
            let slope = core::mem::replace(row, Self::Unknown::nothing());
            Self::add(constants, -w, &slope, row);
            row.as_mut_slice()[i] += R::from_f64(1.0);
        }
    }
    /// h ∂T/∂p, if T is quadratic.
    fn drift(parameters: &Self::Parameters, p: &Self::Unknown) -> Self::Unknown;
}
