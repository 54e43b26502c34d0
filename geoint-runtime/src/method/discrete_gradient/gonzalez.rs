//! The gradient at the midpoint, corrected along the increment.

use super::energy::{Energy, Slope};
use super::matrix::{difference, dot, entries, moved, scaled, tiny};
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::{Name, Probe, Refusal};
use crate::scalar::Real;
use crate::space::Array;
use crate::system::{Conservative, DiscreteField};

/// x₁ = x₀ + h J g with g = ∇H(m) + (H(x₁) − H(x₀) − ∇H(m)·d)/(d·d) d, m the midpoint, d = x₁ − x₀. The energy is kept to
/// rounding for every h.
///
/// Order 2, symmetric, for every H. H(x₁) − H(x₀) is taken from the tree discrete gradient, not from a difference, so that short
/// steps lose nothing. O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gonzalez;

impl MeanGradient for Gonzalez {
    fn mean_name(&self) -> Name {
        Name::new("Gonzalez")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &[S::Array; 2],
        d: &[S::Array; 2],
    ) -> Result<Slope<S::Array>, Refusal> {
        let (one, half) = (R::from_f64(1.0), R::from_f64(0.5));
        let mut tree = energy.tree(x, d);
        let mut middle = energy.gradient(energy.t, &moved(x, half, d));
        let square = dot(d, d).max(tiny());
        let excess = difference(&tree.g, &middle.g);
        let factor = dot(&excess, d) / square;

        // ∂factor/∂d.
        let mut slope = moved(&excess, one, &tree.derivative.transpose_times(d));
        slope.add_scaled(-half, &middle.derivative.transpose_times(d));
        slope.add_scaled(-(factor + factor), d);
        let slope = scaled(one / square, &slope);

        let g = moved(&middle.g, factor, d);
        for (i, row) in middle.derivative.rows().iter_mut().enumerate() {
            *row = moved(&scaled(half, row), Array::as_slice(d)[i], &slope);
            entries(row)[i] += factor;
        }
        Ok(Slope { g, derivative: middle.derivative })
    }
}

substeps!([] Gonzalez);
