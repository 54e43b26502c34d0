//! What a system offers: the traits that the attributes implement.
//!
//! Each trait is a proven property. A method asks for the traits that it needs, so using it on a system without the
//! property is a type error. Kernels are functions of prepared coefficients and of nested arrays; they hold no state.

mod contact;
mod implicit;
mod modified;
mod separable;

pub use contact::{Clock, Conformal, Contact, ImplicitStep, Mechanical, Piece, Pieces};
pub use implicit::{Collocation, Cubic, DiscreteField, Mean};
pub use modified::ModifiedEnergy;
pub use separable::{ForceGradient, QuadraticKinetic, Separable};

pub use crate::solving::{Inverse, Inverted};

use crate::scalar::Real;
use crate::space::{Action, Array, Coordinates};

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
}

/// Points of the phase space of a system: [`State`](crate::State), or [`ContactState`](crate::ContactState).
pub type StateOf<S, R> = <<S as PhaseSpace<R>>::Action as Action<R>>::State<<S as PhaseSpace<R>>::Coordinates>;

/// A system with an energy H(q, p, t): q' = ∂H/∂p, p' = −∂H/∂q, less C ∂H/∂p if it is damped.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`",
    label = "this is for those alone",
    note = "contact systems have `integrator`, with the methods `ContactSplitting`, `Suzuki4.of(ContactSplitting)`, `ContactMidpoint`, \
            `ContactDiscreteGradient`"
)]
pub trait Hamiltonian<R: Real = f64>: PhaseSpace<R, Action = ()> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
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
}

/// Nothing damps the system: H changes with explicit time alone.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep its energy",
    label = "this method keeps the energy, and must not be used where damping takes it away",
    note = "methods for damped systems: `DiscreteGradient`, `ImplicitMidpoint`, `Gauss`"
)]
pub trait Conservative<R: Real = f64>: Hamiltonian<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// The flow keeps H: time does not appear in it, and nothing damps.
#[diagnostic::on_unimplemented(
    message = "the flow of `{Self}` was not proven to keep the energy",
    label = "H depends on time, or is damped: there is nothing to project onto"
)]
pub trait Autonomous<R: Real = f64>: Conservative<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}
