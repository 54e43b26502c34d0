//! x₁ = x₀ + γ(y − x₀): a step of any method, shortened or lengthened until the energy is what it was.

use crate::method::corrected::invariants::Invariants;
use crate::method::corrected::range::is_representable;
use crate::method::corrected::turns::check_turns;
use crate::method::corrected::{kept, rounded};
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_conditions, check_poles, outer_step};
use crate::scalar::{Real, zero};
use crate::solving::rounding::MAX_ITERATIONS;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot, scaled, sum};
use crate::space::{Array, Compensated, Record, Summation, Tape};
use crate::system::{Evaluations, KeepsEnergy, Poles};
use core::cell::Cell;

/// Far beyond γ = 1 + O(hᵖ⁻¹): no relaxation of this step.
const FARTHEST: f64 = 0.5;

/// A correction of γ behind which nothing is left. Where a larger one is needed for what is rounding, γ is not determined by it.
const LITTLE: f64 = 1e-3;

/// A change of the energy by so many ε of its terms is rounding.
const ROUNDINGS: f64 = 4.0;

/// A method whose steps are relaxed: `Relaxation(RK4)`.
///
/// The energy is kept to rounding, or of a field the function that it keeps as `energy`, or names first; with one factor γ = 1 + O(hᵖ⁻¹) a
/// step; other integrals change: [`Projection`](super::Projection) keeps all. Time goes on by γh, so steps do not end at multiples of h; at the
/// time that the state says, the order is that of the method.
/// Neither symmetric nor symplectic. Where the energy is almost straight along a step γ is not determined, and the step is refused.
///
/// D. I. Ketcheson, SIAM J. Numer. Anal. 57 (2019) 2850; H. Ranocha & D. I. Ketcheson, J. Sci. Comput. 84 (2020) 17.
#[doc(alias = "relaxation Runge-Kutta")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Relaxation<M>(pub M);

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<M, A: Array> {
    method: M,
    /// Corrections may be smaller than the last digit of a coordinate, and all of one sign.
    sums: Compensated<A>,
    /// What steps before have changed the energy by, less than rounding of it each, and all of one sign perhaps.
    left: A::Real,
}

impl<M: Record<A::Real>, A: Array> Record<A::Real> for Memory<M, A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.method.record(tape);
        self.sums.record(tape);
        tape.scalar(&mut self.left);
    }
}

/// What the method prepared, and h.
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
    const SCALES_STEPS: bool = true;
    const KEEPS: bool = true;

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

    fn memory() -> Self::Memory {
        Memory { method: M::memory(), sums: Compensated::new(), left: zero() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { method, poles, h }: &Self::Prepared,
        Memory { method: memory, sums, left }: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let before = step.x.z;
        outer_step::<S, R, M, C, P>(method, memory, step.part([step.t, step.end]))?;
        let Step { system, t, end: later, x, probe } = step;
        probe.visit(t, &x.z, &());
        let end = x.z;
        check_turns(system, [t, later - t], [&before, &end])?;
        let moved = difference(&end, &before);
        // Coordinates are rounded as they are on the way of this step: what was large lately is exact now.
        let mut sizes = Sizes::new();
        sizes.include(&before, &moved);
        let energy = S::Kept::default();
        let mut gradient = energy.gradients(system, &x.z);
        let rate = dot(&gradient, &moved);
        // What rounding of the coordinates changes the energy by is ε times its terms. The energy has a value of its own to be rounded, and forces
        // that cancel are small beside it.
        let terms = sizes.normalise(&mut gradient).magnitude();
        let rounding = ROUNDINGS * R::epsilon() * terms;
        let noise = || rounding + ROUNDINGS * R::epsilon() * system.kept_energy(t, &before).magnitude();

        // The increments at whose end conditions of the energy were decided last.
        let decided = Cell::new(moved);
        let change = |gamma: R| {
            decided.set(scaled(gamma, &moved));
            energy.changes(system, &before, &decided.get())
        };
        let whole = change(R::from_f64(1.0));
        // What steps before have left is put right with what this one changes.
        let average = |excess: R| {
            let gamma = R::from_f64(1.0) + excess;
            (change(gamma) + *left) / gamma
        };
        let (excess, rest) = match root(average, (whole + *left, rate - whole), rounding, noise) {
            // A step so short, or an energy so straight, that there is hardly more than rounding to put right: the next step has it.
            Err(_) if whole.magnitude() <= noise() => {
                decided.set(moved);
                (zero(), whole + *left)
            }
            root => root?,
        };
        *left = rest * (R::from_f64(1.0) + excess);
        x.correct(sums, &before, &moved, &scaled(excess, &moved));
        x.ahead.add(excess * *h);
        check_conditions(system, t, &sum(&before, &decided.get()), x)?;
        check_poles(poles, Evaluations::AtPoints, &(before, ()), Step::at(t, (system, &mut *x, probe)))?;
        rounded::check_correction(system, [t, later], &energy, [&before, &end, &x.z])
    }
}

/// The root γ − 1 of (H(x + γd) − H(x))/γ = ∇̄H·d, which is almost a straight line: the root γ = 0 of the change itself is gone. Its
/// value and its slope at γ = 1 are given; it is a root where the value is rounding, or noise that does not shrink, and that comes with it.
fn root<R: Real>(
    average: impl Fn(R) -> R,
    (mut now, mut slope): (R, R),
    rounding: f64,
    noise: impl Fn() -> f64,
) -> Result<(R, R), Refusal> {
    let (mut excess, mut before): (R, f64) = (zero(), f64::INFINITY);
    for iterations in 1..=MAX_ITERATIONS {
        let next = excess - now / slope;
        if now.magnitude() <= rounding {
            let determined = (next - excess).magnitude() <= LITTLE;
            return Ok(if determined { (next, zero()) } else { (excess, now) });
        }
        if now.magnitude() > 0.5 * before && now.magnitude() <= noise() {
            return Ok((excess, now));
        }
        // What is not a number is far as well.
        if next.magnitude().is_nan() || next.magnitude() > FARTHEST {
            return Err(Refusal::NotConverged { iterations, correction: next.magnitude() });
        }
        let (distance, value) = (next - excess, average(next));
        // A secant over rounding errors would be none.
        if distance.magnitude() > Real::sqrt(R::epsilon()) {
            slope = (value - now) / distance;
        }
        before = now.magnitude();
        (excess, now) = (next, value);
    }
    Err(Refusal::NotConverged { iterations: MAX_ITERATIONS, correction: now.magnitude() })
}
