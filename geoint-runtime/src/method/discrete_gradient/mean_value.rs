//! The mean value of ∇H along the straight line between both ends of a step: the averaged vector field method.

use super::energy::{Energy, Slope};
use super::matrix::Matrix;
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::{Name, Probe, Refusal};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::vector::{moved, scaled};
use crate::system::{Conservative, DiscreteField, Mean};

/// The averaged vector field, x₁ = x₀ + h J ∫₀¹ ∇H(x₀ + s(x₁ − x₀)) ds with J(q, p) = (p, −q). The integral has `K` Gauss points, 1 to 6.
///
/// Order 2, symmetric, for every H. The energy is kept to rounding for every h if the integral is exact. The integral is exact if H is a sum of
/// functions of linear forms and of a polynomial of degree 2K at most. The report of a system states a proof of exactness, or the term that prevents
/// it. If the integral is not exact, the error of the energy is O(h²ᴷ).
/// R. I. McLachlan, G. R. W. Quispel & N. Robidoux, Phil. Trans. R. Soc. A 357 (1999) 1021; G. R. W. Quispel & D. I. McLaren, J. Phys. A 41
/// (2008) 045206.
#[doc(alias("average vector field", "averaged vector field"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MeanValue<const K: usize>;

impl<const K: usize> MeanGradient for MeanValue<K>
where
    Gauss<K>: GaussTableau<K>,
{
    const CURL_FREE: bool = true;

    fn mean_name(&self) -> Name {
        Name::new(
            ["MeanValue<1>", "MeanValue<2>", "MeanValue<3>", "MeanValue<4>", "MeanValue<5>", "MeanValue<6>"][K - 1],
        )
    }

    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
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
    ) -> Result<Slope<S::Array>, Refusal> {
        // For these systems the tree discrete gradient is the mean value.
        if S::MEAN == Mean::Parts(1) {
            return Ok(energy.tree(x, d));
        }
        let points = Gauss::<K>::TABLEAU;
        let mut mean: Slope<S::Array> = Slope { g: Array::zero(), derivative: Matrix::zero() };
        for k in 0..K {
            let [b, c] = [points.b[k], points.c[k]].map(R::from_f64);
            let mut at = energy.gradient(energy.t, &moved(x, c, d));
            mean.g.add_scaled(b, &at.g);
            mean.derivative.add_scaled(b * c, &mut at.derivative);
        }
        match S::MEAN {
            // The derivative by Gauss points remains. It is approximate, and only the solver reads it.
            Mean::Parts(needed) if needed <= K => mean.g = extrapolated(energy, x, d, needed),
            _ => {}
        }
        Ok(mean)
    }
}

/// Returns the mean of the tree discrete gradients of n equal parts of the line, extrapolated from n = 1, 2, … `largest` to n = ∞.
///
/// For a function of a linear form, the mean over the parts equals the mean value of the gradient for every n. For a polynomial H of degree 2·`largest`
/// at most, it is a polynomial of degree `largest` − 1 in 1/n², because the tree discrete gradient is a symmetric polynomial of both ends. The
/// extrapolation is then exact. The result is a discrete gradient of every H.
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
