//! The scheme of Chorin, Hughes, McCracken and Marsden: q along ∂H/∂p, then p along ∂H/∂q, as far as the energy asks.

use super::energy::{Energy, Slope, Staircase};
use super::matrix::denominator;
use super::mean::MeanGradient;
use crate::method::{Name, Probe, Refusal};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::vector::{difference, dot, moved};
use crate::system::{Conservative, DiscreteField};

/// Where the terms of the product of a direction and an increment cancel down to this part of them, it is no basis for a quotient.
const SINGULAR: f64 = 1e-8;

/// q₁ = q₀ + h λ (H(q₁, p₁) − H(q₁, p₀))/(λ·(p₁ − p₀)), p₁ = p₀ − h μ (H(q₁, p₀) − H(q₀, p₀))/(μ·(q₁ − q₀)), with
/// λ = ∂H/∂p at (αq₁ + (1 − α)q₀, βp₁ + (1 − β)p₀) and μ = ∂H/∂q at (γq₁ + (1 − γ)q₀, δp₁ + (1 − δ)p₀). The energy is kept
/// to rounding for every h.
///
/// Order 1, for every H. Order 2 and symmetric for T(p) + V(q) if β = γ = ½, as by default: then λ and μ are at midpoints, and α
/// and δ do not matter. With one degree of freedom λ and μ cancel, and this is [`ItohAbe`](super::ItohAbe), with its orders. With more,
/// there is no step where an increment is orthogonal to its direction: [`StepError::SingularDirection`](crate::StepError::SingularDirection).
/// Differences of H are taken from the tree discrete gradient. A. J. Chorin, T. J. R. Hughes, M. F. McCracken &
/// J. E. Marsden, Comm. Pure Appl. Math. 31 (1978) 205.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoordinateIncrement {
    /// Where between q₀ and q₁ the direction of q is taken.
    pub alpha: f64,
    /// Where between p₀ and p₁ the direction of q is taken.
    pub beta: f64,
    /// Where between q₀ and q₁ the direction of p is taken.
    pub gamma: f64,
    /// Where between p₀ and p₁ the direction of p is taken.
    pub delta: f64,
}

impl Default for CoordinateIncrement {
    /// Directions at midpoints.
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
    ) -> Result<Slope<S::Array>, Refusal> {
        let Staircase { g, end, .. } = energy.staircase(x, d, S::Array::LEN);
        if S::Array::LEN == 1 {
            return Ok(Slope { g, derivative: end });
        }
        let mut between = |q: f64, p: f64| {
            let [q, p] = [(0, q), (1, p)].map(|(i, w)| moved(&x[i], R::from_f64(w), &d[i]));
            energy.gradient(energy.t, &[q, p]).g
        };
        let ([mu, _], [_, lambda]) = (between(self.gamma, self.delta), between(self.alpha, self.beta));
        Ok(Slope { g: [along(&mu, &g[0], &d[0])?, along(&lambda, &g[1], &d[1])?], derivative: end })
    }
}

/// The multiple of `direction` that has the same product with `d` as `g`.
fn along<A: Array>(direction: &A, g: &A, d: &A) -> Result<A, Refusal> {
    let product = dot(direction, d);
    let terms = direction.as_slice().iter().zip(d.as_slice()).map(|(a, b)| (*a * *b).magnitude());
    if product.magnitude() <= SINGULAR * terms.sum::<f64>() && !direction.is_zero() && !d.is_zero() {
        return Err(Refusal::SingularDirection);
    }
    // The excess over 1: where d = 0 that is 0/0 and means 0.
    let ratio = dot(&difference(g, direction), d) / (product.signum() * denominator(product.abs()));
    Ok(moved(direction, ratio, direction))
}
