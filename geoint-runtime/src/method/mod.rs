//! The integration methods, with one module for each family, and the trait [`Method`] that all methods implement.
//!
//! A method is a value: pass it to [`integrator`](crate::IntoIntegrator::integrator). [Which method](crate::guide::_03_which_method) helps to choose.
//!
#![doc = include_str!("../../docs/methods.txt")]

pub mod catalogue;
mod clock;
pub mod composition;
pub mod constrained;
pub mod contact;
pub mod corrected;
pub mod discrete_gradient;
pub mod explicit;
pub mod flows;
pub mod gauss;
mod handling;
pub mod implicit;
pub mod kahan;
mod name;
mod probe;
pub(crate) mod proof;
mod stepped_as;
pub mod tables;

pub use catalogue::Visitor;
pub use clock::Clock;
pub use explicit::tableau;
pub use flows::{gradient_kick, modified_verlet};
pub use handling::Handling;
pub use name::Name;
pub use probe::{Probe, Unwatched};
pub(crate) use probe::{check_conditions, check_end, check_poles, check_way, start};
pub(in crate::method) use proof::And;
pub use stepped_as::SteppedAs;

pub use crate::solving::{Effort, Failure, Observer};

use crate::scalar::Real;
use crate::space::vector::difference;
use crate::space::{Array, PerCoordinate, Plain, Point, Record, Summation};
use crate::system::PhaseSpace;

/// The properties of a method for systems without damping. The tests check them for all methods.
///
/// Damping does not change order and symmetry. With damping the step is not symplectic, and the energy decreases.
#[doc(alias = "order of accuracy")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Claims {
    /// The order p: the global error is O(hᵖ).
    pub order: u32,
    /// Φ(−h) ∘ Φ(h) is the identity.
    pub symmetric: bool,
    /// The step is a symplectic map. For contact systems it is a contact map, which multiplies the form ds − p dq by a positive factor.
    pub symplectic: bool,
    /// The step keeps H of an autonomous system to rounding. For contact systems it keeps the law of decay of H, as
    /// [`ContactDiscreteGradient`](crate::ContactDiscreteGradient) does with H₁ = H₀ exp(−h g_s).
    pub conserves_energy: bool,
    /// The orders s₁, s₂, … of a table made for H = A + εB with an exact flow of A: the global error is O(ε hˢ¹ + ε² hˢ² + …). Empty for other methods.
    pub perturbed: &'static [u32],
    /// The number of evaluations of the force, or of both derivatives of H, that a step of a long run costs. `None` if the number varies, as for steps that
    /// solve an equation.
    pub forces: Option<u32>,
}

impl Claims {
    /// Returns the claim of the order p only.
    pub const fn of_order(order: u32) -> Self {
        Claims { order, symmetric: false, symplectic: false, conserves_energy: false, perturbed: &[], forces: None }
    }

    /// Adds the claim of symmetry.
    pub const fn symmetric(mut self) -> Self {
        self.symmetric = true;
        self
    }

    /// Adds the claim that the step is a symplectic map or a contact map.
    pub const fn symplectic(mut self) -> Self {
        self.symplectic = true;
        self
    }

    /// Adds the claim that the step keeps the energy.
    pub const fn conserving_energy(mut self) -> Self {
        self.conserves_energy = true;
        self
    }

    /// Adds the number of forces a step.
    pub const fn forces(mut self, forces: u32) -> Self {
        self.forces = Some(forces);
        self
    }
}

/// A one-step method for the system `S`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a method for `{S}`",
    note = "a composition becomes a method with the map that it composes: `Yoshida4.of(StormerVerlet)`",
    note = "`Gauss` has 1 to 6 stages"
)]
pub trait Method<S: PhaseSpace<R>, R: Real = f64>: Copy {
    /// The proof that `S` has the properties that the method needs. A tuple combines the proofs of two properties.
    ///
    /// If a property is missing, the compiler knows neither this type nor the type of the run; see [`Given`](crate::running::Given). It then reports the
    /// missing property only.
    type Proof;
    /// Coefficients that depend on the method, the parameters and h. They are constant while steps are taken.
    type Prepared: Clone;
    /// Values that a step passes to the next one, such as the increments from which implicit methods extrapolate an initial guess, and
    /// compensations of sums. `()` for most explicit methods. Saved runs record it. A refused step resets it, so results may depend on it by rounding only.
    type Memory: Clone + Record<R>;
    /// How a run handles the steps.
    const HANDLING: Handling = Handling::PLAIN;
    /// An upper bound of the order of compositions of this method, for every table.
    const COMPOSES_TO: u32 = u32::MAX;

    /// The claims of the method.
    fn claims(&self) -> Claims;

    /// The name of the method.
    fn name(&self) -> Name;

    /// Maps the point of a state at the time `t` to the inner point that the method moves, if [`HANDLING`](Self::HANDLING) says that it moves one.
    #[inline(always)]
    fn enter(_prepared: &Self::Prepared, _system: &S, _t: R, _z: &mut S::Phase) {}

    /// Maps the inner point to the point of the state, the inverse of [`enter`](Self::enter).
    #[inline(always)]
    fn leave(_prepared: &Self::Prepared, _system: &S, _t: R, _z: &mut S::Phase) {}

    /// Computes the coefficients for steps of length `h`.
    fn prepare(&self, system: &S, h: R) -> Self::Prepared;

    /// Returns the memory before the first step from the point `z`.
    fn memory(z: &S::Phase) -> Self::Memory;

    /// Returns the correction of `z` that restores the kept invariants to their values at the `origin` of a run.
    ///
    /// Steps keep invariants up to rounding errors, which accumulate as a random walk or as a drift. A run adds this correction after each 1024 steps.
    #[inline]
    fn way_back(_prepared: &Self::Prepared, _system: &S, _origin: &S::Phase, _z: &S::Phase) -> S::Phase {
        S::Phase::zero()
    }

    /// Returns whether the invariants that steps compare are finite and have full precision at the start of a run.
    ///
    /// Called once, before the first step. The default is correct for methods that compare no invariants.
    #[inline]
    fn is_in_range(_prepared: &Self::Prepared, _system: &S, _z: &S::Phase) -> bool {
        true
    }

    /// Returns whether every step that ends where the energy is not defined ends in a state that is not finite. The domain of the energy is then not checked.
    #[inline(always)]
    fn shows_domain(_prepared: &Self::Prepared) -> bool {
        false
    }

    /// Takes one step in place. Reports every point at which the energy is evaluated to `step.probe`.
    ///
    /// # Errors
    /// If the step has no result. The point and the memory are then invalid.
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure>;

    /// Returns the order of the error estimate of [`estimated`](Self::estimated), or `None` for methods without an estimate.
    fn order_of_estimate(&self) -> Option<u32> {
        None
    }

    /// Takes one step and returns two estimates of its error, for adaptive steps. Returns `None` and takes no step if the method has no estimate.
    ///
    /// The error is e₅²/√(e₅² + e₃²/100). Here e₅ and e₃ are the largest entries of both estimates in units of the tolerance. With e₃ = 0 the error is e₅.
    #[inline(always)]
    fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        _prepared: &Self::Prepared,
        _memory: &mut Self::Memory,
        _step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Failure>> {
        None
    }

    /// Takes `steps` steps. The `i`-th one starts at `clock.at(i)` and ends at `clock.at(i + 1)`.
    ///
    /// # Errors
    /// If a step has no result. The point and the memory are then invalid.
    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Failure> {
        for i in 0..steps {
            let [t, end] = clock.ends(i, x.ahead.value());
            Self::step(prepared, memory, Step { system, t, end, x, probe: &mut Unwatched })?;
        }
        Ok(())
    }
}

/// Two estimates of the error of a step, the estimate of the higher order first.
pub type Estimate<S, R> = [PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>; 2];

/// Takes one step from the point of a state to the point of the next state, for callers that need the state after every step.
#[inline(always)]
pub(crate) fn outer_step<S: PhaseSpace<R>, R: Real, M: Method<S, R>, C: Summation<S::Phase>, P: Probe<S, R>>(
    prepared: &M::Prepared,
    memory: &mut M::Memory,
    Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    if !M::HANDLING.moves_inner_point {
        return M::step(prepared, memory, Step { system, t, end, x, probe });
    }
    // The compensation of `x` belongs to the coordinates of states, so the inner point starts without compensation.
    let mut inner: Point<S::Phase, Plain, S::Action> = Point::with_action(x.z, x.s);
    M::enter(prepared, system, t, &mut inner.z);
    M::step(prepared, memory, Step { system, t, end, x: &mut inner, probe })?;
    M::leave(prepared, system, end, &mut inner.z);
    x.add(&difference(&inner.z, &x.z));
    x.s = inner.s;
    x.needs_recheck |= inner.needs_recheck;
    Ok(())
}

/// The input of a step: the system, the times, the point and the probe.
#[derive(Debug)]
pub struct Step<'a, S: PhaseSpace<R>, R: Real, C, P> {
    /// The system with its parameters.
    pub system: &'a S,
    /// The time at which the step starts.
    pub t: R,
    /// The time at which the step ends and the next step starts: t + h, except for rounding.
    pub end: R,
    /// The point that the step moves.
    pub x: &'a mut Point<S::Phase, C, S::Action>,
    /// Receives every point at which the energy is evaluated.
    pub probe: &'a mut P,
}

impl<'a, S: PhaseSpace<R>, R: Real, C, P> Step<'a, S, R, C, P> {
    /// Returns a step of zero length at the time `t`.
    #[inline(always)]
    pub fn at(t: R, (system, x, probe): (&'a S, &'a mut Point<S::Phase, C, S::Action>, &'a mut P)) -> Self {
        Step { system, t, end: t, x, probe }
    }

    /// Returns the part of this step between two times.
    #[inline(always)]
    pub fn part(&mut self, [t, end]: [R; 2]) -> Step<'_, S, R, C, P> {
        Step { system: self.system, t, end, x: self.x, probe: self.probe }
    }
}
