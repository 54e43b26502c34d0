//! Relaxation: x₁ = x₀ + γ(y − x₀), where y is the result of a step of any method. The factor γ solves H(x₁) = H(x₀).

use crate::method::corrected::invariants::Invariants;
use crate::method::corrected::range::is_representable;
use crate::method::corrected::turns::check_turns;
use crate::method::corrected::{kept, rounded};
use crate::method::{
    And, Claims, Failure, Handling, Method, Name, Probe, Step, check_conditions, check_poles, outer_step,
};
use crate::scalar::{Real, zero};
use crate::solving::rounding::MAX_ITERATIONS;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot, scaled, sum};
use crate::space::{Array, Compensated, Record, Summation, Tape};
use crate::system::{Evaluations, KeepsEnergy, Poles};
use core::cell::Cell;

/// A step is refused if |γ − 1| exceeds this bound. The theory gives γ = 1 + O(hᵖ⁻¹).
const LARGEST_EXCESS: f64 = 0.5;

/// The last correction of γ, made when the residual is rounding, may have this size. If it would be larger, rounding does not determine γ.
/// The correction is then omitted, and the residual is left to the next step.
const LAST_CORRECTION: f64 = 1e-3;

/// A change of the energy by at most this many ε of its terms counts as rounding.
const ROUNDINGS: f64 = 4.0;

/// A method whose steps are relaxed: `Relaxation(RK4)`.
///
/// Each step is multiplied by a factor γ = 1 + O(hᵖ⁻¹), such that the energy is kept to rounding. For a vector field, the kept function is the
/// integral with the name `energy`, or the first one. Other integrals change; [`Projection`](super::Projection) keeps all of them.
///
/// Time advances by γh, so steps do not end at multiples of h. At the time of the state, the order is that of the method. The method is neither
/// symmetric nor symplectic. If the energy is almost linear along a step, γ is not determined, and the step is refused.
///
/// D. I. Ketcheson, SIAM J. Numer. Anal. 57 (2019) 2850; H. Ranocha & D. I. Ketcheson, J. Sci. Comput. 84 (2020) 17.
#[doc(alias = "relaxation Runge-Kutta")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Relaxation<M>(pub M);

/// Data that a step passes to the next one.
#[derive(Clone, Debug)]
pub struct Memory<M, A: Array> {
    method: M,
    /// Compensated sums: corrections may be smaller than the last digit of a coordinate, and all of one sign.
    sums: Compensated<A>,
    /// The change of the energy by earlier steps that is not yet corrected. Each contribution is rounding, but all may have one sign.
    uncorrected: A::Real,
}

impl<M: Record<A::Real>, A: Array> Record<A::Real> for Memory<M, A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.method.record(tape);
        self.sums.record(tape);
        tape.scalar(&mut self.uncorrected);
    }
}

/// Coefficients of the method, the poles of the system, and the step size h.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    method: P,
    poles: Poles,
    h: R,
}

impl<S: KeepsEnergy<R>, R: Real, M: Method<S, R>> Method<S, R> for Relaxation<M> {
    type Proof = <M::Proof as And<<S as KeepsEnergy<R>>::Proof>>::Both;
    type Prepared = Prepared<M::Prepared, R>;
    type Memory = Memory<M::Memory, S::Phase>;
    const HANDLING: Handling = Handling { scales_steps: true, keeps_invariants: true, ..Handling::PLAIN };

    #[inline]
    fn way_back(_: &Self::Prepared, system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &<S as KeepsEnergy<R>>::Kept::default(), origin, z)
    }

    #[inline]
    fn is_in_range(prepared: &Self::Prepared, system: &S, z: &S::Phase) -> bool {
        M::is_in_range(&prepared.method, system, z)
            && is_representable(system, &<S as KeepsEnergy<R>>::Kept::default(), z)
    }

    fn claims(&self) -> Claims {
        let Claims { order, .. } = self.0.claims();
        Claims { order, symmetric: false, symplectic: false, conserves_energy: true, perturbed: &[], forces: None }
    }

    fn name(&self) -> Name {
        Name::new("Relaxation").of(self.0.name())
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { method: self.0.prepare(system, h), poles: Poles::of(system), h }
    }

    fn memory(z: &S::Phase) -> Self::Memory {
        Memory { method: M::memory(z), sums: Compensated::new(), uncorrected: zero() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { method, poles, h }: &Self::Prepared,
        Memory { method: memory, sums, uncorrected }: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let before = step.x.z;
        outer_step::<S, R, M, C, P>(method, memory, step.part([step.t, step.end]))?;
        let Step { system, t, end: later, x, probe } = step;
        probe.visit(t, &x.z, &());
        let end = x.z;
        check_turns(system, [t, later - t], [&before, &end])?;
        let moved = difference(&end, &before);
        // The rounding of a coordinate follows its size in this step. Its size in earlier steps does not matter.
        let sizes = Sizes::along([&before, &moved]);
        let energy = S::Kept::default();
        let mut gradient = energy.gradients(system, &x.z);
        let rate = dot(&gradient, &moved);
        // Rounding of the coordinates changes the energy by ε times its terms. The value of the energy is rounded, too. This second part
        // dominates if forces cancel.
        let terms = sizes.normalise(&mut gradient).magnitude();
        let rounding = ROUNDINGS * R::epsilon() * terms;
        let noise = || rounding + ROUNDINGS * R::epsilon() * system.kept_energy(t, &before).magnitude();

        // The increment at whose end the branches of the energy (`if`, `abs`) were chosen last.
        let decided = Cell::new(moved);
        let change = |gamma: R| {
            decided.set(scaled(gamma, &moved));
            energy.changes(system, &before, &decided.get())
        };
        let whole = change(R::from_f64(1.0));
        // The remaining change of earlier steps is corrected together with the change of this step.
        let average = |excess: R| {
            let gamma = R::from_f64(1.0) + excess;
            (change(gamma) + *uncorrected) / gamma
        };
        let (excess, rest) = match root(average, (whole + *uncorrected, rate - whole), rounding, noise) {
            // The change is rounding, because the step is short or the energy is almost linear. The next step corrects it.
            Err(_) if whole.magnitude() <= noise() => {
                decided.set(moved);
                (zero(), whole + *uncorrected)
            }
            root => root?,
        };
        *uncorrected = rest * (R::from_f64(1.0) + excess);
        x.correct(sums, &before, &moved, &scaled(excess, &moved));
        x.ahead.add(excess * *h);
        check_conditions(system, t, &sum(&before, &decided.get()), x)?;
        check_poles(poles, Evaluations::AtPoints, &(before, ()), Step::at(t, (system, &mut *x, probe)))?;
        rounded::check_correction(system, [t, later], &energy, [&before, &end, &x.z])
    }
}

/// Solves (H(x + γd) − H(x))/γ = 0 for γ by the secant method. Returns γ − 1 and the residual.
///
/// The division removes the root γ = 0 of the change of H. The function is almost linear in γ. `now` and `slope` are its value and its derivative at
/// γ = 1. The iteration ends if the value is at most `rounding`, or if it is at most `noise` and no longer shrinks by half.
///
/// # Errors
/// [`Failure::NotConverged`] if γ is too far from 1, is not a number, or is not found within [`MAX_ITERATIONS`].
fn root<R: Real>(
    average: impl Fn(R) -> R,
    (mut now, mut slope): (R, R),
    rounding: f64,
    noise: impl Fn() -> f64,
) -> Result<(R, R), Failure> {
    let (mut excess, mut before): (R, f64) = (zero(), f64::INFINITY);
    for iterations in 1..=MAX_ITERATIONS {
        let next = excess - now / slope;
        if now.magnitude() <= rounding {
            let determined = (next - excess).magnitude() <= LAST_CORRECTION;
            return Ok(if determined { (next, zero()) } else { (excess, now) });
        }
        if now.magnitude() > 0.5 * before && now.magnitude() <= noise() {
            return Ok((excess, now));
        }
        // NaN is refused, too.
        if next.magnitude().is_nan() || next.magnitude() > LARGEST_EXCESS {
            return Err(Failure::NotConverged { iterations, correction: next.magnitude() });
        }
        let (distance, value) = (next - excess, average(next));
        // For a tiny distance, the slope of the secant would be rounding. The old slope is kept.
        if distance.magnitude() > Real::sqrt(R::epsilon()) {
            slope = (value - now) / distance;
        }
        before = now.magnitude();
        (excess, now) = (next, value);
    }
    Err(Failure::NotConverged { iterations: MAX_ITERATIONS, correction: now.magnitude() })
}
