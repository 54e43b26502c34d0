//! The gradient at the midpoint, corrected along the increment.

use super::energy::{Energy, Slope};
use super::matrix::{denominator, turned};
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::{Name, Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::slope::before_squares;
use crate::space::Array;
use crate::space::vector::{difference, dot, entries, moved, product, scaled};
use crate::system::{Conservative, DiscreteField};

/// x₁ = x₀ + h J g with g = ∇H(m) + (H(x₁) − H(x₀) − ∇H(m)·d)/(d·Wd) Wd, m the midpoint, d = x₁ − x₀. The energy is kept to
/// rounding for every h.
///
/// Order 2, symmetric, for every H. H(x₁) − H(x₀) is taken from the tree discrete gradient, not from a difference, so that short
/// steps lose nothing. O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449, with W = 1.
///
/// The metric W is a choice. Lengths of d need one, because positions and momenta, or lengths and angles, have different units: with
/// W = 1, as published, the step depends on them. Here W is diagonal, wᵢ² = (ε Hᵢᵢ)² + (ω ∂H/∂xᵢ)⁴, taken at m with
/// ε² = Σ(ẋᵢHᵢⱼẋⱼ)² and ω⁴ = Σ(FᵢⱼFⱼᵢ)², F = J∇²H: energies in place of lengths. For an oscillator wᵢ is the stiffness or the
/// reciprocal mass, up to a factor. It is zero for a cyclic coordinate, so that its momentum is kept; it is not the same in rotated
/// axes. Where d·Wd = 0, as in front of a jump of a constant potential, g is the tree discrete gradient itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gonzalez;

impl MeanGradient for Gonzalez {
    fn mean_name(&self) -> Name {
        Name::new("Gonzalez")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Refusal> {
        let (one, half) = (R::from_f64(1.0), R::from_f64(0.5));
        let mut tree = energy.tree(x, d);
        let mut middle = energy.gradient(energy.t, &moved(x, half, d));
        let metric = metric(energy.h, &mut middle);
        let weighted = product(&metric, d);
        let square = dot(&weighted, d);
        if square == zero() {
            // A correction along W d is none, and the energy may have jumped between the ends.
            return Ok(tree);
        }
        let excess = difference(&tree.g, &middle.g);
        let factor = dot(&excess, d) / square;

        // ∂factor/∂d. What W adds to that is of higher order, and the same from both ends.
        let mut slope = moved(&excess, one, &tree.derivative.transpose_times(d));
        slope.add_scaled(-half, &middle.derivative.transpose_times(d));
        slope.add_scaled(-(factor + factor), &weighted);
        let slope = scaled(one / square, &slope);

        let g = moved(&middle.g, factor, &weighted);
        for (i, row) in middle.derivative.rows().iter_mut().enumerate() {
            *row = moved(&scaled(half, row), Array::as_slice(&weighted)[i], &slope);
            entries(row)[i] += factor * Array::as_slice(&metric)[i];
        }
        Ok(Slope { g, derivative: middle.derivative })
    }
}

/// The diagonal of W. No system is known here: it is compiled once for a number of degrees of freedom.
#[inline(never)]
pub(super) fn metric<A: Array>(h: A::Real, middle: &mut Slope<A>) -> [A; 2] {
    let n = A::LEN;
    let (change, g) = (scaled(h, &turned(&middle.g)), middle.g);
    let (change, g, rows) = (Array::as_slice(&change), Array::as_slice(&g), middle.derivative.rows());
    let hessian = |i: usize, j: usize| Array::as_slice(&rows[i])[j];
    // The coordinate that is conjugate to another one.
    let partner = |i: usize| if i < n { i + n } else { i - n };
    // Times h², so that numbers are not far from 1 in any units.
    let squares = |scale: A::Real| {
        let (mut size, mut energy, mut frequency) = (zero::<A::Real>(), zero::<A::Real>(), zero::<A::Real>());
        for i in 0..2 * n {
            for j in 0..2 * n {
                let term = scale * change[i] * hessian(i, j) * change[j];
                let cycle = h * hessian(partner(i), j) * (h * hessian(partner(j), i));
                size += term.abs();
                energy += term * term;
                frequency += cycle * cycle;
            }
        }
        (size, energy, frequency)
    };
    let one = A::Real::from_f64(1.0);
    let (size, mut energy, frequency) = squares(one);
    // Energies have a unit, and may need another one.
    let scale = before_squares(size);
    if scale != one {
        energy = squares(scale).1;
    }
    let (energy, frequency) = (energy.sqrt(), frequency.sqrt());
    let mut metric = <[A; 2]>::zero();
    for (i, w) in entries(&mut metric).iter_mut().enumerate() {
        *w = length((energy * hessian(i, i)).abs(), frequency * (scale * g[i]) * g[i]);
    }
    metric
}

/// √(x² + y²) without overflow on the way; `hypot` need not give the same digits in other units.
fn length<R: Real>(x: R, y: R) -> R {
    let larger = denominator(x.max(y));
    let (x, y) = (x / larger, y / larger);
    larger * (x * x + y * y).sqrt()
}

/// The address of what is compiled once for a shape of positions.
pub(crate) fn compiled<A: Array>() -> *const () {
    metric::<A> as *const ()
}

substeps!([] Gonzalez);
