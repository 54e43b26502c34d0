//! The mean value of the gradient along the segment.

use super::energy::{Energy, Slope};
use super::matrix::{Matrix, moved};
use super::mean::MeanGradient;
use crate::array::Array;
use crate::composition::substeps;
use crate::gauss::Gauss;
use crate::method::{Probe, Refusal};
use crate::real::Real;
use crate::system::{Conservative, DiscreteField};
use crate::tableau::GaussTableau;

/// x₁ = x₀ + h J ∫₀¹ ∇H(x₀ + s(x₁ − x₀)) ds, the averaged vector field, with `K` Gauss points for the integral, 1 to 6.
///
/// Order 2, symmetric, for every H. The energy is kept to rounding for every h where the integral is exact: if H is a
/// polynomial of degree 2K at most, or a sum of functions of linear forms. Elsewhere it is kept to O(h²ᴷ).
/// R. I. McLachlan, G. R. W. Quispel & N. Robidoux, Phil. Trans. R. Soc. A 357 (1999) 1021;
/// G. R. W. Quispel & D. I. McLaren, J. Phys. A 41 (2008) 045206.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MeanValue<const K: usize>;

impl<const K: usize> MeanGradient for MeanValue<K>
where
    Gauss<K>: GaussTableau<K>,
{
    const CURL_FREE: bool = true;

    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        S::MEAN_POINTS.is_some_and(|points| points <= K)
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &[S::Array; 2],
        d: &[S::Array; 2],
    ) -> Result<Slope<S::Array>, Refusal> {
        if S::MEAN_POINTS == Some(0) {
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
        Ok(mean)
    }
}

substeps!([const K: usize] MeanValue<K>);
