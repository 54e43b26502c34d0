//! Many unknowns: the iteration of the fixed point, as long as that attracts.

use super::Found;
use super::iteration::{Iteration, Start, explicit};
use crate::ablation;
use crate::solving::equation::{Observer, StepEquation};
use crate::solving::rounding::{Corrections, Verdict, is_rounding};
use crate::space::Array;
use crate::space::vector::difference;

/// The factor by which corrections of the fixed point must shrink.
const SHRINKING: f64 = 0.3;

/// Of so many steps one tries the fixed point again.
const ANOTHER_TRY: u32 = 256;

impl<A: Array> Iteration<A> {
    /// Solves an equation for many unknowns: by the fixed point if that attracts.
    #[inline(always)]
    pub(super) fn of_many<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        start: Start<A>,
        equation: &E,
        watch: &mut W,
    ) -> Found<A> {
        let retries = !ablation::FIXED_POINT_PAUSE || self.steps.is_multiple_of(ANOTHER_TRY);
        if ablation::FIXED_POINT && (!self.stiff || retries) {
            let guess = start.guess.unwrap_or_else(|| explicit(&{ *equation }));
            let found = self.fixed_point(guess, equation, watch);
            self.stiff = found.is_none();
            if let Some(x) = found {
                self.guesses.count(0, start.guess.is_some(), self.looks());
                return Found::solution(x, A::zero());
            }
        }
        self.search(start, *equation, watch)
    }

    /// x = g(x), if that attracts strongly enough. Where it does there is one solution, and it is continuous in h.
    #[inline(always)]
    fn fixed_point<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        guess: A,
        equation: &E,
        watch: &mut W,
    ) -> Option<A> {
        let (origin, mut x) = (equation.origin(), guess);
        let mut corrections = Corrections::of_order(1);
        loop {
            let next = if const { ablation::NO_MATRIX } {
                equation.image(watch, &x)
            } else {
                equation.evaluate(watch, &equation.point(&x), &mut A::fill(A::zero()))
            };
            let delta = difference(&x, &next);
            x = next;
            let correction = self.sizes.relative(&delta, &origin, &x);
            let before = corrections.last();
            if corrections.judge::<A::Real>(correction) == Verdict::Solved {
                self.sizes.include(&origin, &x);
                return Some(x);
            }
            if correction.is_nan() || correction > SHRINKING * before {
                return is_rounding::<A::Real>(correction).then_some(x);
            }
        }
    }
}
