//! The mean value of ∇H along the straight line between both ends of a step: the averaged vector field method.

use super::energy::{Energy, Slope};
use super::matrix::Matrix;
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::{Failure, Name, Probe};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::vector::{moved, scaled};
use crate::system::{Conservative, DiscreteField, Mean};

/// The averaged vector field, x₁ = x₀ + h J ∫₀¹ ∇H(x₀ + s(x₁ − x₀)) ds with J(q, p) = (p, −q). The integral has `K` Gauss points, 1 to 6.
///
/// Order 2, symmetric, for every H. The energy is kept to rounding for every h if the mean is exact. Gauss points are exact if H is a polynomial of degree
/// 2K at most. H may also be the sum of a polynomial of degree 2L ≤ 2K and of functions f(l·x) of one linear form l·x each. The mean is then computed from
/// 1 + 2 + … + L tree discrete gradients ([`DiscreteGradient`](crate::DiscreteGradient)), and is exact too. The [report](crate::guide::_05_report) of a system
/// states a proof of exactness, or the term that prevents it. If the mean is not exact, the energy at a fixed time has an error O(h²ᴷ).
///
/// R. I. McLachlan, G. R. W. Quispel & N. Robidoux, Phil. Trans. R. Soc. A 357 (1999) 1021; G. R. W. Quispel & D. I. McLaren, J. Phys. A 41
/// (2008) 045206.
#[doc(alias("average vector field", "averaged vector field"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MeanValue<const K: usize>;

impl<const K: usize> MeanGradient for MeanValue<K>
where
    Gauss<K>: GaussTableau<K>,
{
    /// For the mean g = ∫₀¹ ∇H(x + s d) ds with d = x₁ − x₀, ∂g/∂d = ∫₀¹ s ∇²H ds is symmetric, also as a sum over Gauss points.
    const CURL_FREE: bool = true;

    fn mean_name(&self) -> Name {
        Name::new(
            ["MeanValue<1>", "MeanValue<2>", "MeanValue<3>", "MeanValue<4>", "MeanValue<5>", "MeanValue<6>"][K - 1],
        )
    }

    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        // `Gauss` stands for a polynomial H, and `Parts` for a sum with functions of linear forms.
        matches!(S::MEAN, Mean::Gauss(needed) | Mean::Parts(needed) if needed <= K)
    }

    /// Returns whether ∇H is evaluated at the midpoint only. The step is then the step of [`ImplicitMidpoint`](crate::ImplicitMidpoint). For
    /// [`Mean::Parts`]`(1)` the mean is the tree discrete gradient, which is not symplectic.
    fn is_symplectic<S: DiscreteField<R>, R: Real>() -> bool {
        K == 1 && S::MEAN != Mean::Parts(1)
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        // With one part, the macro has proven that the tree discrete gradient is the mean value.
        if S::MEAN == Mean::Parts(1) {
            return Ok(energy.tree(x, d));
        }
        let points = Gauss::<K>::TABLEAU;
        let mut mean: Slope<S::Array> = Slope { g: Array::zero(), derivative: Matrix::zero() };
        for k in 0..K {
            let [b, c] = [points.b[k], points.c[k]].map(R::from_f64);
            let mut at = energy.gradient(energy.t, &moved(x, c, d));
            mean.g.add_scaled(b, &at.g);
            // ∂/∂d of ∇H(x + c d) is c ∇²H.
            mean.derivative.add_scaled(b * c, &mut at.derivative);
        }
        match S::MEAN {
            // The derivative by Gauss points remains. It is approximate, and slows the solver only.
            Mean::Parts(needed) if needed <= K => mean.g = extrapolated(energy, x, d, needed),
            _ => {}
        }
        Ok(mean)
    }
}

/// Returns the mean of the tree discrete gradients of n equal parts of the line, extrapolated from n = 1, 2, … L to n = ∞, with L = `largest`.
///
/// For a function f(l·x), the tree discrete gradient of a part is l times a divided difference of f. The mean over the parts is l times the divided difference
/// over the line, which is the mean value of the gradient for every n.
///
/// Let H be a polynomial of degree 2L at most. The tree discrete gradient of a part is then a polynomial of degree 2L − 1 in its midpoint and its increment
/// d/n. It is even in d/n, because it does not change if both ends are exchanged. Its mean is a polynomial of degree L − 1 in 1/n², as in the midpoint rule,
/// and L means determine the limit exactly.
///
/// The result is a discrete gradient of every H. Each mean satisfies mean·d = H(x + d) − H(x), because the changes of H over the parts add up, and the
/// weights of all n add up to 1.
fn extrapolated<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
    energy: &mut Energy<'_, S, R, P>,
    x: &S::Phase,
    d: &S::Phase,
    largest: usize,
) -> S::Phase {
    let real = |n: usize| R::from_f64(n as f64);
    let square = |n: usize| real(n * n);
    let mut mean = <S::Phase>::zero();
    for n in 1..=largest {
        let part = scaled(real(1) / real(n), d);
        // The weight of n in Lagrange's interpolation by 1/n², at 1/n² = 0.
        let others = (1..=largest).filter(|other| *other != n);
        let weight = others.fold(real(1), |weight, other| weight * square(n) / (square(n) - square(other)));
        for i in 0..n {
            let start = moved(x, real(i) / real(n), d);
            mean.add_scaled(weight / real(n), &energy.tree(&start, &part).g);
        }
    }
    mean
}

substeps!([const K: usize] MeanValue<K>);
