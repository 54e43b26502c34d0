//! x₁ = x₀ + h J ∇̄H(x₀, x₁): one driver for every mean gradient ∇̄H.

use crate::composition::{Composed, Composition, SymmetricMap};
use crate::method::{Claims, Method, NotConverged, Probe};
use crate::newton;
use crate::real::Real;
use crate::system::MeanGradient;
use crate::system::mean_gradient::{Midpoint, Tree};

/// x₁ = x₀ + h J ∇H((x₀ + x₁)/2). Order 2, symmetric, symplectic, for every H; keeps quadratic invariants.
///
/// One Newton solve a step, for q alone if T is quadratic. For a higher order prefer [`Gauss`](crate::Gauss) to a
/// composition of this.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImplicitMidpoint;

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with the tree discrete gradient: the energy is kept to rounding for every h.
///
/// Order 2, symmetric, for every H; not symplectic. ∇̄H is the reverse sweep of H with divided differences in place of
/// derivatives, in forms without cancellation. Quadratic and linear momenta that commute with the innermost quadratic
/// and linear forms in which H is written are kept as well: write central forces as functions of `x * x + y * y`.
/// T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020; R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct DiscreteGradient {}

/// The step of both methods.
#[inline(always)]
fn step<G, S: MeanGradient<G, R>, R: Real, P: Probe<S, R>>(
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

/// A method that takes its step with one mean gradient.
macro_rules! implicit_method {
    ($method:ident, $mean:ident, $claims:expr) => {
        impl<S: MeanGradient<$mean, R>, R: Real> Method<S, R> for $method {
            type Prepared = S::Prepared;

            fn claims(&self) -> Claims {
                $claims
            }
            fn prepare(&self, system: &S, h: R) -> S::Prepared {
                MeanGradient::<$mean, R>::prepare(system, h)
            }
            #[inline(always)]
            fn step<P: Probe<S, R>>(
                prepared: &S::Prepared,
                t: R,
                q: &mut S::Array,
                p: &mut S::Array,
                probe: &mut P,
            ) -> Result<(), NotConverged> {
                step::<$mean, S, R, P>(prepared, t, q, p, probe)
            }
        }

        impl SymmetricMap for $method {
            type Composed<const K: usize> = Composed<$method, K>;
            fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
                Composed { map: self, composition }
            }
        }
    };
}

implicit_method!(ImplicitMidpoint, Midpoint, Claims { order: 2, symmetric: true, symplectic: true, conserves_energy: false });
implicit_method!(DiscreteGradient, Tree, Claims { order: 2, symmetric: true, symplectic: false, conserves_energy: true });
