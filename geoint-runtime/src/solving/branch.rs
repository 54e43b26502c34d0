//! Decides whether a solution is the one that is continuous in the step size h.
//!
//! The equation x = g(x) of a step far too large has several solutions. If a method keeps an energy balance, all solutions satisfy it, and none is examined.
//! For other methods this file follows the solution of x = λ g(x) from λ = 1 to λ = 0, where x = 0. For Gauss methods of autonomous systems of first order,
//! x(λ) is the solution of a step of length λh. Otherwise it is a homotopy only.
//!
//! λ falls by growing factors. The guess at the next λ' is (λ'/λ) x, and Newton's iteration corrects it. Limit: the constants are heuristics, not proofs.

use super::distant::{Distant, Residual};
use crate::scalar::Real;
use crate::solving::size::{Sizes, Units};
use crate::solving::{linear, noise};
use crate::space::vector::{difference, moved, scaled};
use crate::space::{Array, Square};

/// The first reduction of λ, as a part of λ. A reduction doubles after a success and is halved after a failure, so its first value matters little.
const FIRST_REDUCTION: f64 = 1.0 / 8.0;

/// The largest reduction, as a part of λ. Guesses are worse for larger reductions.
const LARGEST_REDUCTION: f64 = 1.0 / 2.0;

/// The way ends if a reduction by this part of λ fails. A smaller value would follow the solution closer to a fold, with more evaluations.
const SMALLEST_REDUCTION: f64 = 1.0 / 4096.0;

/// A connected solution is near x = 0 for small λ. A solution that Newton's iteration from x = 0 has not found at this λ belongs to another branch.
const LAST_LAMBDA: f64 = 1e-12;

/// The most corrections of one guess. A guess that needs more is a failure, and λ is reduced by less.
const MOST_CORRECTIONS: u32 = 5;

/// The largest first correction of a guess (λ'/λ) x, as a part of the solution. A larger one might lead to another branch.
const FIRST_CORRECTION_LIMIT: f64 = 1.0 / 4.0;

/// Each correction is at most this part of the one before. Corrections that shrink in this way indicate one solution near the guess: a heuristic after L. V.
/// Kantorovich (1948).
const CONTRACTION_LIMIT: f64 = 1.0 / 4.0;

/// A correction by at most this part of the solution is the last one: about 8 ε of `f32`. A rough solution is enough to choose the branch.
const LAST_CORRECTION: f64 = 1e-6;

/// Two solutions are the same if they differ by at most this part: a hundred times [`LAST_CORRECTION`].
const SAME: f64 = 1e-4;

/// If the rounding error of g exceeds this part of the solution, a failure to follow the solution proves nothing. The part is 64 ε of `f32`.
///
/// It is above [`LAST_CORRECTION`]. Rounding between both may also keep corrections from shrinking. The step is then refused, which is the safe error.
const NOISE_LIMIT: f64 = 1.0 / 131_072.0;

/// The equation x = λ g(x) of a step, for all λ.
pub(super) struct Continuation<'a, A> {
    /// The sizes before the step.
    pub(super) sizes: Sizes<A>,
    /// The kinds of the unknowns.
    pub(super) units: Units,
    pub(super) equation: &'a Distant<A>,
    pub(super) residual: &'a mut dyn Residual<A>,
}

impl<A: Array> Continuation<'_, A> {
    /// Returns whether the solution of x = g(x) is connected to x = 0 by solutions of x = λ g(x), where λ falls from 1 to 0.
    ///
    /// The answer is no if the way ends, for example at a fold, or if the solution stays away from zero down to [`LAST_LAMBDA`]. The answer is yes if the way
    /// leads to zero, and also if nothing is known: the equation is not defined on the way, or its rounding exceeds [`NOISE_LIMIT`].
    ///
    /// E. L. Allgower & K. Georg, *Numerical Continuation Methods* (1990), section 2.
    pub(super) fn is_continuous(&mut self, solution: &A) -> bool {
        self.residual.pause(true);
        let is_continuous = self.leads_to_zero(solution);
        self.residual.pause(false);
        is_continuous
    }

    /// Returns the answer of [`is_continuous`](Self::is_continuous).
    fn leads_to_zero(&mut self, solution: &A) -> bool {
        let (mut x, mut lambda, mut reduction) = (*solution, 1.0, FIRST_REDUCTION);
        let mut has_advanced = true;
        loop {
            // If Newton's iteration from x = 0 finds this solution with corrections that shrink fast, the rest of the way is assumed to lead to zero.
            if has_advanced
                && let Followed::To(there) = self.follow(lambda, A::zero(), 1.0)
                && self.relative(&difference(&x, &there), lambda, &there) <= SAME
            {
                return true;
            }
            let next = lambda * (1.0 - reduction);
            let guess = scaled(A::Real::from_f64(next / lambda), &x);
            let followed = self.follow(next, guess, FIRST_CORRECTION_LIMIT);
            has_advanced = matches!(followed, Followed::To(_));
            match followed {
                Followed::To(there) if next > LAST_LAMBDA => {
                    (x, lambda, reduction) = (there, next, f64::min(2.0 * reduction, LARGEST_REDUCTION))
                }
                Followed::NotFound if reduction > SMALLEST_REDUCTION => reduction *= 0.5,
                Followed::Undefined => return true,
                _ => return self.is_noisy(solution),
            }
        }
    }

    /// Returns whether the rounding of an entry of the residual exceeds the part [`NOISE_LIMIT`] of the largest entry of its kind in the solution `x`.
    fn is_noisy(&mut self, x: &A) -> bool {
        let mut unused = A::fill(A::zero());
        let mut sizes = self.sizes;
        sizes.include(&self.equation.origin, x);
        let noise = noise::measure(&sizes, x, (x, 1.0), self.units, |x| Some(self.residual.at(x, &mut unused)));
        let (noise, whole) = (Sizes::at(&noise).of_kinds(self.units), Sizes::at(x).of_kinds(self.units));
        (0..A::LEN).any(|i| noise.of(i) > NOISE_LIMIT * whole.of(i))
    }

    /// Solves x = λ g(x) from a guess. The first correction may be at most the part `most` of the solution.
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
                return Followed::NotFound;
            }
            x = difference(&x, &delta);
            let correction = self.relative(&delta, lambda, &x);
            if correction <= LAST_CORRECTION {
                return Followed::To(x);
            }
            if correction > most || correction.is_nan() {
                return Followed::NotFound;
            }
            most = CONTRACTION_LIMIT * correction;
        }
        Followed::NotFound
    }

    /// Returns the largest entry of `delta` relative to its size, at most 1. The size of an entry is the largest one of its kind in the solution `x` or in
    /// λ·guess, because the solution may be zero at some λ. Positions are one kind, momenta another.
    fn relative(&self, delta: &A, lambda: f64, x: &A) -> f64 {
        let mut sizes = Sizes::at(x);
        sizes.include(&A::zero(), &scaled(A::Real::from_f64(lambda), &self.equation.guess));
        sizes.of_kinds(self.units).relative(delta, &A::zero(), &A::zero())
    }
}

/// The solution of x = λ g(x) near a guess.
enum Followed<A> {
    /// The solution.
    To(A),
    /// No solution is near the guess, or its determinant is not positive.
    NotFound,
    /// The equation is not defined there.
    Undefined,
}
