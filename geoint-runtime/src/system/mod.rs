//! What a system offers: the traits that the attributes implement.
//!
//! Each trait is a proven property. A method asks for the traits that it needs, so using it on a system without the
//! property is a type error. Kernels are functions of prepared coefficients and of nested arrays; they hold no state.

mod bodies;
mod contact;
mod implicit;
mod integrals;
mod jets;
mod jumps;
mod lagrangian;
mod modified;
mod perturbed;
mod poles;
mod rates;
mod separable;
mod timed;

pub use bodies::PrincipalAxes;
pub use contact::{Clock, Conformal, Contact, ImplicitStep, Mechanical, NystromPieces, Piece, Pieces};
pub use implicit::{
    ByCanonical, ByConstraint, ByField, ByPolarisation, ByTree, ByVelocities, CanonicalForm, Collocated, Collocation,
    Constrained, ConstrainedStep, ContactCollocated, ContactGraded, ContactPolarised, ContactStage, ContactStages,
    ContactVelocities, DiscreteField, FourthOrderField, Graded, Gradients, MassForm, Mean, PolarisedForm,
    QuadraticField, Span, Unmet, VelocityForm, contact_gradient_of, energy_of, rate_of, unmet, velocity_of,
};
pub(crate) use implicit::{
    KeptBy, Regular, acceleration, held, on_one_side, projected, row_scale, tangent, velocity_near,
};
pub use integrals::{FirstIntegrals, Invariants, KeepsEnergy, KeptMomenta, SteadyIntegrals};
pub use jets::Jets;
pub(crate) use jumps::{jump_between, jump_on_way};
pub use lagrangian::{Lagrangian, from_positions};
pub use modified::ModifiedEnergy;
pub use perturbed::{Perturbed, PerturbedGradient, unsuitable};
pub use poles::Pole;
pub(crate) use poles::{Ends, Known, Poles, compiled};
pub use rates::Rates;
pub use separable::{FlowPart, ForceGradient, QuadraticKinetic, Separable};
pub(crate) use timed::Clear;

pub use crate::solving::{Inverse, Inverted};

use crate::scalar::Real;
use crate::space::{Action, Array, Coordinates, Snapshot, State};

/// A phase space with an energy on it.
pub trait PhaseSpace<R: Real = f64>: Copy {
    /// A point at a time, as the user writes it.
    type State: Snapshot<Real = R, Phase = Self::Phase, Action = Self::Action>;
    /// All coordinates of a point, as kernels see them: z = [q, p], or x.
    type Phase: Array<Real = R>;
    /// What phase space has beside them: the action `R` of a contact system, or nothing.
    type Action: Action<R>;

    /// H at a point.
    fn hamiltonian(&self, t: R, z: &Self::Phase, s: &Self::Action) -> R;

    /// The first function of H, if any, that is not defined at a point, and of which term.
    fn outside_domain(&self, t: R, z: &Self::Phase, s: &Self::Action) -> Option<&'static str>;

    /// The first term of H, if any, that has a value at a point, and no derivative, as √u at u = 0. It is asked for when a step is refused.
    fn edge(&self, _t: R, _z: &Self::Phase, _s: &Self::Action) -> Option<&'static str> {
        None
    }

    /// Whether H has powers that have no Taylor series where they vanish.
    const POWERS: bool = false;

    /// Shows every power of H that has no Taylor series where it vanishes, with what it is a power of at a point. They are asked for when a series
    /// ends.
    fn powers(&self, _t: R, _z: &Self::Phase, _s: &Self::Action, _visit: impl FnMut(&'static str, R)) {}

    /// Whether momenta follow from velocities that the user gives: they are not finite where those have none.
    const OF_VELOCITIES: bool = false;

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
    fn clear_of_poles(&self, _divided: bool, _t: [R; 2], _z: [&Self::Phase; 2], _s: [&Self::Action; 2]) -> bool {
        true
    }

    /// What vanishes at a pole, in any scalar: parameters are lifted to it, coordinates come in the order in which they are stored.
    fn vanishing<T: Real>(&self, _pole: usize, _lift: impl Fn(R) -> T, _t: T, _z: &[T], _s: T) -> T {
        T::from_f64(1.0)
    }

    /// What is said of a jump of H at a condition that reads the state.
    const JUMPS: &'static [&'static str] = &[];

    /// Whether H was proven not to jump where a condition changes.
    const CONTINUOUS: bool = true;

    /// Whether no condition of H is decided differently at two points.
    #[inline(always)]
    fn same_sides(&self, _t: R, _z: [&Self::Phase; 2], _s: [&Self::Action; 2]) -> bool {
        true
    }

    /// The unit quaternions among the coordinates: their length is 1 at the start of a run, and is made so again once in 1024 steps.
    #[inline(always)]
    fn attitudes(_z: &mut Self::Phase) -> &mut [[R; 4]] {
        &mut []
    }

    /// 1 where a condition of H holds and −1 where it does not, and what H jumps by there, in any scalar.
    fn jump<T: Real>(&self, _jump: usize, _lift: impl Fn(R) -> T, _t: T, _z: &[T], _s: T) -> [T; 2] {
        [T::from_f64(1.0); 2]
    }

    /// Whether the end of every single step has to be examined by [`outside_domain`](PhaseSpace::outside_domain): a step may end outside
    /// the domain without a trace in the next.
    const EXAMINED: bool = false;

    /// What the state of a system with constraints lacks at the start of a run of steps of length `h`.
    #[inline(always)]
    fn unmet(&self, _t: R, _h: R, _z: &Self::Phase) -> Option<Unmet> {
        None
    }

    /// The energy of a state.
    fn energy(&self, state: &StateOf<Self, R>) -> R {
        let (t, z, s) = state.parts();
        self.hamiltonian(t, &z, &s)
    }
}

/// Points of the phase space of a system: [`State`], [`ContactState`](crate::ContactState),
/// [`FlowState`](crate::FlowState), or [`BodyState`](crate::BodyState).
pub type StateOf<S, R> = <S as PhaseSpace<R>>::State;

/// A phase space with a momentum beside each position: z = [q, p].
pub trait Cotangent<R: Real = f64>: PhaseSpace<R, Phase = [<Self as Cotangent<R>>::Array; 2]> {
    /// Positions, or momenta, as the user writes them.
    type Coordinates: Coordinates<Real = R, Array = Self::Array>;
    /// The same as kernels see them.
    type Array: Array<Real = R>;
}

/// A differential equation z' = f(z, t).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]` or `#[vector_field]` without constraints",
    label = "this is for those alone",
    note = "contact systems have `integrator`, with the methods `ContactSplitting`, `Suzuki4.of(ContactSplitting)`, `ContactMidpoint`, \
            `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`"
)]
pub trait VectorField<R: Real = f64>: PhaseSpace<R, Action = ()> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// z' at a point.
    fn rate(&self, t: R, z: &Self::Phase, dz: &mut Self::Phase);
}

/// A system with an energy H(q, p, t): q' = ∂H/∂p, p' = −∂H/∂q, less C ∂H/∂p if it is damped.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]` without constraints",
    label = "this is for those alone",
    note = "contact systems have `integrator`, with the methods `ContactSplitting`, `Suzuki4.of(ContactSplitting)`, `ContactMidpoint`, \
            `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`"
)]
pub trait Hamiltonian<R: Real = f64>:
    VectorField<R> + Cotangent<R> + PhaseSpace<R, State = State<<Self as Cotangent<R>>::Coordinates>>
{
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// [∂H/∂q, ∂H/∂p] at a point.
    fn gradient(&self, t: R, z: &Self::Phase, slopes: &mut Self::Phase);
}

/// z' of a system that is not damped, from the gradient: J∇H.
#[inline(always)]
pub fn canonical_rate<S: Hamiltonian<R>, R: Real>(system: &S, t: R, z: &S::Phase, dz: &mut S::Phase) {
    system.gradient(t, z, dz);
    let [q, p] = dz;
    for (q, p) in q.as_mut_slice().iter_mut().zip(p.as_mut_slice()) {
        (*q, *p) = (*p, -*q);
    }
}

/// Nothing damps the system: H changes with explicit time alone.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep its energy",
    label = "this method keeps the energy, and must not be used where damping takes it away",
    note = "methods for damped systems: `DiscreteGradient`, `ImplicitMidpoint`, `Gauss`"
)]
pub trait Conservative<R: Real = f64>: Hamiltonian<R> + FourthOrderField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// The flow keeps H: time does not appear in it, and nothing damps.
#[diagnostic::on_unimplemented(
    message = "the flow of `{Self}` was not proven to keep the energy",
    label = "H depends on time, or is damped: there is nothing to project onto"
)]
pub trait Autonomous<R: Real = f64>: Conservative<R> + KeepsEnergy<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}
