//! The scheme of Chorin, Hughes, McCracken and Marsden (1978). A step moves q along ∂H/∂p, and p along −∂H/∂q. It scales both directions so that H is kept.

use super::energy::{Energy, Slope, Staircase};
use super::matrix::denominator;
use super::mean::MeanGradient;
use crate::method::{Failure, Name, Probe};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::vector::{difference, dot, moved};
use crate::system::{Conservative, DiscreteField};

/// Smallest product of a direction and an increment, relative to the sum of the magnitudes of its terms. The step divides by the product, and is refused
/// if it is smaller. The bound is near √ε of double precision: a smaller product has fewer than half of its digits.
const LEAST_PRODUCT: f64 = 1e-8;

/// q₁ = q₀ + h λ (H(q₁, p₁) − H(q₁, p₀))/(λ·(p₁ − p₀)), p₁ = p₀ − h μ (H(q₁, p₀) − H(q₀, p₀))/(μ·(q₁ − q₀)). The directions are λ = ∂H/∂p at
/// (αq₁ + (1 − α)q₀, βp₁ + (1 − β)p₀) and μ = ∂H/∂q at (γq₁ + (1 − γ)q₀, δp₁ + (1 − δ)p₀). Accepted steps keep the energy to rounding for every h, if H
/// does not read time.
///
/// Order 1, for every H. Order 2 and symmetric for T(p) + V(q) if β = γ = ½, as by default. Then λ and μ are at midpoints, and α and δ do not matter.
/// With one degree of freedom λ and μ cancel. The method is then [`ItohAbe`](super::ItohAbe), with its orders. With more degrees of freedom, no step
/// exists if an increment is orthogonal to its direction: [`Failure::SingularDirection`](crate::Failure::SingularDirection). Differences of H are
/// products of increments with the gradient of [`DiscreteGradient`](crate::DiscreteGradient), so that short steps lose no digits.
///
/// A. J. Chorin, T. J. R. Hughes, M. F. McCracken & J. E. Marsden, Comm. Pure Appl. Math. 31 (1978) 205.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoordinateIncrement {
    /// α: the fraction of the way from q₀ to q₁ at which the direction λ of q is taken.
    pub alpha: f64,
    /// β: the fraction of the way from p₀ to p₁ for λ.
    pub beta: f64,
    /// γ: the fraction of the way from q₀ to q₁ at which the direction μ of p is taken.
    pub gamma: f64,
    /// δ: the fraction of the way from p₀ to p₁ for μ.
    pub delta: f64,
}

impl Default for CoordinateIncrement {
    /// Returns 1/2 for all four: directions at midpoints.
    fn default() -> Self {
        CoordinateIncrement { alpha: 0.5, beta: 0.5, gamma: 0.5, delta: 0.5 }
    }
}

impl MeanGradient for CoordinateIncrement {
    fn mean_name(&self) -> Name {
        Name::new("CoordinateIncrement")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        // Two edges: q changes at p₀, then p at q₁. The products of g with the increments are the two differences of H.
        let Staircase { g, end, .. } = energy.staircase(x, d, S::Array::LEN);
        if S::Array::LEN == 1 {
            return Ok(Slope { g, derivative: end });
        }
        let mut gradient_at = |q: f64, p: f64| {
            let [q, p] = [(0, q), (1, p)].map(|(i, w)| moved(&x[i], R::from_f64(w), &d[i]));
            energy.gradient(energy.t, &[q, p]).g
        };
        let ([mu, _], [_, lambda]) = (gradient_at(self.gamma, self.delta), gradient_at(self.alpha, self.beta));
        // The derivative is the one of the unscaled g. It is approximate, and only the solver reads it.
        Ok(Slope { g: [along(&mu, &g[0], &d[0])?, along(&lambda, &g[1], &d[1])?], derivative: end })
    }
}

/// Returns the multiple of `direction` whose product with `d` equals g·d.
///
/// # Errors
/// [`Failure::SingularDirection`] if `direction` and `d` are orthogonal up to [`LEAST_PRODUCT`], and neither is zero.
fn along<A: Array>(direction: &A, g: &A, d: &A) -> Result<A, Failure> {
    let product = dot(direction, d);
    let terms = direction.as_slice().iter().zip(d.as_slice()).map(|(a, b)| (*a * *b).magnitude());
    if product.magnitude() <= LEAST_PRODUCT * terms.sum::<f64>() && !direction.is_zero() && !d.is_zero() {
        return Err(Failure::SingularDirection);
    }
    // The factor is 1 + excess. For d = 0 the excess is 0/0, which `denominator` makes 0.
    let excess = dot(&difference(g, direction), d) / (product.signum() * denominator(product.abs()));
    Ok(moved(direction, excess, direction))
}
