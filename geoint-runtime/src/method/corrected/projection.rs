//! x₁ = y + Σ λᵢ∇Iᵢ(y): a step of any method, and back to where the invariants were.

use crate::method::corrected::invariants::{Invariants, plus, product, size};
use crate::method::{Claims, Method, Probe, Refusal, Step, check_conditions, check_poles};
use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::stagnation::Stagnation;
use crate::space::Summation;
use crate::space::{Array, Square};
use crate::system::{Hamiltonian, Poles};

/// A method, and the invariants that each of its steps is projected onto: `Projection(RK4, Energy)`.
///
/// The order of the method; invariants are kept to rounding as long as their gradients are linearly independent. Neither
/// symmetric nor symplectic: what is not projected onto drifts, even the momentum of a cyclic coordinate. Distance is measured in the units in which q and p are given.
/// E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), section IV.4, algorithm 4.2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Projection<M, I>(pub M, pub I);

/// What the method prepared, and the invariants.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, I> {
    method: P,
    poles: Poles,
    invariants: I,
}

impl<S: Hamiltonian<R>, R: Real, M: Method<S, R>, I: Invariants<S, R>> Method<S, R> for Projection<M, I> {
    type Prepared = Prepared<M::Prepared, I>;
    type Memory = M::Memory;
    const SCALES_STEPS: bool = M::SCALES_STEPS;

    fn claims(&self) -> Claims {
        let Claims { order, .. } = self.0.claims();
        Claims { order, symmetric: false, symplectic: false, conserves_energy: I::KEEP_ENERGY }
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { method: self.0.prepare(system, h), poles: Poles::of(system), invariants: self.1 }
    }

    fn memory() -> M::Memory {
        M::memory()
    }

    #[inline]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        Prepared { method, poles, invariants }: &Self::Prepared,
        memory: &mut M::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let before = [step.x.q, step.x.p];
        M::step(method, memory, step.part(step.t))?;
        let Step { system, t, x, probe } = step;
        probe.visit(t, &x.q, &x.p, &());
        let moved = plus([x.q, x.p], -1.0, &before);
        let mut gradients = invariants.gradients(system, &[x.q, x.p]);
        let gradients = I::Values::entries(&mut gradients);

        // Simplified Newton: at y, with the gradients that are there already.
        let mut matrix = I::Values::fill(I::Values::zero());
        fill::<I::Values>(&mut matrix, |i, j| product(&gradients[i], &gradients[j]));
        let scale = size(&before) + size(&moved);
        let mut back = [S::Array::zero(); 2];
        // Where conditions of the energy were decided last.
        let mut decided;
        let mut stagnation = Stagnation::new();
        loop {
            let change = plus(moved, 1.0, &back);
            decided = plus(before, 1.0, &change);
            let mut lambda = invariants.changes(system, &before, &change);
            // Also where gradients vanish there may be nothing to do.
            let nothing = lambda.as_slice().iter().all(|change| change.magnitude() == 0.0);
            if !nothing && linear::solve::<I::Values>(&mut matrix.clone(), &mut lambda).is_none() {
                return Err(Refusal::Singular);
            }
            let mut correction = [S::Array::zero(); 2];
            for (gradient, lambda) in gradients.iter().zip(lambda.as_slice()) {
                for (x, gradient) in correction.iter_mut().zip(gradient) {
                    x.add_scaled(-*lambda, gradient);
                }
            }
            back = plus(back, 1.0, &correction);
            if nothing || stagnation.reached::<R>(size(&correction) / scale)? {
                break;
            }
        }
        let [dq, dp] = back;
        x.add(&dq, &dp);
        if I::KEEP_ENERGY {
            check_conditions(system, t, &decided, x)?;
        }
        check_poles(poles, false, [t; 2], &(before[0], before[1], ()), Step { system, t, x, probe })
    }
}

/// Writes a matrix entry by entry.
fn fill<A: Array>(matrix: &mut Square<A>, entry: impl Fn(usize, usize) -> A::Real) {
    for (i, row) in A::entries::<A>(matrix).iter_mut().enumerate() {
        for (j, x) in row.as_mut_slice().iter_mut().enumerate() {
            *x = entry(i, j);
        }
    }
}
