//! Is a solution that was found from afar the one that begins with the step?

use super::iteration::Iteration;
use crate::scalar::Real;
use crate::solving::equation::{Observer, StepEquation};
use crate::solving::linear;
use crate::space::vector::{difference, moved, scaled};
use crate::space::{Array, Square};

/// The first part by which the right side of the equation is made smaller, and the smallest one.
const FIRST: f64 = 1.0 / 8.0;
const LEAST: f64 = 1.0 / 4096.0;

/// Corrections on the way that follow a guess, by what part they have to shrink, and how small the last one has to be.
const MOST_CORRECTIONS: u32 = 5;
const SHRINKING: f64 = 0.25;
const NEAR: f64 = 1e-6;

impl<A: Array> Iteration<A> {
    /// Returns whether the solution `x` of x = g(x) leads back to zero through solutions of x = λ g(x), as λ goes from 1 to 0: it is then the one that grows
    /// from nothing with the force of the step. Of an equation that is not defined on the way nothing is known, and the answer is yes.
    ///
    /// Newton's iteration follows the solution. E. L. Allgower & K. Georg, *Numerical Continuation Methods* (1990), section 2.
    #[cold]
    #[inline(never)]
    pub(super) fn grows_from_nothing<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &self,
        solution: A,
        equation: E,
        watch: &mut W,
    ) -> bool {
        let (mut x, mut lambda, mut part) = (solution, 1.0, FIRST);
        watch.pause(true);
        let grows = loop {
            if lambda == 0.0 {
                break true;
            }
            let next = f64::max(lambda - part, 0.0);
            match self.followed(scaled(A::Real::from_f64(next / lambda), &x), next, &equation, watch) {
                Followed::To(there) => (x, lambda, part) = (there, next, 2.0 * part),
                Followed::Undefined => break true,
                Followed::Lost if part > LEAST => part *= 0.5,
                Followed::Lost => break false,
            }
        };
        watch.pause(false);
        grows
    }

    /// The solution of x = λ g(x) near a guess.
    fn followed<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &self,
        guess: A,
        lambda: f64,
        equation: &E,
        watch: &mut W,
    ) -> Followed<A> {
        let (origin, mut x, mut before) = (equation.origin(), guess, f64::INFINITY);
        let one = A::Real::from_f64(1.0);
        for _ in 0..MOST_CORRECTIONS {
            let mut matrix: Square<A> = A::fill(A::zero());
            let residual = equation.residual(watch, &x, &mut matrix);
            if !residual.is_finite() {
                return Followed::Undefined;
            }
            // x − λ g, and 1 − λ g'.
            let part = A::Real::from_f64(lambda);
            let mut delta = moved(&scaled(one - part, &x), part, &residual);
            for (i, row) in A::entries::<A>(&mut matrix).iter_mut().enumerate() {
                *row = scaled(part, row);
                row.as_mut_slice()[i] += one - part;
            }
            let mut sizes = self.sizes;
            sizes.include(&origin, &x);
            if linear::solve(&mut matrix, &mut delta, &sizes) != Some(true) {
                return Followed::Lost;
            }
            x = difference(&x, &delta);
            let correction = sizes.relative(&delta, &origin, &x);
            if correction <= NEAR {
                return Followed::To(x);
            }
            // The first one may be large beside the state, but not beside the way.
            if !(correction <= SHRINKING * before) {
                return Followed::Lost;
            }
            before = correction;
        }
        Followed::Lost
    }
}

/// Where the solution of a part of the equation is.
enum Followed<A> {
    To(A),
    /// Not near the guess, if anywhere.
    Lost,
    /// The equation is not defined there.
    Undefined,
}
