//! What a system offers: the traits that the attributes implement.
//!
//! Each trait is a proven property. A method asks for the traits that it needs, so using it on a system without the
//! property is a type error. Kernels are functions of prepared coefficients and of nested arrays; they hold no state.

mod contact;
mod implicit;
mod modified;
mod poles;
mod separable;
mod vector_field;

pub use contact::{Clock, Conformal, Contact, ImplicitStep, Mechanical, Piece, Pieces};
pub use implicit::{Collocation, Cubic, DiscreteField, Mean};
pub use modified::ModifiedEnergy;
pub use poles::Pole;
mod jumps;
pub(crate) use jumps::jump_between;
pub(crate) use poles::{Known, Poles, singular_time};
pub use separable::{ForceGradient, QuadraticKinetic, Separable};
pub use vector_field::VectorField;

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

    /// The poles of H: what must not vanish on the way of an implicit step.
    const POLES: &'static [Pole] = &[];

    /// Whether the parameters have the signs on which [`clear_of_poles`](PhaseSpace::clear_of_poles) relies.
    #[inline(always)]
    fn signs_hold(&self) -> bool {
        true
    }

    /// Whether the structure of what vanishes at the poles alone rules out, at little cost, that it does so between two points, each with
    /// its time. `true` says nothing of poles of which no such structure is known.
    ///
    /// Where `divided` is `true`, the divided differences of H between the two points are known to be numbers: they are not, where
    /// 1/x has ends of different signs.
    #[inline(always)]
    fn clear_of_poles(
        &self,
        _divided: bool,
        _t: [R; 2],
        _q: [&Self::Array; 2],
        _p: [&Self::Array; 2],
        _s: [&Self::Action; 2],
    ) -> bool {
        true
    }

    /// What vanishes at a pole, in any scalar: parameters are lifted to it, positions and momenta come in the order in which they are
    /// stored.
    fn vanishing<T: Real>(&self, _pole: usize, _lift: impl Fn(R) -> T, _t: T, _q: &[T], _p: &[T], _s: T) -> T {
        T::from_f64(1.0)
    }

    /// What is said of a jump of H at a condition that reads the state.
    const JUMPS: &'static [&'static str] = &[];

    /// Whether no condition of H is decided differently at two points.
    #[inline(always)]
    fn same_sides(&self, _t: R, _q: [&Self::Array; 2], _p: [&Self::Array; 2], _s: [&Self::Action; 2]) -> bool {
        true
    }

    /// 1 where a condition of H holds and −1 where it does not, and what H jumps by there, in any scalar.
    fn jump<T: Real>(&self, _jump: usize, _lift: impl Fn(R) -> T, _t: T, _q: &[T], _p: &[T], _s: T) -> [T; 2] {
        [T::from_f64(1.0); 2]
    }

    /// Whether the end of every single step has to be examined by [`outside_domain`](PhaseSpace::outside_domain): a step may end outside
    /// the domain without a trace in the next.
    const EXAMINED: bool = false;

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
