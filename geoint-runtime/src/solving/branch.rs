//! Is a solution the one that is continuous in the step size?
//!
//! The equation x = g(x) of a step far too large has several solutions. If a method keeps an energy balance, all of them satisfy it, and none is examined. For
//! other methods this file follows the solution of x = λ g(x) from λ = 1 to λ = 0, where x = 0. For Gauss methods of autonomous systems of first order,
//! this is the solution of a step of length λh. Otherwise it is a homotopy only.

use super::distant::{Distant, Residual};
use crate::scalar::Real;
use crate::solving::size::{Sizes, Units};
use crate::solving::{linear, noise};
use crate::space::vector::{difference, moved, scaled};
use crate::space::{Array, Square};

/// The first reduction of λ, as a part of λ.
const FIRST: f64 = 1.0 / 8.0;

/// The largest and the smallest reduction.
const MOST: f64 = 1.0 / 2.0;
const LEAST: f64 = 1.0 / 4096.0;

/// A solution that is connected to x = 0 is near it for small λ, and is found from there. If Newton's iteration from x = 0 has not found it at this λ, it belongs to another
/// branch.
const END: f64 = 1e-12;

/// The most corrections of one guess.
const MOST_CORRECTIONS: u32 = 5;

/// The largest first correction, as a part of the solution, where the guess is the scaled solution at the λ before.
const NEIGHBOURING: f64 = 1.0 / 4.0;

/// Each correction is at most this part of the one before. This is a heuristic after L. V. Kantorovich (1948): such corrections indicate one solution near the guess.
const SHRINKING: f64 = 1.0 / 4.0;

/// A correction by this part of the solution is the last one.
const NEAR: f64 = 1e-6;

/// Two solutions are the same if they differ by at most this part.
const SAME: f64 = 1e-4;

/// If the rounding error of g exceeds this part of the solution, corrections may never reach `NEAR`, and a failure to follow the solution proves
/// nothing.
const HIDDEN: f64 = 1.0 / 131_072.0;

/// The equation x = λ g(x) of a step, for all λ.
pub(super) struct Continuation<'a, A> {
    /// The sizes before the step.
    pub(super) sizes: Sizes<A>,
    pub(super) units: Units,
    pub(super) equation: &'a Distant<A>,
    pub(super) residual: &'a mut dyn Residual<A>,
}

impl<A: Array> Continuation<'_, A> {
    /// Returns whether the solution of x = g(x) is connected to x = 0 by solutions of x = λ g(x), where λ falls from 1 to 0.
    ///
    /// The answer is no if the way ends, for example at a fold, or if the solution stays away from zero down to [`END`]. The answer is yes if the way leads
    /// to zero, and also if nothing is known: the equation is not defined on the way, or rounding hides the way.
    ///
    /// Newton's iteration follows the solution. E. L. Allgower & K. Georg, *Numerical Continuation Methods* (1990), section 2.
    pub(super) fn is_continuous(&mut self, solution: &A) -> bool {
        self.residual.pause(true);
        let is_continuous = self.leads_to_zero(solution);
        self.residual.pause(false);
        is_continuous
    }

    fn leads_to_zero(&mut self, solution: &A) -> bool {
        let (mut x, mut lambda, mut reduction) = (*solution, 1.0, FIRST);
        let mut has_advanced = true;
        loop {
            // Newton's iteration from x = 0, with corrections that shrink fast, leads to this solution: so does the rest of the way.
            if has_advanced
                && let Followed::To(there) = self.follow(lambda, A::zero(), 1.0)
                && self.relative(&difference(&x, &there), lambda, &there) <= SAME
            {
                return true;
            }
            let next = lambda * (1.0 - reduction);
            let guess = scaled(A::Real::from_f64(next / lambda), &x);
            let followed = self.follow(next, guess, NEIGHBOURING);
            has_advanced = matches!(followed, Followed::To(_));
            match followed {
                Followed::To(there) if next > END => {
                    (x, lambda, reduction) = (there, next, f64::min(2.0 * reduction, MOST))
                }
                Followed::Lost if reduction > LEAST => reduction *= 0.5,
                Followed::Undefined => return true,
                _ => return self.is_hidden(solution),
            }
        }
    }

    /// Returns whether the equation is rounded by more than [`HIDDEN`] of its solution `x`.
    fn is_hidden(&mut self, x: &A) -> bool {
        let mut unused = A::fill(A::zero());
        let mut sizes = self.sizes;
        sizes.include(&self.equation.origin, x);
        let noise = noise::measure(&sizes, x, (x, 1.0), self.units, |x| Some(self.residual.at(x, &mut unused)));
        let (noise, whole) = (Sizes::at(&noise).of_kinds(self.units), Sizes::at(x).of_kinds(self.units));
        (0..A::LEN).any(|i| noise.of(i) > HIDDEN * whole.of(i))
    }

    /// Solves x = λ g(x) from a guess. The first correction may be the part `most` of the solution.
    fn follow(&mut self, lambda: f64, guess: A, mut most: f64) -> Followed<A> {
        let mut x = guess;
        let (one, part) = (A::Real::from_f64(1.0), A::Real::from_f64(lambda));
        let mut matrix: Square<A> = A::fill(A::zero());
        for _ in 0..MOST_CORRECTIONS {
            // x − λ g = (1 − λ) x + λ (x − g), and its derivative.
            let residual = self.residual.at(&x, &mut matrix);
            let mut delta = moved(&scaled(one - part, &x), part, &residual);
            if !delta.is_finite() {
                return Followed::Undefined;
            }
            for (i, row) in A::entries::<A>(&mut matrix).iter_mut().enumerate() {
                *row = scaled(part, row);
                row.as_mut_slice()[i] += one - part;
            }
            let mut sizes = self.sizes;
            sizes.include(&self.equation.origin, &x);
            if linear::solve(&mut matrix, &mut delta, &sizes) != Some(true) {
                return Followed::Lost;
            }
            x = difference(&x, &delta);
            let correction = self.relative(&delta, lambda, &x);
            if correction <= NEAR {
                return Followed::To(x);
            }
            if correction > most || correction.is_nan() {
                return Followed::Lost;
            }
            most = SHRINKING * correction;
        }
        Followed::Lost
    }

    /// Returns the largest entry of `delta` relative to the largest entry of its kind in `delta`, in the solution `x`, or in the guess for λ: the solution may be
    /// zero at some λ. Positions are one kind, momenta another.
    fn relative(&self, delta: &A, lambda: f64, x: &A) -> f64 {
        let mut sizes = Sizes::at(x);
        sizes.include(&A::zero(), &scaled(A::Real::from_f64(lambda), &self.equation.guess));
        sizes.of_kinds(self.units).relative(delta, &A::zero(), &A::zero())
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
