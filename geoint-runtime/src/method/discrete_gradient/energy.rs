//! The tree discrete gradient and ∇H in all coordinates x = (q, p), with their derivatives. Other discrete gradients are built on them.
//!
//! The kernels of [`DiscreteField`] return the field f = J∇H with J(q, p) = (p, −q). If H = T(p) + V(q) with a quadratic T, they return the force −∂V/∂q
//! alone. [`Energy`] completes both to gradients in all coordinates. The bound [`Conservative`] excludes damping.

use super::matrix::Matrix;
use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Observer;
use crate::space::vector::{entries, moved, opposite, sum};
use crate::space::{Array, Square};
use crate::system::{Conservative, DiscreteField, Span};

/// A gradient at x with its derivative with respect to x, or a mean of gradients between x and x + d with its derivative with respect to d.
#[derive(Clone, Copy, Debug)]
pub struct Slope<A: Array> {
    /// The gradient.
    pub g: [A; 2],
    /// ∂gᵢ/∂xⱼ or ∂gᵢ/∂dⱼ, with one row for each entry of g.
    pub derivative: Matrix<A>,
}

/// A mean gradient between x and x + d along a path with corners; see [`Energy::staircase`].
#[derive(Clone, Copy, Debug)]
pub struct Staircase<A: Array> {
    /// The mean gradient.
    pub g: [A; 2],
    /// Its derivative with respect to x, with x + d fixed.
    pub start: Matrix<A>,
    /// Its derivative with respect to x + d, with x fixed.
    pub end: Matrix<A>,
}

/// Evaluator of the gradients of H in one step. It shows each point of an evaluation to a [`Probe`]. It is not the invariant [`crate::Energy`].
#[derive(Debug)]
pub struct Energy<'a, S: DiscreteField<R>, R: Real, P> {
    pub(super) system: &'a S,
    /// Coefficients of the field f = J∇H, or of the force.
    pub(super) field_coefficients: &'a S::Constants,
    /// Coefficients of the tree discrete gradient.
    pub(super) mean_field_coefficients: &'a S::Parameters,
    pub(super) probe: &'a mut P,
    /// The time of the middle of the step, at which [`tree`](Self::tree) evaluates H.
    pub t: R,
    /// The step size.
    pub h: R,
}

impl<S: DiscreteField<R>, R: Real, P: Observer> Observer for Energy<'_, S, R, P> {
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>> Energy<'_, S, R, P> {
    /// Returns the tree discrete gradient between x and x + d at the time [`t`](Self::t), and its derivative with respect to d.
    #[inline]
    pub fn tree(&mut self, x: &S::Phase, d: &S::Phase) -> Slope<S::Array> {
        let end = sum(x, d);
        self.probe.visit(self.t, x, &());
        self.probe.visit(self.t, &end, &());
        let (y, mut mean) = S::start(x);
        let (change, impulse) = S::start(d);
        let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        let start = self.system.begin(self.mean_field_coefficients, Span::at(self.t), &y);
        self.system.slope(self.mean_field_coefficients, &start, &change, &mut f, &mut jacobian);
        let half = R::from_f64(0.5);
        mean.add_scaled(half, &impulse);
        self.gradient_of_field(&mean, half, &f, &mut jacobian)
    }

    /// Returns ∇H and the Hessian of H at the time `t` and the point x.
    #[inline]
    pub fn gradient(&mut self, t: R, x: &S::Phase) -> Slope<S::Array> {
        self.probe.visit(t, x, &());
        let (y, p) = S::start(x);
        let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        self.system.field(self.field_coefficients, t, &y, &mut f, &mut jacobian);
        self.gradient_of_field(&p, R::from_f64(1.0), &f, &mut jacobian)
    }

    /// Returns g with Jg = f, and its derivative from the `jacobian` of f.
    ///
    /// If T is quadratic, f is −∂V/∂q alone. ∂T/∂p is then computed at the momentum p, and its derivative is w·M⁻¹ with the mass matrix M. The weight w is 1
    /// for a gradient. It is ½ for a mean gradient, where p is the mean momentum p₀ + ½(p₁ − p₀), and the derivative is with respect to p₁ − p₀.
    #[inline(always)]
    fn gradient_of_field(
        &self,
        p: &S::Unknown,
        w: R,
        f: &S::Unknown,
        jacobian: &mut Square<S::Unknown>,
    ) -> Slope<S::Array> {
        let (none, n) = (S::Unknown::zero(), S::Array::LEN);
        let first_order = S::EQUATION_ORDER.is_first();
        let rate = if first_order { *f } else { self.system.velocity(self.field_coefficients, p) };
        let [rate, force] = S::increments(&rate, f);
        let mut slope = Slope { g: [opposite(&force), rate], derivative: Matrix::zero() };
        let rows = slope.derivative.rows();
        let force_rows = if first_order { n } else { 0 };
        for (i, row) in S::Unknown::entries::<S::Unknown>(jacobian).iter().enumerate() {
            let row = S::increments(row, &none);
            if i < force_rows {
                rows[n + i] = row;
            } else {
                rows[i - force_rows] = opposite(&row);
            }
        }
        if !first_order {
            for i in 0..n {
                let (mut unit, mut row) = (none, none);
                unit.as_mut_slice()[i] = R::from_f64(1.0);
                self.system.add(self.field_coefficients, w, &unit, &mut row);
                rows[n + i] = S::increments(&none, &row);
            }
        }
        slope
    }

    /// Returns the mean gradient along a path with corners from x to x + d. Each edge of the path changes the next `block` coordinates.
    ///
    /// Each entry is taken from the tree discrete gradient along the edge that changes its coordinate. With blocks of one coordinate, it is the divided
    /// difference of H, because the discrete chain rule g·d = H(x + d) − H(x) has one term. Precondition: `block` divides the number of coordinates.
    #[inline]
    pub fn staircase(&mut self, x: &S::Phase, d: &S::Phase, block: usize) -> Staircase<S::Array> {
        let mut stairs = Staircase { g: Array::zero(), start: Matrix::zero(), end: Matrix::zero() };
        let mut corner = *x;
        for first in (0..2 * S::Array::LEN).step_by(block.max(1)) {
            let moving = first..first + block;
            let mut edge = <S::Phase>::zero();
            entries(&mut edge)[moving.clone()].copy_from_slice(&Array::as_slice(d)[moving.clone()]);
            let next = moved(&corner, R::from_f64(1.0), &edge);
            // The tree discrete gradient is symmetric in both ends. The derivative of `back` is therefore the derivative with respect to `corner`.
            let mut ahead = self.tree(&corner, &edge);
            let mut back = self.tree(&next, &opposite(&edge));
            for i in moving.clone() {
                entries(&mut stairs.g)[i] = Array::as_slice(&ahead.g)[i];
                let (at_end, at_start) = (ahead.derivative.rows()[i], back.derivative.rows()[i]);
                let start = entries(&mut stairs.start.rows()[i]);
                let end = entries(&mut stairs.end.rows()[i]);
                for (j, (at_end, at_start)) in
                    Array::as_slice(&at_end).iter().zip(Array::as_slice(&at_start)).enumerate()
                {
                    if moving.contains(&j) {
                        (start[j], end[j]) = (*at_start, *at_end);
                    } else {
                        // Both corners have the same value of coordinate j: the new one if j < first, otherwise the old one.
                        let derivative = if j < first { &mut end[j] } else { &mut start[j] };
                        *derivative = *at_start + *at_end;
                    }
                }
            }
            corner = next;
        }
        stairs
    }
}
