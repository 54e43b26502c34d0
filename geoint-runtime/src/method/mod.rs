//! The methods, a module for each family, and the trait that all of them implement.
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
pub mod gauss;
pub mod implicit;
pub mod kahan;
mod name;
mod open;
pub mod perturbed;
pub mod pieces;
mod probe;
pub mod splitting;
pub mod tables;

pub use catalogue::Visitor;
pub use clock::Clock;
pub use explicit::tableau;
pub use name::Name;
pub use open::Open;
pub use probe::{Probe, Unwatched};
pub(crate) use probe::{check_conditions, check_end, check_poles, check_way, start};
pub use splitting::{gradient_kick, modified_verlet};

pub use crate::solving::{Effort, Observer, Refusal};

use crate::scalar::Real;
use crate::space::vector::difference;
use crate::space::{Array, PerCoordinate, Plain, Point, Record, Summation};
use crate::system::PhaseSpace;

/// What a method promises where nothing is damped; the tests run over the list of all methods and hold each to it.
///
/// Damping leaves order and symmetry as they are. The step is then no symplectic map, and the energy falls.
#[doc(alias = "order of accuracy")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Claims {
    /// Global error O(hᵖ).
    pub order: u32,
    /// Φ(−h) ∘ Φ(h) is the identity.
    pub symmetric: bool,
    /// The step is a symplectic map; of a contact system a contact map, which multiplies the form ds − p dq by a positive factor.
    pub symplectic: bool,
    /// The step keeps H of an autonomous system to rounding; of a contact system it keeps the law of its decay, as that of
    /// [`ContactDiscreteGradient`](crate::ContactDiscreteGradient), H₁ = H₀ exp(−h g_s).
    pub conserves_energy: bool,
    /// Where H = A + εB, the part A solved exactly: the global error is O(ε hˢ¹ + ε² hˢ² + …) for these s. Only of tables made for that.
    pub perturbed: &'static [u32],
    /// Evaluations of the force, or of both derivatives of H, that a step costs where others follow, if it costs the same
    /// everywhere: not known of steps that solve an equation.
    pub forces: Option<u32>,
}

impl Claims {
    /// Order p, and nothing else.
    pub const fn of_order(order: u32) -> Self {
        Claims { order, symmetric: false, symplectic: false, conserves_energy: false, perturbed: &[], forces: None }
    }

    /// A symmetric method.
    pub const fn symmetric(mut self) -> Self {
        self.symmetric = true;
        self
    }

    /// A symplectic method, or a contact map.
    pub const fn symplectic(mut self) -> Self {
        self.symplectic = true;
        self
    }

    /// A method that keeps the energy.
    pub const fn conserving_energy(mut self) -> Self {
        self.conserves_energy = true;
        self
    }

    /// A method of so many forces a step.
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
    /// What was proven of `S` and is needed: a property's own `Proof`, two of them by [`And`]. Where something is missing the compiler
    /// knows no type here, nor that of [`IntoIntegrator::integrator`](crate::IntoIntegrator::integrator); the message that says what is missing is then
    /// the only one.
    type Proof;
    /// Everything that depends on the method, the parameters and h. It stays as it is while steps are taken.
    type Prepared: Clone;
    /// What steps hand on to the next one: increments from which implicit methods extrapolate their initial guess, and
    /// compensations of sums. `()` for most explicit methods. Saved runs record it. After a refused step it begins anew: no run may rely on
    /// it for more than digits.
    type Memory: Clone + Record<R>;
    /// Whether steps may be longer or shorter than h, by what they add to `x.ahead`.
    const SCALES_STEPS: bool = false;
    /// The highest order that compositions of this method have, whatever their table is.
    const COMPOSES_TO: u32 = u32::MAX;
    /// Whether steps lead to momenta that are off by the rounding of positions over h: states within a step are then looked for from that of
    /// its ends which is farther.
    const ROUGH_IF_SHORT: bool = false;

    /// Whether a single step takes less work by [`step`](Self::step) than by [`advance`](Self::advance).
    const SINGLY: bool = false;

    /// What the method promises.
    fn claims(&self) -> Claims;

    /// What it is called.
    fn name(&self) -> Name;

    /// True if the method moves another point than that of states: a point in other coordinates, or a point that a processor has mapped.
    const INNER: bool = false;

    /// From the point of a state at time `t` to the one that the method moves.
    #[inline(always)]
    fn enter(_prepared: &Self::Prepared, _system: &S, _t: R, _z: &mut S::Phase) {}

    /// And back.
    #[inline(always)]
    fn leave(_prepared: &Self::Prepared, _system: &S, _t: R, _z: &mut S::Phase) {}

    /// Coefficients for steps of length `h`.
    fn prepare(&self, system: &S, h: R) -> Self::Prepared;

    /// The memory before the first step.
    fn memory() -> Self::Memory;

    /// Whether steps keep invariants to rounding: [`way_back`](Self::way_back) then leads back to where they were.
    const KEEPS: bool = false;

    /// Returns the correction of `z` that restores the kept invariants to their values at the `origin` of a run. Steps keep invariants up to rounding, which walks
    /// at random, or drifts. After each 1024 steps a run adds this correction.
    #[inline]
    fn way_back(_prepared: &Self::Prepared, _system: &S, _origin: &S::Phase, _z: &S::Phase) -> S::Phase {
        S::Phase::zero()
    }

    /// Returns whether the invariants that steps compare are numbers with all their digits at the start of a run.
    ///
    /// Called once, before the first step. The default is right for methods that compare none.
    #[inline]
    fn is_in_range(_prepared: &Self::Prepared, _system: &S, _z: &S::Phase) -> bool {
        true
    }

    /// Whether a step does not end in a finite state where the energy is not defined.
    #[inline(always)]
    fn shows(_prepared: &Self::Prepared) -> bool {
        false
    }

    /// One step, in place. Every point at which the energy is evaluated is shown to `step.probe`.
    ///
    /// # Errors
    /// Where the step has no result; point and memory are then worth nothing.
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal>;

    /// The order of the error that [`estimated`](Self::estimated) finds in a step: of methods that have estimates of their own, and of no others.
    fn order_of_estimate(&self) -> Option<u32> {
        None
    }

    /// One step with two estimates of its error, for steps that adapt; nothing, and no step, where the method has none of its own. The error is
    /// e₅²/(e₅² + e₃²/100)½, e₅ and e₃ the largest entries of both in units of what is tolerated; with e₃ = 0 it is e₅.
    #[inline(always)]
    fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        _prepared: &Self::Prepared,
        _memory: &mut Self::Memory,
        _step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Refusal>> {
        None
    }

    /// `steps` steps, of which the `i`-th starts at `clock.at(i)` and ends at `clock.at(i + 1)`.
    ///
    /// # Errors
    /// Where one of them has no result; point and memory are then worth nothing.
    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Refusal> {
        for i in 0..steps {
            let [t, end] = clock.ends(i, x.ahead.value());
            Self::step(prepared, memory, Step { system, t, end, x, probe: &mut Unwatched })?;
        }
        Ok(())
    }
}

/// Two estimates of the error of a step, the one of the higher order first.
pub type Estimate<S, R> = [PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>; 2];

/// A step from the point of a state to that of another one, for callers that look at every step.
#[inline(always)]
pub(crate) fn outer_step<S: PhaseSpace<R>, R: Real, M: Method<S, R>, C: Summation<S::Phase>, P: Probe<S, R>>(
    prepared: &M::Prepared,
    memory: &mut M::Memory,
    Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
) -> Result<(), Refusal> {
    if !M::INNER {
        return M::step(prepared, memory, Step { system, t, end, x, probe });
    }
    // Rounding errors so far are those of other coordinates.
    let mut inner: Point<S::Phase, Plain, S::Action> = Point::with_action(x.z, x.s);
    M::enter(prepared, system, t, &mut inner.z);
    M::step(prepared, memory, Step { system, t, end, x: &mut inner, probe })?;
    M::leave(prepared, system, end, &mut inner.z);
    x.add(&difference(&inner.z, &x.z));
    x.s = inner.s;
    x.needs_recheck |= inner.needs_recheck;
    Ok(())
}

/// Both of two proofs: known where both are.
pub trait And<Q> {
    /// As well as the other one.
    type Both;
}

impl<P, Q> And<Q> for P {
    type Both = Q;
}

/// A step that is about to be taken: of which system, when, from where, and who watches.
#[derive(Debug)]
pub struct Step<'a, S: PhaseSpace<R>, R: Real, C, P> {
    /// The system with its parameters.
    pub system: &'a S,
    /// The time at which the step starts.
    pub t: R,
    /// The time at which it ends, which is when the next one starts: t + h, but for rounding.
    pub end: R,
    /// The point that is moved.
    pub x: &'a mut Point<S::Phase, C, S::Action>,
    /// Is shown every point at which the energy is evaluated.
    pub probe: &'a mut P,
}

impl<'a, S: PhaseSpace<R>, R: Real, C, P> Step<'a, S, R, C, P> {
    /// A moment of a step.
    #[inline(always)]
    pub fn at(t: R, (system, x, probe): (&'a S, &'a mut Point<S::Phase, C, S::Action>, &'a mut P)) -> Self {
        Step { system, t, end: t, x, probe }
    }

    /// This step, or a part of it between two times.
    #[inline(always)]
    pub fn part(&mut self, [t, end]: [R; 2]) -> Step<'_, S, R, C, P> {
        Step { system: self.system, t, end, x: self.x, probe: self.probe }
    }
}
