//! The iteration for the increment of an implicit step: Newton's; or, in many unknowns, that of the fixed point.

mod branch;
#[cfg(test)]
mod curved;
mod fixed_point;
mod foretold;
mod guess;
mod iteration;
mod left;
mod predictor;
mod reciprocal;
mod series;

use crate::ablation;
use crate::solving::Refusal;
use crate::solving::equation::{Observer, StepEquation};
use crate::solving::linear;
use crate::solving::rounding::{Corrections, Verdict};
use crate::solving::size::Sizes;
use crate::space::vector::{difference, sum};
use crate::space::{Array, Record, Tape};
pub(crate) use iteration::compiled;
use iteration::{Iteration, Start};
use predictor::Predictor;
use reciprocal::Reciprocal;

/// With more unknowns than this, an elimination costs more than the evaluations that it saves. Up to it, the compiler emits a kernel for Newton's
/// iteration. The compiler has the same constant, and a test of it compares both.
pub const MOST_UNKNOWNS: usize = 12;

/// So many evaluations more a long step may need.
const MOST_AGAIN: u32 = 2;

/// Solves one equation a step, and remembers what helps with the next one.
#[derive(Clone, Copy, Debug)]
pub struct Newton<A> {
    predictor: Predictor<A>,
    iteration: Iteration<A>,
    reciprocal: Reciprocal<A>,
}

/// What a solver has found.
///
/// No `Result`: the refusal and the numbers would share their memory, and the numbers go through it in every step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found<A> {
    pub(crate) x: A,
    /// What the last correction could not subtract from the digits of x. That has a bias: what is left of x − g is a multiple of the last
    /// digit of x, and so is, nearly, a small correction.
    pub(crate) lost: A,
    /// Where there is no solution, the rest is worth nothing.
    pub(crate) outcome: Result<(), Refusal>,
}

impl<A: Array> Found<A> {
    /// x and what it has lost, for steps that take so long that a `Result` costs nothing beside them.
    #[inline(always)]
    pub(crate) fn checked(self) -> Result<(A, A), Refusal> {
        self.outcome.map(|()| (self.x, self.lost))
    }

    /// x − delta.
    #[inline(always)]
    fn corrected(mut x: A, delta: &A) -> Self {
        let lost = subtract(&mut x, delta);
        Found::solution(x, lost)
    }

    /// x − delta, to which `missed` is to be added: it is carried with what is rounded off.
    #[inline(always)]
    fn corrected_nearly(x: A, delta: &A, missed: &A) -> Self {
        let mut found = Found::corrected(x, delta);
        found.lost = sum(&found.lost, missed);
        found
    }

    #[inline(always)]
    fn solution(x: A, lost: A) -> Self {
        Found { x, lost, outcome: Ok(()) }
    }
}

impl<A: Array> Record<A::Real> for Newton<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.predictor.record(tape);
        self.iteration.record(tape);
        self.reciprocal.record(tape);
    }
}

impl<A: Array> Newton<A> {
    const MANY: bool = A::LEN > MOST_UNKNOWNS;

    /// Unknowns come in `kinds` of `n` that have one unit.
    pub(crate) fn new(n: usize, kinds: usize) -> Self {
        Newton { predictor: Predictor::new(), iteration: Iteration::new(n, kinds), reciprocal: Reciprocal::new() }
    }

    /// The next equation is that of a substep, and these are those of the two substeps before it, with the weights by which unknowns of
    /// both are extrapolated to it. What few increments miss is smooth along substeps as well.
    #[inline(always)]
    pub(crate) fn follow(&mut self, before: [(A::Real, &Self); 2]) {
        let knows = |(_, other): &(_, &Self)| other.iteration.guesses.knows_difference();
        if ablation::SUBSTEPS && !self.iteration.guesses.sure() && before.iter().all(knows) {
            self.iteration.guesses.compose();
            self.predictor.expect(before.map(|(weight, other)| (weight, &other.predictor)));
        } else {
            self.predictor.expect_nothing();
        }
    }

    /// Solves an equation to rounding, from the increments before or from its explicit guess.
    ///
    /// The iteration does not stop at a tolerance but where the next correction is bound to be below the rounding of `origin + x`:
    /// symmetry of a step, and the order of its compositions, hold only at the solved point.
    ///
    /// Where h goes to 0 the matrix 1 − g' is the identity. If its determinant is negative at a solution, that one is not
    /// continuous in h: the equation has others, or an unstable direction has been turned round.
    #[inline(always)]
    pub(crate) fn solve<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Found<A> {
        let found = self.solution(equation, watch);
        self.pass(&found.x);
        found
    }

    /// The next equation is that of the next step.
    #[inline(always)]
    pub(crate) fn pass(&mut self, x: &A) {
        // Here for all: the terms of the sequence are moved once. A memory after a refusal is not used.
        self.predictor.push(x);
        self.iteration.pass();
    }

    /// The solution, before it [passes](Self::pass).
    #[inline(always)]
    pub(crate) fn solution<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Found<A> {
        let guesses = self.iteration.guesses;
        if E::OF_NOW {
            self.iteration.sizes = Sizes::at(&equation.origin());
        }
        if E::PATIENT || Self::MANY {
            let guess = guesses.extrapolated(&self.predictor);
            let found = if E::PATIENT {
                self.iteration.patient(guess, *equation, watch)
            } else {
                self.iteration.of_many(Start::at(guess), equation, watch)
            };
            self.choose(equation.origin(), found.x);
            return found;
        }
        // In almost every step one evaluation is enough, in a long one two or three: the rest is out of line, with copies. What it looked at here
        // would be in memory.
        let start = 'start: {
            if !guesses.all() {
                break 'start Start::at(guesses.extrapolated(&self.predictor));
            }
            let point = self.predictor.predict();
            let guess = equation.unknown(&point);
            let mut matrix = A::fill(A::zero());
            // Constants first: nothing is compiled of what is not asked.
            if const { ablation::SERIES && E::SETTLED && A::LEN > 1 && E::NEARLY } && self.iteration.by_series {
                let delta = difference(&guess, &equation.nearly(watch, &point, &mut matrix));
                if let Some(found) = self.by_series(guess, &delta, &matrix) {
                    return found;
                }
            }
            let mut delta = equation.residual_at(watch, &guess, &point, &mut matrix);
            if const { ablation::SERIES && E::SETTLED && A::LEN > 1 && !E::NEARLY }
                && self.iteration.by_series
                && let Some(found) = self.by_series(guess, &delta, &matrix)
            {
                return found;
            }
            // Of one unknown the correction by the derivative of the step before is there first, and is taken as long as it misses the other one
            // by a part of the last digit: which of them it is, a processor guesses, and goes on.
            if const { E::SETTLED && Reciprocal::<A>::KNOWN } {
                if let Some((early, missed)) = self.reciprocal.followed(&matrix, &delta)
                    && self.iteration.is_last(&early)
                    && self.iteration.is_last_term(&missed)
                {
                    return Found::corrected_nearly(guess, &early, &missed);
                }
                if !self.reciprocal.solve(&matrix, &mut delta) {
                    break 'start Start::at(Some(guess));
                }
            } else if !linear::solve_fast(&mut matrix, &mut delta) {
                break 'start Start::at(Some(guess));
            }
            if self.iteration.is_last(&delta) {
                return Found::corrected(guess, &delta);
            }
            let mut start = Start { guess: Some(guess), correction: Some(delta), before: 0 };
            if ablation::INLINE_REPEAT && !self.iteration.looks() && self.iteration.is_near(&delta) {
                let (found, solved) = self.again((guess, delta), &mut start, equation, watch);
                if solved {
                    return found;
                }
            }
            start
        };
        let distant = self.iteration.search(start, *equation, watch);
        if const { !ablation::COPY_BY_ENTRY } {
            self.choose(equation.origin(), distant.x);
            return distant;
        }
        // Entry by entry, so that what is found here stays in registers: the next step waits for it.
        let mut found = Found { outcome: distant.outcome, ..Found::solution(A::zero(), A::zero()) };
        found.x.copy_from(&distant.x);
        found.lost.copy_from(&distant.lost);
        self.choose(equation.origin(), found.x);
        found
    }

    /// A long step: where it is solved by a second or third evaluation after the first correction of an extrapolated guess, else where it has
    /// come to. Inline, because the equation would be copied otherwise, and read in other pieces than it was written in: for that a processor
    /// waits as long as for an evaluation.
    #[inline(always)]
    fn again<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        (guess, first): (A, A),
        start: &mut Start<A>,
        equation: &E,
        watch: &mut W,
    ) -> (Found<A>, bool) {
        let iteration = &mut self.iteration;
        let origin = equation.origin();
        let mut found = Found::corrected(guess, &first);
        let (mut corrections, mut last) = (Corrections::of_order(2), first);
        // A substep that takes a third one chooses another guess after it.
        let composed = iteration.guesses.composed();
        let most = if composed { 1 } else { MOST_AGAIN };
        for before in 1..=most {
            let x = found.x;
            let mut matrix = A::fill(A::zero());
            let mut delta = equation.residual(watch, &x, &mut matrix);
            // Of one unknown by the derivative at the point before, as in short steps.
            let early = if const { E::SETTLED && Reciprocal::<A>::KNOWN } {
                self.reciprocal.followed(&matrix, &delta).filter(|(_, missed)| iteration.is_last_term(missed))
            } else {
                None
            };
            if let Some((early, missed)) = early {
                (found, delta) = (Found::corrected_nearly(x, &early, &missed), early);
            } else {
                if !linear::solve_fast(&mut matrix, &mut delta) {
                    *start = Start { before, ..Start::at(Some(x)) };
                    break;
                }
                found = Found::corrected(x, &delta);
            }
            if E::SETTLED
                && let Some(left) = iteration.foretold(&last, &delta)
            {
                found.lost = difference(&found.lost, &left);
                return (found, true);
            }
            last = delta;
            // How large it is costs two divisions, and is not asked of one that is the last where steps are settled, or composed; else C is known better.
            let solved = ablation::UNMEASURED && (E::SETTLED || composed) && iteration.is_last(&delta) || {
                let correction = iteration.sizes.relative(&delta, &origin, &found.x);
                if before == 1 {
                    corrections.judge::<A::Real>(iteration.sizes.relative(&first, &origin, &x));
                    iteration.see(correction, corrections.last());
                }
                corrections.judge::<A::Real>(correction) == Verdict::Solved
            };
            if solved {
                return (found, true);
            }
            *start = Start { guess: Some(x), correction: Some(delta), before };
        }
        (found, false)
    }

    /// What the next guess is made of, if another one than this time may be better.
    #[inline(always)]
    fn choose(&mut self, origin: A, x: A) {
        if self.iteration.guesses.due() {
            self.iteration.guesses = self.iteration.choose(&self.predictor, origin, x);
        }
    }
}

/// x ← x − delta, and what that rounds off.
#[inline(always)]
fn subtract<A: Array>(x: &mut A, delta: &A) -> A {
    let before = *x;
    *x = difference(&before, delta);
    difference(&difference(&before, x), delta)
}
