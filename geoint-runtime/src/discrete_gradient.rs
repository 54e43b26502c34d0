//! x₁ = x₀ + h J ∇̄H(x₀, x₁): steps that keep the energy to rounding.

use crate::composition::{Composed, Composition, SymmetricMap};
use crate::method::{Claims, Method, NotConverged, Probe};
use crate::newton;
use crate::real::Real;
use crate::system::DiscreteGradientStep;

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with the tree discrete gradient: the energy is kept to rounding for every h.
///
/// Order 2, symmetric, for every H; not symplectic. ∇̄H is the reverse sweep of H with divided differences in place of
/// derivatives, in forms without cancellation. Quadratic and linear momenta that commute with the innermost quadratic
/// and linear forms in which H is written are kept as well: write central forces as functions of `x * x + y * y`. One
/// Newton solve a step, for half of the unknowns if T is quadratic. T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020;
/// R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DiscreteGradient;

impl<S: DiscreteGradientStep<R>, R: Real> Method<S, R> for DiscreteGradient {
    type Prepared = S::Prepared;

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: false, conserves_energy: true }
    }

    fn prepare(&self, system: &S, h: R) -> S::Prepared {
        DiscreteGradientStep::prepare(system, h)
    }

    #[inline(always)]
    fn step<P: Probe<S, R>>(
        prepared: &S::Prepared,
        t: R,
        q: &mut S::Array,
        p: &mut S::Array,
        probe: &mut P,
    ) -> Result<(), NotConverged> {
        probe.visit(t, q, p);
        let (start, guess) = S::start(prepared, t, q, p);
        let increment = newton::solve(guess, S::origin(q, p), |increment, residual, jacobian| {
            let (mut x, mut y) = (*q, *p);
            S::finish(prepared, &start, increment, &mut x, &mut y);
            probe.visit(t, &x, &y);
            S::residual(prepared, &start, increment, residual, jacobian);
        })?;
        S::finish(prepared, &start, &increment, q, p);
        Ok(())
    }
}

impl SymmetricMap for DiscreteGradient {
    type Composed<const K: usize> = Composed<DiscreteGradient, K>;
    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
        Composed { map: self, composition }
    }
}
