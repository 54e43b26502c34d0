//! x₁ = x₀ + γ(y − x₀): a step of any method, shortened or lengthened until the energy is what it was.

use crate::method::corrected::invariants::{Energy, Invariants, plus, product, size};
use crate::method::{Claims, Method, Probe, Refusal, Step, check_conditions, check_poles};
use crate::scalar::{Real, zero};
use crate::solving::stagnation::Stagnation;
use crate::space::Array;
use crate::space::Summation;
use crate::system::{Autonomous, DiscreteField, Poles};
use core::cell::Cell;

/// Far beyond γ = 1 + O(hᵖ⁻¹): no relaxation of this step.
const FARTHEST: f64 = 0.5;

/// A method whose steps are relaxed: `Relaxation(RK4)`.
///
/// The energy is kept to rounding, with one factor γ = 1 + O(hᵖ⁻¹) a step. Time goes on by γh, so steps do not end at
/// multiples of h; at the time that the state says, the order is that of the method. Neither symmetric nor symplectic. Where
/// the energy is almost straight along a step γ is not determined, and the step is refused.
///
/// D. I. Ketcheson, SIAM J. Numer. Anal. 57 (2019) 2850; H. Ranocha & D. I. Ketcheson, J. Sci. Comput. 84 (2020) 17.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Relaxation<M>(pub M);

/// What the method prepared, and h.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    method: P,
    poles: Poles,
    h: R,
}

impl<S: DiscreteField<R> + Autonomous<R>, R: Real, M: Method<S, R>> Method<S, R> for Relaxation<M> {
    type Prepared = Prepared<M::Prepared, R>;
    type Memory = M::Memory;
    const SCALES_STEPS: bool = true;

    fn claims(&self) -> Claims {
        let Claims { order, .. } = self.0.claims();
        Claims { order, symmetric: false, symplectic: false, conserves_energy: true }
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { method: self.0.prepare(system, h), poles: Poles::of(system), h }
    }

    fn memory() -> M::Memory {
        M::memory()
    }

    #[inline]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        Prepared { method, poles, h }: &Self::Prepared,
        memory: &mut M::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let before = [step.x.q, step.x.p];
        M::step(method, memory, step.part(step.t))?;
        let Step { system, t, x, probe } = step;
        probe.visit(t, &x.q, &x.p, &());
        let moved = plus([x.q, x.p], -1.0, &before);
        let gradient = Energy.gradients(system, &before);
        let whole = Energy.changes(system, &before, &moved);
        // Where conditions of the energy were decided last.
        let decided = Cell::new(moved);
        let secant = whole - product(&gradient, &moved);
        let excess = match excess(system, &before, &moved, (whole, secant), &decided) {
            // A step so short, or an energy so straight, that there is nothing but rounding to put right.
            Err(_) if whole.magnitude() <= R::epsilon() * size(&gradient) * size(&before) => zero(),
            outcome => outcome?,
        };
        let [dq, dp] = moved.map(|d| scaled(excess, &d));
        x.add(&dq, &dp);
        x.ahead.add(excess * *h);
        check_conditions(system, t, &plus(before, 1.0, &decided.get()), x)?;
        check_poles(poles, false, [t; 2], &(before[0], before[1], ()), Step { system, t, x, probe })
    }
}

/// γ − 1 for a step by `d` from `x`: the root of (H(x + γd) − H(x))/γ = ∇̄H·d.
///
/// The root γ = 0 is gone, and what is left is almost a straight line. It starts from the value for γ = 1 and the secant from
/// γ = 0 to there.
#[inline]
fn excess<S, R: Real>(
    system: &S,
    x: &[S::Array; 2],
    d: &[S::Array; 2],
    (mut value, mut secant): (R, R),
    decided: &Cell<[S::Array; 2]>,
) -> Result<R, Refusal>
where
    S: DiscreteField<R> + Autonomous<R>,
{
    let value_at = |excess: R| {
        let gamma = R::from_f64(1.0) + excess;
        decided.set(d.map(|d| scaled(gamma, &d)));
        Energy.changes(system, x, &decided.get()) / gamma
    };
    let mut excess = zero::<R>();
    let mut stagnation = Stagnation::new();
    while value.magnitude() != 0.0 {
        let correction = -value / secant;
        excess += correction;
        if stagnation.reached::<R>(correction.magnitude() * size(d) / size(x))? {
            break;
        }
        if excess.magnitude() > FARTHEST {
            return Err(Refusal::NotConverged { iterations: 1, correction: excess.magnitude() });
        }
        let there = value_at(excess);
        // A secant over rounding errors would be none.
        if correction.magnitude() > Real::sqrt(R::epsilon()) {
            secant = (there - value) / correction;
        }
        value = there;
    }
    Ok(excess)
}

/// w·x.
fn scaled<A: Array>(w: A::Real, x: &A) -> A {
    let mut y = A::zero();
    y.add_scaled(w, x);
    y
}
