//! The projected mean velocity of `FourthOrder(DiscreteGradient)` for canonical systems x' = f(x) = J∇H(x), with x = (q, p) and J(q, p) = (p, −q).
//!
//! Emitted code implements [`FourthOrderField`](crate::system::FourthOrderField) by these functions. They evaluate H by the kernels of [`Collocation`] and
//! [`DiscreteField`], so the method needs no kernel of its own. Emitted code passes the gradients of momenta only.

use super::columns::Projector;
use super::energy::{Energy, Slope};
use super::gonzalez::metric;
use super::matrix::{Matrix, j_times};
use crate::method::Unwatched;
use crate::method::corrected::basis::Excluded;
use crate::scalar::Real;
use crate::space::vector::{difference, entries, moved, scaled, sum};
use crate::space::{Array, Square};
use crate::system::{Collocation, Conservative, DiscreteField, Span};

/// Coefficients that depend on parameters and h.
#[derive(Clone, Copy, Debug)]
pub struct Parameters<C, P, R> {
    /// Coefficients of the field f = J∇H, or of the force if H = T(p) + V(q) with a quadratic T.
    field: C,
    /// Coefficients of the tree discrete gradient.
    mean_field: P,
    h: R,
}

/// [`Parameters`] of a system.
pub type ParametersOf<S, R> = Parameters<<S as Collocation<R>>::Constants, <S as DiscreteField<R>>::Parameters, R>;

/// Start of a step: its times, the point, and f at the point.
#[derive(Clone, Copy, Debug)]
pub struct Begun<A: Array> {
    span: Span<A::Real>,
    z: [A; 2],
    rate: [A; 2],
    /// The step does not keep momenta whose gradients depend on the gradient of the energy, or on earlier momenta, in this way.
    excluded: Excluded,
}

/// Implements [`FourthOrderField::fourth_parameters`](crate::system::FourthOrderField::fourth_parameters) for a canonical system.
pub fn parameters<S: DiscreteField<R> + Conservative<R>, R: Real>(system: &S, h: R) -> ParametersOf<S, R> {
    Parameters { field: system.constants(), mean_field: system.parameters(h), h }
}

/// Implements [`FourthOrderField::fourth_begin`](crate::system::FourthOrderField::fourth_begin).
#[inline(always)]
pub fn begin<S: DiscreteField<R> + Conservative<R>, R: Real>(
    system: &S,
    parameters: &ParametersOf<S, R>,
    span: Span<R>,
    z: &S::Phase,
) -> Begun<S::Array> {
    let mut unwatched = Unwatched;
    let rate = j_times(&energy(system, parameters, span.middle, &mut unwatched).gradient(span.start, z).g);
    Begun { span, z: *z, rate, excluded: Excluded::Dependent }
}

/// Implements [`FourthOrderField::fourth_loosen`](crate::system::FourthOrderField::fourth_loosen) for a system that keeps momenta.
pub fn loosen<A: Array>(start: &mut Begun<A>) -> bool {
    start.excluded = Excluded::NearlyDependent;
    true
}

/// Implements [`FourthOrderField::fourth_slope`](crate::system::FourthOrderField::fourth_slope): writes h f̄ with f̄ = F − MG(GᵀMG)⁻¹GᵀF, and 1 − h ∂f̄/∂d.
///
/// F is the mean velocity of the Lobatto IIIA method of order 4, with the points z, c and z + d. The first of the N columns of G is the tree discrete
/// gradient of H if `AUTONOMOUS`. Otherwise it is zero, because a time-dependent H is not constant. The other columns are gradients of momenta at the
/// midpoint z + d/2. `momenta` returns these gradients at a point, and zero as its first entry. Precondition: momenta are polynomials of degree 2 at
/// most. Their gradients at the midpoint are then discrete gradients, and affine functions of d.
///
/// The length of a correction needs a metric M, because positions and momenta have different units. M is the metric of [`Gonzalez`](super::Gonzalez) at
/// the point c, with positions and momenta exchanged. With one degree of freedom the exchange inverts the metric, up to a factor.
#[inline(always)]
pub fn slope<const AUTONOMOUS: bool, const N: usize, S: DiscreteField<R> + Conservative<R>, R: Real>(
    system: &S,
    parameters: &ParametersOf<S, R>,
    &Begun { span, z, rate, excluded }: &Begun<S::Array>,
    momenta: impl Fn(&S::Phase) -> [S::Phase; N],
    d: &S::Phase,
    (image, matrix): (&mut S::Phase, &mut Square<S::Phase>),
) {
    let (h, [one, half, eighth, sixth]) = (parameters.h, [1.0, 1.0 / 2.0, 1.0 / 8.0, 1.0 / 6.0].map(R::from_f64));
    let mut unwatched = Unwatched;
    let t = span.middle;
    let mut energy = energy(system, parameters, t, &mut unwatched);
    let end_of_step = sum(&z, d);
    let end = energy.gradient(span.end, &end_of_step);
    let end_rate = j_times(&end.g);
    let change = difference(&rate, &end_rate);
    // c = z + d/2 + h/8 (f₀ − f₁).
    let at_c = energy.gradient(t, &moved(&moved(&z, half, d), eighth * h, &change));

    // F = (f₀ + 4 f(c) + f₁)/6, and its derivative, with ∂c/∂d = 1/2 − h/8 J∇²H(x₁).
    let mut velocity = sum(&rate, &end_rate);
    velocity.add_scaled(R::from_f64(4.0), &j_times(&at_c.g));
    let velocity = scaled(sixth, &velocity);
    let mut slope = j_times_matrix(&at_c.derivative);
    let (end_rows, c_rows) = (j_times_matrix(&end.derivative), slope);
    for (i, (slope, end_row)) in slope.rows().iter_mut().zip(end_rows.rows_of()).enumerate() {
        let (mut product_row, c_row) = (<S::Phase as Array>::zero(), c_rows.rows_of()[i]);
        for (entry, end_row) in Array::as_slice(&c_row).iter().zip(end_rows.rows_of()) {
            product_row.add_scaled(*entry, end_row);
        }
        let by_end = moved(&scaled(half, &c_row), -eighth * h, &product_row);
        *slope = scaled(sixth, &moved(end_row, R::from_f64(4.0), &by_end));
    }

    let mut mean = velocity;
    if AUTONOMOUS || N > 1 {
        let [of_q, of_p] = metric(h, &at_c, S::EQUATION_ORDER.is_first());
        let mut columns = momenta(&moved(&z, half, d));
        let mut tree_slope = Matrix::zero();
        if AUTONOMOUS {
            let Slope { g, derivative } = energy.tree(&z, d);
            (columns[0], tree_slope) = (g, derivative);
        }
        let projector = Projector::new([of_p, of_q], columns, excluded);
        // F does not contain the jump of H across a condition. If the metric vanishes, the projection has no direction. In both cases the step is that of
        // `DiscreteGradient`.
        if AUTONOMOUS && (projector.excludes_first() || !system.same_sides(t, [&z, &end_of_step], [&(), &()])) {
            mean = j_times(&columns[0]);
            slope = j_times_matrix(&tree_slope);
        } else {
            let weights;
            (mean, weights) = projector.projected(&velocity);
            // The derivative of an affine gradient times a vector is its linear part. The factor ½ is ∂(z + d/2)/∂d.
            projector.derivative((&mut slope, &mean), (&mut tree_slope, &weights), |z| {
                let (mut products, constant) = (momenta(z), momenta(&<S::Phase>::zero()));
                for (product, constant) in products.iter_mut().zip(&constant) {
                    *product = scaled(half, &difference(product, constant));
                }
                products
            });
        }
    }
    *image = scaled(h, &mean);
    for (i, (row, slope)) in <S::Phase>::entries::<S::Phase>(matrix).iter_mut().zip(slope.rows()).enumerate() {
        *row = scaled(-h, slope);
        entries(row)[i] += one;
    }
}

/// Returns the evaluator of the gradients of H, with the time `t` for the tree discrete gradient.
fn energy<'a, S: DiscreteField<R>, R: Real>(
    system: &'a S,
    Parameters { field, mean_field, h }: &'a ParametersOf<S, R>,
    t: R,
    probe: &'a mut Unwatched,
) -> Energy<'a, S, R, Unwatched> {
    Energy { system, field_coefficients: field, mean_field_coefficients: mean_field, probe, t, h: *h }
}

/// Returns J times a matrix.
fn j_times_matrix<A: Array>(matrix: &Matrix<A>) -> Matrix<A> {
    let (n, mut product) = (A::LEN, Matrix::zero());
    for (i, row) in matrix.rows_of().iter().enumerate() {
        match i.checked_sub(n) {
            Some(i) => product.rows()[i] = *row,
            None => product.rows()[n + i] = scaled(A::Real::from_f64(-1.0), row),
        }
    }
    product
}
