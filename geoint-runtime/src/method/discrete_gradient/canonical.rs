//! Mean velocity of order 4 for canonical systems, from the kernels of collocation and of discrete gradients.

use super::columns::Projector;
use super::energy::{Energy, Slope};
use super::gonzalez::metric;
use super::matrix::{Matrix, turned};
use crate::method::Unwatched;
use crate::scalar::Real;
use crate::space::vector::{difference, entries, moved, scaled, sum};
use crate::space::{Array, Square};
use crate::system::{Collocation, Conservative, DiscreteField, Span};

/// Coefficients that depend on parameters and h.
#[derive(Clone, Copy, Debug)]
pub struct Parameters<C, P, R> {
    constants: C,
    kernel: P,
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
    /// If true, momenta take no part if their gradients nearly depend on the gradient of the energy.
    loose: bool,
}

/// Implements [`FourthOrderField::fourth_parameters`](crate::system::FourthOrderField::fourth_parameters) for a canonical system.
pub fn parameters<S: DiscreteField<R> + Conservative<R>, R: Real>(system: &S, h: R) -> ParametersOf<S, R> {
    Parameters { constants: system.constants(), kernel: system.parameters(h), h }
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
    let rate = turned(&energy(system, parameters, span.middle, &mut unwatched).gradient(span.start, z).g);
    Begun { span, z: *z, rate, loose: false }
}

/// Implements [`FourthOrderField::fourth_loosen`](crate::system::FourthOrderField::fourth_loosen).
pub fn loosen<A: Array>(start: &mut Begun<A>) -> bool {
    start.loose = true;
    true
}

/// Implements [`FourthOrderField::fourth_slope`](crate::system::FourthOrderField::fourth_slope): F − MG(GᵀMG)⁻¹GᵀF. The first column of G is the tree
/// discrete gradient of an `AUTONOMOUS` H. The other columns are gradients of momenta in the middle of the step. `momenta` returns these affine
/// gradients at a point, behind an entry that is not read.
///
/// Lengths of a correction need a metric M, because positions and momenta have different units. M is the metric of [`Gonzalez`](super::Gonzalez) at the
/// point c, with positions and momenta exchanged. For an oscillator the exchange gives the inverse metric.
#[inline(always)]
pub fn slope<const AUTONOMOUS: bool, const N: usize, S: DiscreteField<R> + Conservative<R>, R: Real>(
    system: &S,
    parameters: &ParametersOf<S, R>,
    &Begun { span, z, rate, loose }: &Begun<S::Array>,
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
    let end_rate = turned(&end.g);
    let change = difference(&rate, &end_rate);
    let third = energy.gradient(t, &moved(&moved(&z, half, d), eighth * h, &change));

    // F = (f₀ + 4 f(c) + f₁)/6 with f = J∇H, and its derivative, with ∂c/∂d = 1/2 − h/8 J∇²H₁.
    let mut velocity = sum(&rate, &end_rate);
    velocity.add_scaled(R::from_f64(4.0), &turned(&third.g));
    let velocity = scaled(sixth, &velocity);
    let mut slope = turned_rows(&third.derivative);
    let (end_rows, by_third) = (turned_rows(&end.derivative), slope);
    for (i, (slope, end_row)) in slope.rows().iter_mut().zip(end_rows.rows_of()).enumerate() {
        let (mut along, bent) = (<S::Phase as Array>::zero(), by_third.rows_of()[i]);
        for (bent, end_row) in Array::as_slice(&bent).iter().zip(end_rows.rows_of()) {
            along.add_scaled(*bent, end_row);
        }
        let by_end = moved(&scaled(half, &bent), -eighth * h, &along);
        *slope = scaled(sixth, &moved(end_row, R::from_f64(4.0), &by_end));
    }

    let mut mean = velocity;
    if AUTONOMOUS || N > 1 {
        let [of_q, of_p] = metric(h, &third, S::DERIVATIVE == 1);
        let mut columns = momenta(&moved(&z, half, d));
        let mut of_g = Matrix::zero();
        if AUTONOMOUS {
            let Slope { g, derivative } = energy.tree(&z, d);
            (columns[0], of_g) = (g, derivative);
        }
        let projector = Projector::new([of_p, of_q], columns, loose);
        // Across a condition, F contains no jump. If the metric vanishes, no direction exists. In both cases the step uses the tree discrete gradient.
        if AUTONOMOUS && (projector.is_without_first() || !system.same_sides(t, [&z, &end_of_step], [&(), &()])) {
            mean = turned(&columns[0]);
            slope = turned_rows(&of_g);
        } else {
            let weights;
            (mean, weights) = projector.projected(&velocity);
            projector.derivative((&mut slope, &mean), (&mut of_g, &weights), |z| {
                let (mut bent, constant) = (momenta(z), momenta(&<S::Phase>::zero()));
                for (bent, constant) in bent.iter_mut().zip(&constant) {
                    *bent = scaled(half, &difference(bent, constant));
                }
                bent
            });
        }
    }
    *image = scaled(h, &mean);
    for (i, (row, slope)) in <S::Phase>::entries::<S::Phase>(matrix).iter_mut().zip(slope.rows()).enumerate() {
        *row = scaled(-h, slope);
        entries(row)[i] += one;
    }
}

fn energy<'a, S: DiscreteField<R>, R: Real>(
    system: &'a S,
    Parameters { constants, kernel, h }: &'a ParametersOf<S, R>,
    t: R,
    probe: &'a mut Unwatched,
) -> Energy<'a, S, R, Unwatched> {
    Energy { system, constants, parameters: kernel, probe, t, h: *h }
}

/// Returns J times a matrix.
fn turned_rows<A: Array>(matrix: &Matrix<A>) -> Matrix<A> {
    let (n, mut product) = (A::LEN, Matrix::zero());
    for (i, row) in matrix.rows_of().iter().enumerate() {
        match i.checked_sub(n) {
            Some(i) => product.rows()[i] = *row,
            None => product.rows()[n + i] = scaled(A::Real::from_f64(-1.0), row),
        }
    }
    product
}
