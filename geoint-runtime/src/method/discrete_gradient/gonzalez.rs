//! The midpoint discrete gradient of Gonzalez (1996): ∇H at the midpoint, with a correction along the increment in a metric that does not depend on units.

use super::energy::{Energy, Slope};
use super::matrix::j_times;
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::{Failure, Name, Probe};
use crate::scalar::{Real, zero};
use crate::slope::before_squares;
use crate::space::Array;
use crate::space::vector::{difference, dot, entries, moved, product, scaled};
use crate::system::{Conservative, DiscreteField};

/// x₁ = x₀ + h J g with g = ∇H(m) + (H(x₁) − H(x₀) − ∇H(m)·d)/(d·Wd) Wd, where m is the midpoint and d = x₁ − x₀. Here
/// x = (q, p) and J(q, p) = (p, −q). Accepted steps keep the energy to rounding for every h, if H does not read time.
///
/// Order 2, symmetric, for every H. H(x₁) − H(x₀) is the product of d with the gradient of [`DiscreteGradient`](crate::DiscreteGradient). A difference
/// of two energies would lose digits in short steps. O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449, with W = 1.
///
/// The metric W is a choice. The length √(d·Wd) needs a metric, because positions and momenta, or lengths and angles, have different units. With W = 1,
/// as published, the step depends on the units. Here W is diagonal, with wᵢ² = (ε Hᵢᵢ)² + (ω ∂H/∂xᵢ)⁴ at the point m. Hᵢⱼ are the second derivatives
/// of H, and ẋ = J∇H. The scales are ε² = Σ(ẋᵢHᵢⱼẋⱼ)² and ω⁴ = Σ(FᵢⱼFⱼᵢ)² with F = J∇²H. The unit of ε is that of H/time², and the unit of ω is that of
/// a frequency. All terms wᵢdᵢ² therefore have one unit.
///
/// For one oscillator, w is the stiffness for q and the reciprocal mass for p, times factors with a ratio between 1/√3 and √3. For a coordinate that H
/// does not read, w is zero, and its momentum is kept. W is not invariant under rotations of the axes. If d·Wd = 0, as in front of a jump of a constant
/// potential, g is the gradient of `DiscreteGradient`.
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
    ) -> Result<Slope<S::Array>, Failure> {
        let (one, half) = (R::from_f64(1.0), R::from_f64(0.5));
        let mut tree = energy.tree(x, d);
        let mut middle = energy.gradient(energy.t, &moved(x, half, d));
        let metric = metric(energy.h, &middle, S::EQUATION_ORDER.is_first());
        let weighted = product(&metric, d);
        let square = dot(&weighted, d);
        if square == zero() {
            // The correction along W d is then 0/0. If the energy jumps between the ends, only the tree discrete gradient contains the jump.
            return Ok(tree);
        }
        let excess = difference(&tree.g, &middle.g);
        let factor = dot(&excess, d) / square;

        // The derivative of W is omitted. Its term is of higher order, and equal for both ends, so it cancels in the matrix Q of `FourthOrder`.
        let mut factor_slope = moved(&excess, one, &tree.derivative.transpose_times(d));
        factor_slope.add_scaled(-half, &middle.derivative.transpose_times(d));
        factor_slope.add_scaled(-(factor + factor), &weighted);
        let factor_slope = scaled(one / square, &factor_slope);

        let g = moved(&middle.g, factor, &weighted);
        for (i, row) in middle.derivative.rows().iter_mut().enumerate() {
            *row = moved(&scaled(half, row), Array::as_slice(&weighted)[i], &factor_slope);
            entries(row)[i] += factor * Array::as_slice(&metric)[i];
        }
        Ok(Slope { g, derivative: middle.derivative })
    }
}

/// Returns the diagonal of W, up to a common factor, from the step size h, and from ∇H and ∇²H at the point `middle`. `coupled` is true if ∂²H/∂q∂p may
/// be nonzero. The function does not depend on the system, so it is compiled once for each number of degrees of freedom.
#[inline(never)]
pub(super) fn metric<A: Array>(h: A::Real, middle: &Slope<A>, coupled: bool) -> [A; 2] {
    let one = A::Real::from_f64(1.0);
    let [_, square, half_quartic] = squares(h, middle, coupled, one);
    let (mut scale, mut energy) = (one, square.sqrt());
    // Energies need another unit if their squares lose digits, vanish, or overflow.
    let is_number = energy.magnitude() > 0.0 && energy.magnitude().is_finite();
    if !is_number || before_squares(energy) != one {
        (scale, energy) = rescaled_energy(h, middle, coupled);
    }
    // (hω)².
    let frequency_square = (half_quartic + half_quartic).sqrt();
    let (mut metric, rows) = (<[A; 2]>::zero(), middle.derivative.rows_of());
    for (i, (w, g)) in entries(&mut metric).iter_mut().zip(Array::as_slice(&middle.g)).enumerate() {
        *w = length((energy * Array::as_slice(&rows[i])[i]).abs(), frequency_square * (scale * *g) * *g);
    }
    metric
}

/// Returns a power of two by which energies are multiplied so that h²ε keeps all its digits, and the product of this power with h²ε.
#[cold]
#[inline(never)]
fn rescaled_energy<A: Array>(h: A::Real, middle: &Slope<A>, coupled: bool) -> (A::Real, A::Real) {
    let [size, ..] = squares(h, middle, coupled, A::Real::from_f64(1.0));
    let scale = before_squares(size);
    let [_, square, _] = squares(h, middle, coupled, scale);
    (scale, square.sqrt())
}

/// Returns Σ|ẋᵢHᵢⱼẋⱼ|, ε² = Σ(ẋᵢHᵢⱼẋⱼ)² and ω⁴/2 = Σ(FᵢⱼFⱼᵢ)²/2, where each pair of blocks of F = J∇²H enters once. Energies are multiplied by
/// `scale`, and 1/time by h: ẋ becomes hẋ, and F becomes hF. Numbers are then near 1 in all units.
#[inline(always)]
fn squares<A: Array>(h: A::Real, middle: &Slope<A>, coupled: bool, scale: A::Real) -> [A::Real; 3] {
    let (n, change, rows) = (A::LEN, scaled(h, &j_times(&middle.g)), middle.derivative.rows_of());
    let (of_q, of_p) = Array::as_slice(&change).split_at(n);
    let hessian = |i: usize, j: usize| Array::as_slice(&rows[i])[j];
    let (mut size, mut square, mut half_quartic) = (zero::<A::Real>(), zero::<A::Real>(), zero::<A::Real>());
    let mut add = |term: A::Real| (size, square) = (size + term.abs(), square + term * term);
    for a in 0..n {
        for b in 0..n {
            let [of_qq, of_pp] = [hessian(a, b), hessian(n + a, n + b)];
            add(scale * of_q[a] * of_qq * of_q[b]);
            add(scale * of_p[a] * of_pp * of_p[b]);
            let cycle = h * of_qq * (h * of_pp);
            half_quartic += cycle * cycle;
            if coupled {
                let of_qp = hessian(a, n + b);
                let term = scale * of_q[a] * of_qp * of_p[b];
                add(term);
                add(term);
                let cycle = h * of_qp * (h * hessian(b, n + a));
                half_quartic += cycle * cycle;
            }
        }
    }
    [size, square, half_quartic]
}

/// Returns √(x² + y²) without overflow on the way. Precondition: x and y are not negative. `hypot` is not used, because its rounding may depend on units.
#[inline(always)]
fn length<R: Real>(x: R, y: R) -> R {
    let (scale, one) = (before_squares(x + y), R::from_f64(1.0));
    if scale == one {
        return (x * x + y * y).sqrt();
    }
    let (x, y) = (scale * x, scale * y);
    (x * x + y * y).sqrt() / scale
}

/// Returns the address of [`metric`] for a shape of positions. This crate then compiles it for usual shapes, and programs need not.
pub(crate) fn compiled<A: Array>() -> *const () {
    metric::<A> as *const ()
}

substeps!([] Gonzalez);
