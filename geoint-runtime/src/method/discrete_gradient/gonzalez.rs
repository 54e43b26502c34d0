//! Gradient at the midpoint, corrected along the increment.

use super::energy::{Energy, Slope};
use super::matrix::turned;
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::{Name, Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::slope::before_squares;
use crate::space::Array;
use crate::space::vector::{difference, dot, entries, moved, product, scaled};
use crate::system::{Conservative, DiscreteField};

/// x₁ = x₀ + h J g with g = ∇H(m) + (H(x₁) − H(x₀) − ∇H(m)·d)/(d·Wd) Wd, where m is the midpoint and d = x₁ − x₀. The energy is kept to rounding for
/// every h.
///
/// Order 2, symmetric, for every H. H(x₁) − H(x₀) is taken from the tree discrete gradient, not from a difference, so that short steps lose no digits.
/// O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449, with W = 1.
///
/// The metric W is a choice. Lengths of d need a metric, because positions and momenta, or lengths and angles, have different units. With W = 1, as
/// published, the step depends on the units. Here W is diagonal, wᵢ² = (ε Hᵢᵢ)² + (ω ∂H/∂xᵢ)⁴, taken at m with ε² = Σ(ẋᵢHᵢⱼẋⱼ)² and ω⁴ = Σ(FᵢⱼFⱼᵢ)²,
/// F = J∇²H. These are energies in place of lengths. For an oscillator wᵢ is the stiffness or the reciprocal mass, up to a factor. For a cyclic
/// coordinate wᵢ is zero, so that its momentum is kept. W changes if the axes are rotated. If d·Wd = 0, as in front of a jump of a constant potential,
/// g is the tree discrete gradient itself.
#[doc(alias = "midpoint discrete gradient")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gonzalez;

impl MeanGradient for Gonzalez {
    const OF_ENERGIES: bool = true;

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
        let metric = metric(energy.h, &middle, S::DERIVATIVE == 1);
        let weighted = product(&metric, d);
        let square = dot(&weighted, d);
        if square == zero() {
            // A correction along W d vanishes, and the energy may have jumped between the ends.
            return Ok(tree);
        }
        let excess = difference(&tree.g, &middle.g);
        let factor = dot(&excess, d) / square;

        // ∂factor/∂d. The derivative of W adds a term of higher order, which is equal from both ends.
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

/// Computes the diagonal of W. `coupled` is true if ∂²H/∂q∂p need not be zero. The function has no system as a parameter, so it is compiled once for a
/// number of degrees of freedom.
#[inline(never)]
pub(super) fn metric<A: Array>(h: A::Real, middle: &Slope<A>, coupled: bool) -> [A; 2] {
    let one = A::Real::from_f64(1.0);
    let [_, energy, cycles] = squares(h, middle, coupled, one);
    let (mut scale, mut energy) = (one, energy.sqrt());
    // Energies may need another unit, also if their squares vanish or are infinite.
    let is_number = energy.magnitude() > 0.0 && energy.magnitude().is_finite();
    if !is_number || before_squares(energy) != one {
        (scale, energy) = in_their_unit(h, middle, coupled);
    }
    let frequency = (cycles + cycles).sqrt();
    let (mut metric, rows) = (<[A; 2]>::zero(), middle.derivative.rows_of());
    for (i, (w, g)) in entries(&mut metric).iter_mut().zip(Array::as_slice(&middle.g)).enumerate() {
        *w = length((energy * Array::as_slice(&rows[i])[i]).abs(), frequency * (scale * *g) * *g);
    }
    metric
}

/// Returns the factor of a unit in which ε has all its digits, and ε in this unit.
#[cold]
#[inline(never)]
fn in_their_unit<A: Array>(h: A::Real, middle: &Slope<A>, coupled: bool) -> (A::Real, A::Real) {
    let [size, ..] = squares(h, middle, coupled, A::Real::from_f64(1.0));
    let scale = before_squares(size);
    let [_, energy, _] = squares(h, middle, coupled, scale);
    (scale, energy.sqrt())
}

/// Computes Σ|ẋᵢHᵢⱼẋⱼ|, ε² = Σ(ẋᵢHᵢⱼẋⱼ)² and ω⁴/2 = Σ(FᵢⱼFⱼᵢ)²/2, with each pair of blocks of F = J∇²H once. Energies are multiplied by `scale`, and
/// all numbers by powers of h, so that numbers are not far from 1 in any units.
#[inline(always)]
fn squares<A: Array>(h: A::Real, middle: &Slope<A>, coupled: bool, scale: A::Real) -> [A::Real; 3] {
    let (n, change, rows) = (A::LEN, scaled(h, &turned(&middle.g)), middle.derivative.rows_of());
    let (of_q, of_p) = Array::as_slice(&change).split_at(n);
    let hessian = |i: usize, j: usize| Array::as_slice(&rows[i])[j];
    let (mut size, mut energy, mut cycles) = (zero::<A::Real>(), zero::<A::Real>(), zero::<A::Real>());
    let mut add = |term: A::Real| (size, energy) = (size + term.abs(), energy + term * term);
    for a in 0..n {
        for b in 0..n {
            let [of_qq, of_pp] = [hessian(a, b), hessian(n + a, n + b)];
            add(scale * of_q[a] * of_qq * of_q[b]);
            add(scale * of_p[a] * of_pp * of_p[b]);
            let cycle = h * of_qq * (h * of_pp);
            cycles += cycle * cycle;
            if coupled {
                let of_qp = hessian(a, n + b);
                let term = scale * of_q[a] * of_qp * of_p[b];
                add(term);
                add(term);
                let cycle = h * of_qp * (h * hessian(b, n + a));
                cycles += cycle * cycle;
            }
        }
    }
    [size, energy, cycles]
}

/// Returns √(x² + y²) of numbers that are not negative, without overflow on the way. `hypot` need not give equal digits in other units.
#[inline(always)]
fn length<R: Real>(x: R, y: R) -> R {
    let (scale, one) = (before_squares(x + y), R::from_f64(1.0));
    if scale == one {
        return (x * x + y * y).sqrt();
    }
    let (x, y) = (scale * x, scale * y);
    (x * x + y * y).sqrt() / scale
}

/// Returns the address of the code that is compiled once for a shape of positions.
pub(crate) fn compiled<A: Array>() -> *const () {
    metric::<A> as *const ()
}

substeps!([] Gonzalez);
