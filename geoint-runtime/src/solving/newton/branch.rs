//! Is a solution the one that is continuous in the step size?
//!
//! An implicit equation with a step far too large has several solutions. A method that keeps the energy finds that out by the energy. For others the
//! solution is followed back to the start of the step.

use super::iteration::Iteration;
use crate::scalar::Real;
use crate::solving::equation::{Observer, StepEquation};
use crate::solving::size::Sizes;
use crate::solving::{linear, noise};
use crate::space::vector::{difference, moved, scaled};
use crate::space::{Array, Square};

/// Parts of λ by which it is reduced: the first one, the largest and the smallest one. Below `END` it is not followed.
const FIRST: f64 = 1.0 / 8.0;
const MOST: f64 = 1.0 / 2.0;
const LEAST: f64 = 1.0 / 4096.0;
const END: f64 = 1e-12;

/// Each guess may take this many corrections. The first correction of a neighbour is at most `NEIGHBOURING`, the last one at most `NEAR`, relative to the
/// largest entry of its kind. Each is at most `SHRINKING` of the one before: Newton's iteration then has one solution near the guess
/// (L. V. Kantorovich, 1948).
const MOST_CORRECTIONS: u32 = 5;
const NEIGHBOURING: f64 = 1.0 / 4.0;
const SHRINKING: f64 = 1.0 / 4.0;
const NEAR: f64 = 1e-6;

/// Two ways lead to the same solution if their ends differ by at most this part.
const SAME: f64 = 1e-4;

/// Rounding by this part of a solution hides the neighbouring solutions.
const HIDDEN: f64 = 1.0 / 131_072.0;

impl<A: Array> Iteration<A> {
    /// Returns whether the solution of x = g(x) is connected to x = 0 by solutions of x = λ g(x), where λ falls from 1 to 0.
    ///
    /// The answer is yes, too, if the equation is not defined on the way, or if rounding hides the way: nothing is known then. `sizes` are those before
    /// this step. Newton's iteration follows the solution. E. L. Allgower & K. Georg, *Numerical Continuation Methods* (1990), section 2.
    #[cold]
    #[inline(never)]
    pub(super) fn is_continuous<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &self,
        solution: A,
        sizes: &Sizes<A>,
        equation: E,
        watch: &mut W,
    ) -> bool {
        watch.pause(true);
        let (mut x, mut lambda, mut part) = (solution, 1.0, FIRST);
        let mut is_new = true;
        let is_continuous = loop {
            // Newton's iteration from nothing leads to this solution: the rest of the way need not be followed.
            if is_new
                && let Followed::To(there) = self.followed(lambda, (A::zero(), 1.0), sizes, &equation, watch)
                && self.part(&difference(&x, &there), &there) <= SAME
            {
                break true;
            }
            let next = lambda * (1.0 - part);
            let guess = scaled(A::Real::from_f64(next / lambda), &x);
            let followed = self.followed(next, (guess, NEIGHBOURING), sizes, &equation, watch);
            is_new = matches!(followed, Followed::To(_));
            match followed {
                Followed::To(there) if next > END => (x, lambda, part) = (there, next, f64::min(2.0 * part, MOST)),
                Followed::Lost if part > LEAST => part *= 0.5,
                Followed::Undefined => break true,
                _ => break self.is_hidden(solution, sizes, &equation, watch),
            }
        };
        watch.pause(false);
        is_continuous
    }

    /// Returns whether rounding of the equation hides the solutions next to `x`: the increment is hardly larger than the rounding of the forces.
    fn is_hidden<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &self,
        x: A,
        sizes: &Sizes<A>,
        equation: &E,
        watch: &mut W,
    ) -> bool {
        let mut unused = A::fill(A::zero());
        let mut sizes = *sizes;
        sizes.include(&equation.origin(), &x);
        let residual = |x: &A| Some(equation.residual(watch, x, &mut unused));
        let noise = noise::measure(&sizes, &x, (&x, 1.0), self.kinds, residual);
        let (noise, whole) = (Sizes::at(&noise).of_kinds(self.kinds), Sizes::at(&x).of_kinds(self.kinds));
        (0..A::LEN).any(|i| noise.of(i) > HIDDEN * whole.of(i))
    }

    /// Solves x = λ g(x) from a guess whose first correction is at most the part `first` of the solution.
    fn followed<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &self,
        lambda: f64,
        (guess, first): (A, f64),
        sizes: &Sizes<A>,
        equation: &E,
        watch: &mut W,
    ) -> Followed<A> {
        let (mut x, mut most) = (guess, first);
        let (one, part) = (A::Real::from_f64(1.0), A::Real::from_f64(lambda));
        let mut matrix: Square<A> = A::fill(A::zero());
        for _ in 0..MOST_CORRECTIONS {
            // x − λ g = (1 − λ) x + λ (x − g), and its derivative.
            let residual = equation.residual(watch, &x, &mut matrix);
            let mut delta = moved(&scaled(one - part, &x), part, &residual);
            if !delta.is_finite() {
                return Followed::Undefined;
            }
            for (i, row) in A::entries::<A>(&mut matrix).iter_mut().enumerate() {
                *row = scaled(part, row);
                row.as_mut_slice()[i] += one - part;
            }
            let mut sizes = *sizes;
            sizes.include(&equation.origin(), &x);
            if linear::solve(&mut matrix, &mut delta, &sizes) != Some(true) {
                return Followed::Lost;
            }
            x = difference(&x, &delta);
            let correction = self.part(&delta, &x);
            if correction <= NEAR {
                return Followed::To(x);
            }
            if !(correction <= most) {
                return Followed::Lost;
            }
            most = SHRINKING * correction;
        }
        Followed::Lost
    }

    /// Returns the largest entry of `delta` relative to the largest entry of its kind in `x` or in `delta`.
    fn part(&self, delta: &A, x: &A) -> f64 {
        Sizes::at(x).of_kinds(self.kinds).relative(delta, &A::zero(), &A::zero())
    }
}

/// Where the solution of x = λ g(x) is.
enum Followed<A> {
    To(A),
    /// Not near the guess, if anywhere.
    Lost,
    /// The equation is not defined there.
    Undefined,
}
