//! x₁ = x₀ + γ(y − x₀): a step of any method, shortened or lengthened until the energy is what it was.

use super::Memory;
use crate::method::corrected::invariants::Invariants;
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_conditions, check_poles, outer_step};
use crate::scalar::{Real, zero};
use crate::solving::rounding::correct;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot, scaled, sum};
use crate::space::{Compensated, Summation};
use crate::system::{KeepsEnergy, Poles};
use core::cell::Cell;

/// Far beyond γ = 1 + O(hᵖ⁻¹): no relaxation of this step.
const FARTHEST: f64 = 0.5;

/// A change of the energy by so many ε of its terms is rounding.
const ROUNDINGS: f64 = 4.0;

/// A method whose steps are relaxed: `Relaxation(RK4)`.
///
/// The energy is kept to rounding, or of a field the function that it keeps as `energy`, or names first; with one factor γ = 1 + O(hᵖ⁻¹) a
/// step; other integrals change: [`Projection`](super::Projection) keeps all. Time goes on by γh, so steps do not end at multiples of h; at the time that the state says, the order is that of the method.
/// Neither symmetric nor symplectic. Where the energy is almost straight along a step γ is not determined, and the step is refused.
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

impl<S: KeepsEnergy<R>, R: Real, M: Method<S, R>> Method<S, R> for Relaxation<M> {
    type Proof = <M::Proof as And<<S as KeepsEnergy<R>>::Proof>>::Both;
    type Prepared = Prepared<M::Prepared, R>;
    type Memory = Memory<M::Memory, S::Phase>;
    const SCALES_STEPS: bool = true;

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
        Memory { method: M::memory(), sizes: Sizes::new(), sums: Compensated::new() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { method, poles, h }: &Self::Prepared,
        Memory { method: memory, sizes, sums }: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let before = step.x.z;
        outer_step::<S, R, M, C, P>(method, memory, *h, step.part(step.t))?;
        let Step { system, t, x, probe } = step;
        probe.visit(t, &x.z, &());
        let moved = difference(&x.z, &before);
        sizes.include(&before, &moved);
        let energy = S::Kept::default();
        let mut gradient = energy.gradients(system, &before);
        let whole = energy.changes(system, &before, &moved);
        let secant = whole - dot(&gradient, &moved);
        // What rounding of the coordinates changes the energy by is ε times its terms; and it has a value of its own to be rounded.
        let terms = sizes.normalise(&mut gradient) + system.kept_energy(t, &before).abs();

        // γ − 1 is the root of (H(x + γd) − H(x))/γ = ∇̄H·d. The root γ = 0 is gone, and what is left is almost a straight line. The
        // iteration starts from the value for γ = 1 and the secant from γ = 0 to there.
        // The increments at whose end conditions of the energy were decided last.
        let decided = Cell::new(moved);
        let value = |excess: R| {
            let gamma = R::from_f64(1.0) + excess;
            decided.set(scaled(gamma, &moved));
            energy.changes(system, &before, &decided.get()) / gamma
        };
        let mut line = (zero(), whole, secant);
        let solution = correct(
            zero::<R>(),
            |_, _, relative, _| relative <= ROUNDINGS * R::epsilon(),
            |excess| {
                if excess.magnitude() > FARTHEST {
                    return Err(Refusal::NotConverged { iterations: 1, correction: excess.magnitude() });
                }
                let (last, before, secant) = line;
                let (distance, now) = (*excess - last, if excess.magnitude() == 0.0 { whole } else { value(*excess) });
                // A secant over rounding errors would be none.
                let far = distance.magnitude() > Real::sqrt(R::epsilon());
                let secant = if far { (now - before) / distance } else { secant };
                line = (*excess, now, secant);
                let relative = now.magnitude() / terms.magnitude();
                Ok(if now.magnitude() == 0.0 { (zero(), 0.0) } else { (now / secant, relative) })
            },
        );
        let excess = match solution {
            // A step so short, or an energy so straight, that there is nothing but rounding to put right.
            Err(_) if whole.magnitude() <= ROUNDINGS * R::epsilon() * terms.magnitude() => {
                decided.set(moved);
                zero()
            }
            solution => solution?,
        };
        x.correct(sums, &before, &moved, &scaled(excess, &moved));
        x.ahead.add(excess * *h);
        check_conditions(system, t, &sum(&before, &decided.get()), x)?;
        check_poles(poles, false, [t; 2], &(before, ()), Step { system, t, x, probe })
    }
}
