//! What is the next guess made of?

use super::predictor::{FEW, POINTS, Predictor};
use crate::ablation;
use crate::space::{Array, Tape};

/// The largest part that a guess may have missed by: after more the next one is explicit. It takes two evaluations, and at very long
/// steps an extrapolated guess may lead to another solution.
const NEAR: f64 = 1.0 / 32.0;

/// Iterations after which an explicit guess was no good; it takes an evaluation of its own, so that an extrapolated one may take one more.
const ROUGH: u32 = 3;

/// What a guess is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Guess {
    /// The start of the step alone.
    Explicit,
    /// The last few increments.
    Few,
    /// All increments that are remembered.
    All,
}

/// Which guess is the best, and which there are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Guesses {
    next: Guess,
    /// In a composition: the last guess was good enough.
    sure: bool,
    /// So many increments there have been, as far as more than are remembered make no difference.
    known: usize,
    /// A better one is looked for.
    due: bool,
    /// The equation is that of a substep: what few increments miss is known from the two substeps before. Few increments without that are no
    /// guess: from them the discrete gradient of a pendulum, three radians a second with h = 0.1, drifts by 9·10⁻¹³ in a million steps,
    /// from explicit guesses by 9·10⁻¹⁴.
    composed: bool,
}

impl Guesses {
    pub(super) fn new() -> Self {
        Guesses { next: Guess::Explicit, sure: false, known: 0, due: false, composed: false }
    }

    pub(super) fn record<R>(&mut self, tape: &mut impl Tape<R>) {
        let (mut known, mut next) = (self.known as u64, self.next as u64);
        tape.count(&mut known);
        tape.count(&mut next);
        self.known = (known as usize).min(POINTS + 1);
        self.next = match next {
            0 => Guess::Explicit,
            1 => Guess::Few,
            _ => Guess::All,
        };
        tape.flag(&mut self.sure);
        tape.flag(&mut self.composed);
    }

    /// Whether all increments are extrapolated.
    #[inline(always)]
    pub(super) fn all(&self) -> bool {
        self.next == Guess::All
    }

    /// Whether the equation is that of a substep.
    #[inline(always)]
    pub(super) fn composed(&self) -> bool {
        self.composed
    }

    /// The equation is that of a substep, from here on.
    #[inline(always)]
    pub(super) fn compose(&mut self) {
        self.composed = true;
    }

    /// Whether what few increments miss makes no difference to the next guess, nor to the choice after it.
    #[inline(always)]
    pub(super) fn sure(&self) -> bool {
        self.sure && self.all()
    }

    /// Whether a difference of as many increments as are extrapolated where few are is known.
    pub(super) fn knows_difference(&self) -> bool {
        self.known > FEW
    }

    /// The next guess, if it is extrapolated.
    #[inline(always)]
    pub(super) fn extrapolated<A: Array>(&self, predictor: &Predictor<A>) -> Option<A> {
        match self.next {
            Guess::Explicit => None,
            Guess::Few => Some(predictor.predict_by_few()),
            Guess::All => Some(predictor.predict()),
        }
    }

    /// A step is solved, by so many iterations from the guess that was extrapolated or not; perhaps it looks at what others take as known.
    pub(super) fn count(&mut self, iterations: u32, extrapolated: bool, looks: bool) {
        let filled = self.known >= POINTS;
        self.known = (self.known + 1).min(POINTS + 1);
        if !self.composed {
            let good = iterations < ROUGH + u32::from(extrapolated) || self.known == POINTS;
            self.next =
                if ablation::EXTRAPOLATION && self.known >= POINTS && good { Guess::All } else { Guess::Explicit };
            return;
        }
        // As long as some are missing each step may have one that was not there before. A guess from all of them that takes two evaluations
        // now may take one in the next step.
        let disappoints = if self.all() { iterations >= ROUGH } else { iterations > ROUGH || looks };
        self.due = !filled || !extrapolated || disappoints;
        self.sure = !self.due;
    }

    /// Whether another guess might be better.
    #[inline(always)]
    pub(super) fn due(&self) -> bool {
        self.due
    }

    /// The guesses after a solution that is counted, and not remembered yet: by what part a guess has missed it is given.
    pub(super) fn choose<A: Array>(&self, predictor: &Predictor<A>, missed: impl Fn(&A) -> f64) -> Self {
        let of = |points: usize, guess: fn(&Predictor<A>) -> A| {
            if self.known > points { missed(&guess(predictor)) } else { f64::INFINITY }
        };
        let (few, all) = (of(FEW, Predictor::predict_by_few), of(POINTS, Predictor::predict));
        let next = match (all <= few, ablation::EXTRAPOLATION && all.min(few) <= NEAR) {
            (_, false) => Guess::Explicit,
            (false, true) => Guess::Few,
            (true, true) => Guess::All,
        };
        Guesses { next, due: false, ..*self }
    }
}
