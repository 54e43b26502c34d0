//! The traits of systems, which the attribute macros implement.
//!
//! The attribute macros are `#[hamiltonian]`, `#[lagrangian]` and `#[vector_field]`. [`PhaseSpace`] describes the system. A macro
//! implements each further trait only after it has proven the property that the trait stands for. A method requires the traits that it
//! needs, so a method on a system without the property is a type error.
//!
//! A kernel is a function that a macro emits for a trait, such as [`VectorField::rate`] or [`Hamiltonian::gradient`]. Kernels read
//! nested arrays of coordinates. They hold no state. If many steps share values, one kernel computes them as coefficients, and others
//! take the coefficients as an argument.
//!
//! Most traits have a type `Proof`, which is `()` in each implementation. [`Method::Proof`](crate::Method::Proof) of a method names the
//! `Proof` of each trait that the method needs. If an implementation is missing, rustc reports the missing property only, without errors
//! that follow from it.

mod bodies; // Rigid bodies in their principal axes.
pub(crate) mod contact; // Contact systems.
pub(crate) mod implicit; // The equations of implicit steps.
pub(crate) mod integrals; // First integrals and invariants.
pub(crate) mod jets; // Taylor coefficients of solutions.
mod jumps; // Search for a jump of H between two points.
mod lagrangian; // Systems that are given by a Lagrangian.
pub(crate) mod modified; // The modified energy of a step of order 2.
mod perturbed; // H = A + B: an exact flow and a perturbation.
pub(crate) mod pieces; // Sums of pieces with known flows.
mod poles; // Search for a pole of H between two points.
mod rates; // The rates of systems with and without an action.
mod segment; // Whether a function vanishes on a line, by interval arithmetic.
mod semidefinite; // Check that a damping matrix never adds energy.
mod flow_kind;
mod separable; // H = T + V: kicks and drifts.
mod timed; // Search for a pole of H that depends on time only.

pub use bodies::PrincipalAxes;
pub(crate) use contact::ContactEquation;
pub use contact::{Conformal, Contact, Mechanical};
pub use flow_kind::{Change, FlowKind, FlowPart, TimeDependence};
pub(crate) use implicit::{
    At, KeptBy, Regular, held, mass_units, on_one_side, projected, rates_of_velocity, row_scale, row_units, tangent,
    velocity_near,
};
pub(crate) use implicit::{
    CanonicalForm, Collocation, ConstrainedStep, ContactStages, DiscreteField, FourthOrderField, Keeping, MassForm,
    Mean, PolarisedForm, QuadraticField, Span, VelocityForm, VelocityStage, energy_of, velocity_of,
};
pub use implicit::{Constrained, Gradients, Unmet};
pub(crate) use integrals::KeptMomenta;
pub use integrals::{FirstIntegrals, Invariants, KeepsEnergy, Origin, SteadyIntegrals};
pub(crate) use jets::Jets;
pub(crate) use jumps::{jump_between, jump_of_integral, jump_on_way};
pub use lagrangian::{Lagrangian, constrained_lagrangian_of, from_positions, lagrangian_of};
pub use perturbed::{Perturbed, PerturbedGradient, unsuitable};
pub(crate) use pieces::NystromPieces;
pub use pieces::{Clock, Piece, Pieces};
pub use poles::Pole;
pub(crate) use poles::{Ends, Evaluations, Known, Poles, compiled};
pub use rates::Rates;
pub use semidefinite::is_positive_semidefinite;
pub use separable::{ForceGradient, QuadraticKinetic, Separable};
pub(crate) use timed::Clear;

use crate::scalar::Real;
use crate::space::{Action, Array, Coordinates, Snapshot, State};

/// A phase space with an energy H on it.
///
/// Some systems of `#[vector_field]` keep functions in place of H. The items about domain, poles and conditions then speak of the field
/// and of these functions.
///
/// The defaults describe an H that is smooth and defined everywhere. The macros override an item only if H needs it.
pub trait PhaseSpace<R: Real = f64>: Copy {
    /// A point and its time, in the types of the user.
    type State: Snapshot<Real = R, Phase = Self::Phase, Action = Self::Action>;
    /// The coordinates of a point, as kernels read them: z = [q, p], or z = x for a system without momenta.
    type Phase: Array<Real = R>;
    /// The scalar `R` for the action s of a contact system. `()` for all other systems.
    type Action: Action<R>;

    /// Returns H at a point. NaN if the system has no energy.
    fn hamiltonian(&self, t: R, z: &Self::Phase, s: &Self::Action) -> R;

    /// Returns a message about the first function in H that is undefined at a point. The message names the function and its argument.
    ///
    /// The message may also describe damping or friction that would feed energy. Integrators check the first state of a run and the ends of
    /// steps, and report the message as the reason of a refused step.
    fn outside_domain(&self, t: R, z: &Self::Phase, s: &Self::Action) -> Option<&'static str>;

    /// Returns the name of the first parameter that is not a number.
    ///
    /// Called before the first step, and after the system of a run was replaced. The default fits a system without parameters.
    fn invalid_parameter(&self) -> Option<&'static str> {
        None
    }

    /// Returns a message about the first term of H that has a value at a point, but not all derivatives of order 1 and 2. An example is
    /// √u at u = 0.
    ///
    /// Called after a refused step. The integrator repeats the step to find the cause, and calls this function at each point where the step evaluates H.
    /// The default is right if H has no such term.
    fn edge(&self, _t: R, _z: &Self::Phase, _s: &Self::Action) -> Option<&'static str> {
        None
    }

    /// `true` if [`powers`](PhaseSpace::powers) visits anything. H then has a power without a Taylor series where its base vanishes, as u^(3/2).
    ///
    /// The integrator for Taylor series reads this constant. A series can not represent such a power near the zero of its base. If the constant is
    /// `true`, the integrator therefore compares series and field also for steps of fixed length.
    const POWERS: bool = false;

    /// Calls `visit` for each power of H that has no Taylor series where its base vanishes. The arguments are a message and the value of
    /// the base at a point.
    ///
    /// Called if a Taylor series diverges, to find a base near zero. The default is right if [`POWERS`](PhaseSpace::POWERS) is `false`.
    fn powers(&self, _t: R, _z: &Self::Phase, _s: &Self::Action, _visit: impl FnMut(&'static str, R)) {}

    /// `true` if the system is given by a Lagrangian. The user then starts from velocities, and the momenta p = ∂L/∂v follow.
    ///
    /// Read if a state is not finite. With finite positions the error is then [`Failure::NoMomentum`](crate::Failure::NoMomentum): the
    /// velocity has no momentum.
    const OF_VELOCITIES: bool = false;

    /// `true` if v follows from ∂L/∂v = p by an iteration, because the macro found no formula for v(p).
    const SOLVED_FOR_VELOCITIES: bool = false;

    /// Returns a message if the mass matrix ∂²L/∂v² may be singular on the straight line between two points, each with its time.
    ///
    /// Called by explicit methods if [`SOLVED_FOR_VELOCITIES`](PhaseSpace::SOLVED_FOR_VELOCITIES) is `true`. Implicit methods follow the mass
    /// matrix themselves. The default is never called.
    fn singular_mass(&self, _t: [R; 2], _z: [&Self::Phase; 2], _s: [&Self::Action; 2]) -> Option<&'static str> {
        None
    }

    /// The poles of H, each with the message of a refused step.
    ///
    /// An implicit step is refused unless the denominator of each pole is proven not to vanish between the ends of the step. Explicit steps check
    /// only the poles whose denominators read nothing but time, and those at which a mass matrix is singular; see [`Pole::of_mass`]. An entry may
    /// also be the edge of a domain; see [`Pole::edge`].
    const POLES: &'static [Pole] = &[];

    /// Returns whether the parameters have the signs that [`clear_of_poles`](PhaseSpace::clear_of_poles) assumes.
    ///
    /// Called when the search for poles is prepared for a system. If the result is `false`, the search bounds the
    /// denominators by interval arithmetic instead of calling `clear_of_poles`. The default is right if the tests assume no sign.
    #[inline(always)]
    fn signs_hold(&self) -> bool {
        true
    }

    /// Returns `false` if a quick test can not exclude a pole on the straight line between two points, each with its time.
    ///
    /// The quick test covers the poles with [`Pole::by_structure`] only. An example is 1/q: the product of both values of q must be
    /// positive. `true` says nothing about other poles. Thus the default is right if no pole has a quick test.
    ///
    /// `divided` states that the divided differences of H between the two points are known to be finite. Some poles then need no test: the
    /// kernel for the divided difference of 1/q returns a number only if q has one sign.
    #[inline(always)]
    fn clear_of_poles(&self, _divided: bool, _t: [R; 2], _z: [&Self::Phase; 2], _s: [&Self::Action; 2]) -> bool {
        true
    }

    /// Returns the function that vanishes at the pole with this index of [`POLES`](PhaseSpace::POLES), such as q for 1/q. At the edge of a
    /// domain the function is positive inside and negative outside.
    ///
    /// The scalar `T` is an interval with a derivative during the search for zeros. `lift` converts parameters to `T`. The coordinates `z`
    /// come in the order in which they are stored. The default is never called, because `POLES` is empty.
    fn vanishing<T: Real>(&self, _pole: usize, _lift: impl Fn(R) -> T, _t: T, _z: &[T], _s: T) -> T {
        T::from_f64(1.0)
    }

    /// The conditions of H that read the state, such as the condition of an `if`. Each has the message for a step across a jump of H at this
    /// condition.
    const JUMPS: &'static [&'static str] = &[];

    /// `true` if H was proven to be continuous at each condition that reads the state.
    ///
    /// If this is `false`, methods that do not keep the energy search each step for a jump. Methods that keep the energy call
    /// [`same_sides`](PhaseSpace::same_sides) instead. The energy balance of their step includes the jump, so a comparison of both ends is enough.
    /// The default is right without conditions.
    const CONTINUOUS: bool = true;

    /// Returns whether each condition of [`JUMPS`](PhaseSpace::JUMPS) has the same value at two points. `t` is the time at which the step
    /// evaluates H.
    ///
    /// Called by methods that keep the energy. The default is right without conditions.
    #[inline(always)]
    fn same_sides(&self, _t: R, _z: [&Self::Phase; 2], _s: [&Self::Action; 2]) -> bool {
        true
    }

    /// Returns the unit quaternions among the coordinates.
    ///
    /// Integrators refuse a first state in which a quaternion has not the length 1. They remove the drift of the length at
    /// least once in 1024 steps. The default is right without rigid bodies.
    #[inline(always)]
    fn attitudes(_z: &mut Self::Phase) -> &mut [[R; 4]] {
        &mut []
    }

    /// Returns the side and the height of the condition with this index of [`JUMPS`](PhaseSpace::JUMPS). The side is 1 if the condition
    /// holds, else −1. The height is H with the condition true, minus H with the condition false.
    ///
    /// The scalar `T` is an interval during the search for jumps. `lift` converts parameters to `T`. The coordinates `z` come in the order
    /// in which they are stored. The default is never called, because `JUMPS` is empty.
    fn jump<T: Real>(&self, _jump: usize, _lift: impl Fn(R) -> T, _t: T, _z: &[T], _s: T) -> [T; 2] {
        [T::from_f64(1.0); 2]
    }

    /// `true` if [`angles`](PhaseSpace::angles) visits anything: H reads an angle `atan2(y, x)` of the state.
    ///
    /// Divided differences of H continue such an angle across its cut. If this is `true`, a projected step is
    /// refused if such an angle moves by more than half a turn in it.
    const ANGLES: bool = false;

    /// Calls `visit` for each angle `atan2(y, x)` that H reads, always in the same order. The arguments are the formula of the angle and
    /// the two arguments y and x of `atan2` at a point.
    ///
    /// The default is right if [`ANGLES`](PhaseSpace::ANGLES) is `false`.
    fn angles(&self, _t: R, _z: &Self::Phase, _s: &Self::Action, _visit: impl FnMut(&'static str, [R; 2])) {}

    /// `true` if integrators must check the end of each single step by [`outside_domain`](PhaseSpace::outside_domain).
    ///
    /// If this is `false`, one check after many steps is enough: a state outside the domain leads to numbers that are not finite. If this is
    /// `true`, a step may leave the domain and a later step may come back inside, and no number shows it. An example is √q·√q, which
    /// simplification has made q.
    const EXAMINED: bool = false;

    /// Returns the constraint that the state of a system with constraints violates, or that depends on other constraints.
    ///
    /// Called for the first state of a run. A velocity off the constraint counts as rounding below a bound that depends on
    /// the step length `h`. The default is right without constraints.
    #[inline(always)]
    fn unmet(&self, _t: R, _h: R, _z: &Self::Phase) -> Option<Unmet> {
        None
    }

    /// Returns the energy of a state.
    fn energy(&self, state: &StateOf<Self, R>) -> R {
        let (t, z, s) = state.parts();
        self.hamiltonian(t, &z, &s)
    }
}

/// The type of the states of a system: [`State`], [`ContactState`](crate::ContactState), [`FlowState`](crate::FlowState), or
/// [`BodyState`](crate::BodyState).
pub type StateOf<S, R> = <S as PhaseSpace<R>>::State;

/// A phase space with a momentum for each position: z = [q, p].
pub trait Cotangent<R: Real = f64>: PhaseSpace<R, Phase = [<Self as Cotangent<R>>::Array; 2]> {
    /// The type in which the user writes positions, and the type of momenta.
    type Coordinates: Coordinates<Real = R, Array = Self::Array>;
    /// Positions, or momenta, as kernels read them.
    type Array: Array<Real = R>;
}

/// A differential equation z' = f(z, t).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]` or `#[vector_field]`, or has a `constraint`, an `attitude` or an action `s`",
    label = "this method does not fit this kind of system",
    note = "contact systems have `integrator`, with the methods `ContactSplitting`, `Suzuki4.of(ContactSplitting)`, `ContactMidpoint`, \
            `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`"
)]
pub trait VectorField<R: Real = f64>: PhaseSpace<R, Action = ()> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Writes z' at a point to `dz`.
    fn rate(&self, t: R, z: &Self::Phase, dz: &mut Self::Phase);
}

/// A system with an energy H(q, p, t): q' = ∂H/∂p, p' = −∂H/∂q − C ∂H/∂p + f.
///
/// C is the damping matrix, and f are other forces. Both are zero unless the user gives them.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[hamiltonian]`, or has a `constraint`, an `attitude` or an action `s`",
    label = "this method does not fit this kind of system",
    note = "contact systems have `integrator`, with the methods `ContactSplitting`, `Suzuki4.of(ContactSplitting)`, `ContactMidpoint`, \
            `ContactDiscreteGradient`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`"
)]
pub trait Hamiltonian<R: Real = f64>:
    VectorField<R> + Cotangent<R> + PhaseSpace<R, State = State<<Self as Cotangent<R>>::Coordinates>>
{
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Writes [∂H/∂q, ∂H/∂p] at a point to `slopes`.
    fn gradient(&self, t: R, z: &Self::Phase, slopes: &mut Self::Phase);
}

/// Writes z' = J∇H of an undamped system to `dz`: q' = ∂H/∂p, p' = −∂H/∂q. The macros call it in [`VectorField::rate`].
#[inline(always)]
pub fn canonical_rate<S: Hamiltonian<R>, R: Real>(system: &S, t: R, z: &S::Phase, dz: &mut S::Phase) {
    system.gradient(t, z, dz);
    let [q, p] = dz;
    for (q, p) in q.as_mut_slice().iter_mut().zip(p.as_mut_slice()) {
        (*q, *p) = (*p, -*q);
    }
}

/// A system without damping and without forces besides −∂H/∂q. H changes along the flow only if H reads time.
///
/// Methods that keep the energy need this property. They keep H to rounding if H does not read time.
///
/// The macros implement `FourthOrderField` for each such system. The bound lets generic code use
/// [`FourthOrder(DiscreteGradient)`](crate::FourthOrder) for each conservative system.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to keep its energy",
    label = "this method keeps the energy, and must not be used where damping takes it away",
    note = "methods for damped systems: `DiscreteGradient`, `ImplicitMidpoint`, `Gauss`"
)]
pub trait Conservative<R: Real = f64>: Hamiltonian<R> + FourthOrderField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// A conservative system whose H does not read time. The flow keeps H. [`KeepsEnergy`] alone also holds for fields without momenta.
#[diagnostic::on_unimplemented(
    message = "the flow of `{Self}` was not proven to keep the energy",
    label = "H depends on time, or is damped: there is nothing to project onto"
)]
pub trait Autonomous<R: Real = f64>: Conservative<R> + KeepsEnergy<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}
