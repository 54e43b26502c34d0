//! How one equation is solved: by how many iterations, from how many guesses.

use super::guess::Guesses;
use super::predictor::Predictor;
use super::{Found, MOST_UNKNOWNS, Newton, subtract};
use crate::ablation;
use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::damped;
use crate::solving::equation::{Distant, Observer, Residual, ResidualOf, StepEquation};
use crate::solving::linear;
use crate::solving::rounding::{Corrections, MAX_ITERATIONS, REMAINDER, Verdict};
use crate::solving::size::Sizes;
use crate::space::vector::difference;
use crate::space::{Array, Record, Tape};

/// Lower bound on the estimated constant C of quadratic convergence: the next correction is C times the square of this one.
const LEAST_CURVATURE: f64 = 1e-3;

/// The last term of a correction, in units of ε, where steps are settled: the terms that are left out are smaller by the factor by which terms
/// shrink, some 10⁻² in a first-order equation at fifty steps a period, and 10⁻⁴ in one of second order.
const LAST_TERM: f64 = 0.25;

/// √(`LAST_TERM`/`REMAINDER`): what a correction leaves grows by its square.
const REACH_IF_SETTLED: f64 = 512.0;

/// Of so many steps one looks a second time, to see that factor again.
const SECOND_LOOK: u32 = 64;

/// Corrections of which in compositions, and in settled steps, no more is asked than whether they are the last one: their sizes cost a tenth of an
/// iteration. Where they are not after so many, something is else than before.
const UNJUDGED: u32 = 3;

/// A correction, in units of the sizes of coordinates, that an extrapolated guess may need. What is farther off may lead to a solution of another
/// branch.
const FAR_OFF: f64 = 1.0 / 8.0;

/// A solution after more iterations may belong to another branch, which no energy tells if the method keeps none.
const FEW: u32 = 5;

/// What is known of the iteration from steps before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Iteration<A> {
    pub(super) sizes: Sizes<A>,
    /// Of so many unknowns each of so many kinds has one unit.
    pub(super) kinds: [usize; 2],
    pub(super) guesses: Guesses,
    /// A correction after which the next one is nothing, from C as last seen.
    reach: f64,
    pub(super) steps: u32,
    /// Two terms of a series are tried in place of an elimination: until they are not enough, and again where a step looks a second time. To ask
    /// in every step would be in vain in as many as not, which nobody can foretell.
    pub(super) by_series: bool,
    /// The fixed point attracts too weakly.
    pub(super) stiff: bool,
}

/// Where an iteration starts that does all to find a solution.
#[derive(Clone, Copy)]
pub(super) struct Start<A> {
    /// The extrapolated guess, if there is one, or what corrections have made of it.
    pub(super) guess: Option<A>,
    /// The next correction, if it is known: then the determinant is positive there.
    pub(super) correction: Option<A>,
    /// So many corrections there have been before.
    pub(super) before: u32,
}

impl<A> Start<A> {
    /// At a guess of which nothing is known.
    #[inline(always)]
    pub(super) fn at(guess: Option<A>) -> Self {
        Start { guess, correction: None, before: 0 }
    }
}

impl<A: Array> Record<A::Real> for Iteration<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        // Kinds follow from the method.
        let Iteration { sizes, kinds: _, guesses, reach, steps, by_series, stiff } = self;
        sizes.record(tape);
        guesses.record(tape);
        let mut count = u64::from(*steps);
        tape.count(&mut count);
        *steps = count as u32;
        tape.number(reach);
        tape.flag(by_series);
        tape.flag(stiff);
    }
}

impl<A: Array> Iteration<A> {
    /// Of equations whose unknowns come in `kinds` of `n` that have one unit.
    pub(super) fn new(n: usize, kinds: usize) -> Self {
        Iteration {
            sizes: Sizes::new(),
            kinds: [n, kinds],
            guesses: Guesses::new(),
            reach: Real::sqrt(A::Real::epsilon() * REMAINDER),
            steps: 0,
            by_series: false,
            stiff: A::LEN <= MOST_UNKNOWNS,
        }
    }

    /// One step more.
    #[inline(always)]
    pub(super) fn pass(&mut self) {
        self.steps = self.steps.wrapping_add(1);
    }

    /// Whether nothing is left to correct after this correction. Convergence is quadratic, and C is known from a step before.
    #[inline(always)]
    pub(super) fn is_last(&self, delta: &A) -> bool {
        self.sizes.all_within(delta, self.reach) && !self.looks()
    }

    /// Returns whether a correction leaves no more than [`LAST_TERM`], where steps are settled.
    #[inline(always)]
    pub(super) fn is_last_if_settled(&self, delta: &A) -> bool {
        self.sizes.all_within(delta, REACH_IF_SETTLED * self.reach) && !self.looks()
    }

    /// Whether a correction of an extrapolated guess leads to no other branch.
    #[inline(always)]
    pub(super) fn is_near(&self, delta: &A) -> bool {
        self.sizes.all_within(delta, FAR_OFF)
    }

    /// Whether nothing that counts is left after this term of a correction, where steps are settled.
    #[inline(always)]
    pub(super) fn is_last_term(&self, term: &A) -> bool {
        self.sizes.all_within(term, LAST_TERM * A::Real::epsilon()) && !self.looks()
    }

    /// Whether this step looks at what others take as known.
    #[inline(always)]
    pub(super) fn looks(&self) -> bool {
        ablation::MEASURED_CURVATURE && self.steps.is_multiple_of(SECOND_LOOK)
    }

    /// Solves the equation from an extrapolated guess, if there is one, and does all to find a solution.
    #[cold]
    #[inline(never)]
    pub(super) fn patient<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        guess: Option<A>,
        equation: E,
        watch: &mut W,
    ) -> Found<A> {
        let (is_bound_by_energy, standstill) = (equation.is_bound_by_energy(), equation.standstill());
        let distant =
            Distant { is_bound_by_energy, origin: equation.origin(), standstill, explicit: equation.explicit() };
        let residual: &mut dyn Residual<A> = &mut ResidualOf { equation, watch };
        if Newton::<A>::MANY {
            return self.of_many(Start::at(guess), &distant, residual);
        }
        self.search(Start::at(guess), distant, residual)
    }

    /// Solves the equation by as many iterations, and from as many guesses, as it needs.
    #[inline(never)]
    pub(super) fn search<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        start: Start<A>,
        equation: E,
        watch: &mut W,
    ) -> Found<A> {
        let mut attempt = start.guess.map_or(Attempt::Explicit, Attempt::Extrapolated);
        let (mut first, mut before) = (start.correction, start.before);
        if const { A::LEN > 1 } {
            self.by_series |= ablation::SERIES && self.steps.is_multiple_of(SECOND_LOOK);
        }
        loop {
            // Sizes for pivots. A guess may be wild: no correction is compared with it.
            let (sizes, mut scale) = (self.sizes, self.sizes);
            let guess = match &attempt {
                Attempt::Extrapolated(guess) => *guess,
                // The constant here: nothing of that is compiled for steps that never take it.
                Attempt::Damped if E::PATIENT => damped::approach_solution(&self.sizes, equation, watch),
                Attempt::Explicit | Attempt::Damped => {
                    let guess = explicit(&equation);
                    scale.include(&equation.origin(), &guess);
                    guess
                }
            };
            let (mut found, iterations) = self.iterate((guess, first.take()), &attempt, &scale, &equation, watch);
            let from_afar = iterations > FEW || matches!(attempt, Attempt::Damped);
            // Steps without patience leave the check to a repetition with patience.
            if found.outcome.is_ok() && from_afar && !equation.is_bound_by_energy() {
                if E::PATIENT && self.is_continuous(found.x, &sizes, equation, watch) {
                    // The observer, and methods that use the last evaluation, must see the solution last.
                    equation.residual(watch, &found.x, &mut A::fill(A::zero()));
                } else {
                    found.outcome = Err(Refusal::Singular);
                    self.sizes = sizes;
                }
            }
            if found.outcome.is_ok() {
                let extrapolated = matches!(attempt, Attempt::Extrapolated(_));
                self.guesses.count(before + iterations, extrapolated, self.looks());
                return found;
            }
            before = 0;
            attempt = match attempt {
                // Something may have happened that was not to be foreseen.
                Attempt::Extrapolated(_) => Attempt::Explicit,
                // No guess leads to a solution.
                Attempt::Explicit if E::PATIENT => Attempt::Damped,
                _ => return found,
            }
        }
    }

    /// Chooses what the next guess is made of, by what each would have missed this solution.
    #[cold]
    #[inline(never)]
    pub(super) fn choose(&self, predictor: &Predictor<A>, origin: A, x: A) -> Guesses {
        self.guesses.choose(predictor, |guess| {
            let missed = difference(&x, guess);
            // What one correction makes good is good enough.
            if self.sizes.all_within(&missed, self.reach) { 0.0 } else { self.sizes.relative(&missed, &origin, &x) }
        })
    }

    /// From a guess, with its first correction if that is known. Of an extrapolated guess one that is too large leads elsewhere. Of others one
    /// correction is no solution, however small it is: the constant C is that of the steps before, and a guess from afar may be at a wall, where
    /// the first correction is small and the next one twice as large.
    #[inline(always)]
    fn iterate<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        (guess, mut first): (A, Option<A>),
        attempt: &Attempt<A>,
        scale: &Sizes<A>,
        equation: &E,
        watch: &mut W,
    ) -> (Found<A>, u32) {
        let origin = equation.origin();
        let mut x = guess;
        let mut matrix = A::fill(A::zero());
        let mut corrections = Corrections::of_order(2);
        let extrapolated = matches!(attempt, Attempt::Extrapolated(_));
        let composed = self.guesses.composed();
        let mut unjudged = ablation::UNMEASURED
            && (composed || E::SETTLED && !E::OF_NOW)
            && !self.looks()
            && !matches!(attempt, Attempt::Damped);
        let (mut lost, mut stuck, mut iterations) = (A::zero(), None, 0);
        let mut delta_before = A::zero();
        // Whether the determinant is positive at the solution, if there is one. Numbers leave the loop by no `Result`: they would share its memory.
        let positive = loop {
            if iterations == MAX_ITERATIONS {
                break None;
            }
            iterations += 1;
            let (mut solved, mut left, before) = (false, A::zero(), x);
            let (delta, positive) = match first.take() {
                Some(first) => (first, true),
                None => {
                    let mut delta = equation.residual(watch, &x, &mut matrix);
                    left = delta;
                    // Of fields who watches sees what that changes.
                    solved = (E::PATIENT || !E::OF_NOW)
                        && corrections.slow()
                        && self.is_of_last_digits(origin, delta, matrix);
                    if let (false, Some(last)) = (solved, stuck.take()) {
                        // Only who watches measures what is rounding.
                        if !E::PATIENT {
                            break None;
                        }
                        solved = self.is_noise(x, last, *equation, watch);
                    }
                    match linear::solve(&mut matrix, &mut delta, scale) {
                        Some(positive) => (delta, positive),
                        None => break if delta.is_finite() { Some(false) } else { None },
                    }
                }
            };
            if iterations == 1 && extrapolated && !self.is_near(&delta) {
                break None;
            }
            if solved {
                self.sizes.include(&origin, &x);
                break Some(positive);
            }
            lost = subtract(&mut x, &delta);
            if iterations == 1 {
                // From afar the first one may be small at a wall, and the next one, too.
                unjudged &= composed || !self.is_last(&delta);
            }
            if (if iterations == 1 { extrapolated } else { unjudged }) && self.is_last(&delta) {
                break Some(positive);
            }
            if let (true, Some(left)) = (unjudged && E::SETTLED, self.foretold(&delta_before, &delta)) {
                lost = difference(&lost, &left);
                break Some(positive);
            }
            delta_before = delta;
            if iterations <= UNJUDGED && unjudged {
                continue;
            }
            let correction = self.sizes.relative(&delta, &origin, &x);
            if iterations == 2 {
                self.see(correction, corrections.last());
            }
            match corrections.judge::<A::Real>(correction) {
                // Where the matrix is large beyond measure, corrections are small wherever x is. Steps before have seen that it is not.
                Verdict::Solved if extrapolated || self.sizes.resolve(&left, &origin, &before) => {
                    self.sizes.include(&origin, &x);
                    break Some(positive);
                }
                Verdict::Stuck => {
                    stuck = Some((delta, corrections.farther()));
                    corrections.restart();
                }
                Verdict::Solved | Verdict::Continue => {}
            }
            if !correction.is_finite() {
                break None;
            }
        };
        let outcome = match positive {
            Some(true) => Ok(()),
            Some(false) => Err(Refusal::Singular),
            None => Err(corrections.not_converged()),
        };
        (Found { x, lost, outcome }, iterations)
    }

    /// Two corrections that follow each other. The second may be nothing but rounding; then C is at most that.
    #[inline(always)]
    pub(super) fn see(&mut self, correction: f64, before: f64) {
        if const { !ablation::MEASURED_CURVATURE } {
            return;
        }
        // A margin, since C is not the same all along an orbit.
        let before = before.min(1.0);
        let curvature = 16.0 * correction / (before * before);
        let reach = Real::sqrt(A::Real::epsilon() * REMAINDER / curvature.max(LEAST_CURVATURE));
        if correction > 64.0 * A::Real::epsilon() || reach > self.reach {
            self.reach = reach;
        }
    }
}

/// The addresses of what is compiled once for a shape of unknowns.
pub(crate) fn compiled<A: Array>() -> [*const (); 2] {
    [Iteration::<A>::search::<dyn Residual<A>, Distant<A>> as *const (), Iteration::<A>::choose as *const ()]
}

/// Where an iteration starts.
enum Attempt<A> {
    Extrapolated(A),
    Explicit,
    /// From afar.
    Damped,
}

/// The explicit guess, if there is one.
#[inline(always)]
pub(super) fn explicit<A: Array, W: Observer + ?Sized>(equation: &impl StepEquation<A, W>) -> A {
    let guess = equation.explicit();
    // It may look beyond the domain of the energy where the solution need not.
    if ablation::EXPLICIT_GUESS && guess.is_finite() { guess } else { A::zero() }
}
