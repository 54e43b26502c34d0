//! Tests whether a solution of a step of length h belongs to the solutions that are continuous in h from h = 0 on.
//!
//! The equation r(x) = x − g(x) = 0 of a step far too large may have several solutions. If all of them satisfy the energy balance of the method, `rescue` tests
//! none. Otherwise this file follows the solution of x = λ g(x) from λ = 1 to λ = 0, where x = 0. For Gauss methods of y' = f(y), whose unknowns are rates,
//! x(λ) is λ times the solution of a step of length λh. For other equations λ is no step length, and only connects x with 0.
//!
//! λ falls by growing factors. The guess at the next λ' is (λ'/λ) x, and Newton's iteration corrects it. Limit: a test and no proof, with heuristic constants.

use super::distant::{Distant, Residual};
use crate::scalar::Real;
use crate::solving::noise::LastCorrection;
use crate::solving::size::{Sizes, Units};
use crate::solving::{linear, noise};
use crate::space::vector::{difference, moved, scaled};
use crate::space::{Array, Square};

/// The first reduction of λ, as a part of λ. A reduction doubles after a success and is halved after a failure, so its first value matters little.
const FIRST_REDUCTION: f64 = 1.0 / 8.0;

/// The largest reduction, as a part of λ. Guesses are worse for larger reductions.
const LARGEST_REDUCTION: f64 = 1.0 / 2.0;

/// If a reduction by this part of λ fails, the solutions are taken to end there. A smaller value would follow them closer to a fold, with more evaluations.
const SMALLEST_REDUCTION: f64 = 1.0 / 4096.0;

/// A connected solution is near x = 0 for small λ. If Newton's iteration from x = 0 has not found the solution at any λ down to this one, it is taken to
/// belong to another branch.
const LAST_LAMBDA: f64 = 1e-12;

/// The most corrections of one guess. A guess that needs more is a failure, and λ is reduced by less.
const MOST_CORRECTIONS: u32 = 5;

/// The largest first correction of a guess (λ'/λ) x, as a part of the solution. A larger correction might lead to another branch.
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
/// Limit: rounding between [`LAST_CORRECTION`] and this part may also keep corrections from shrinking. The step is then refused, which is the safe error.
const NOISE_LIMIT: f64 = 1.0 / 131_072.0;

/// The equation x = λ g(x) of a step, for all λ.
pub(super) struct Continuation<'a, A> {
    /// The sizes before the step.
    pub(super) sizes: Sizes<A>,
    pub(super) units: Units,
    pub(super) equation: &'a Distant<A>,
    /// r(x) = x − g(x).
    pub(super) residual: &'a mut dyn Residual<A>,
}

impl<A: Array> Continuation<'_, A> {
    /// Returns whether the test connects the solution of x = g(x) with x = 0 by solutions of x = λ g(x), where λ falls from 1 to 0.
    ///
    /// Returns `false` if these solutions end, for example at a fold, or if they stay away from zero down to [`LAST_LAMBDA`]. Returns `true` also if the test
    /// decides nothing: the equation is not defined at a point of an iteration, or its rounding exceeds [`NOISE_LIMIT`].
    ///
    /// E. L. Allgower & K. Georg, *Numerical Continuation Methods* (1990), section 2.
    pub(super) fn is_continuous(&mut self, solution: &A) -> bool {
        self.residual.pause(true);
        let is_continuous = self.leads_to_zero(solution);
        self.residual.pause(false);
        is_continuous
    }

    /// Returns the result of [`is_continuous`](Self::is_continuous). Precondition: the observer is paused.
    fn leads_to_zero(&mut self, solution: &A) -> bool {
        let (mut x, mut lambda, mut reduction) = (*solution, 1.0, FIRST_REDUCTION);
        let mut has_advanced = true;
        loop {
            // If Newton's iteration from x = 0 finds the solution at this λ, solutions at smaller λ are assumed to lead to zero.
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

    /// Returns whether the rounding of an entry of the residual exceeds the part [`NOISE_LIMIT`] of the largest entry of its kind in the solution `x`. The
    /// measurement takes `x` in place of a last correction.
    fn is_noisy(&mut self, x: &A) -> bool {
        let mut unused = A::fill(A::zero());
        let mut sizes = self.sizes;
        sizes.include(&self.equation.origin, x);
        let last = LastCorrection { delta: *x, multiple: 1.0 };
        let noise = noise::measure(&sizes, x, last, self.units, |x| Some(self.residual.at(x, &mut unused)));
        let (noise, whole) = (Sizes::at(&noise).of_kinds(self.units), Sizes::at(x).of_kinds(self.units));
        (0..A::LEN).any(|i| noise.of(i) > NOISE_LIMIT * whole.of(i))
    }

    /// Solves x = λ g(x) from a guess. The first correction may be at most the part `limit` of the solution, with 1 for no limit.
    fn follow(&mut self, lambda: f64, guess: A, mut limit: f64) -> Followed<A> {
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
            if correction > limit || correction.is_nan() {
                return Followed::NotFound;
            }
            limit = CONTRACTION_LIMIT * correction;
        }
        Followed::NotFound
    }

    /// Returns the largest entry of `delta` relative to its size, at most 1. The size of an entry is the largest magnitude of its kind in `x` or in λ·guess,
    /// because the solution may be zero at some λ. Unknowns of one unit are a kind.
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
    /// Corrections do not shrink fast, or the derivative at a point of the iteration has no positive determinant.
    NotFound,
    /// The residual is not finite at a point of the iteration.
    Undefined,
}
