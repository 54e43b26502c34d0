//! The iteration for the increment of an implicit step: Newton's; or, in many unknowns, that of the fixed point.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::damped;
use crate::solving::equation::StepEquation;
use crate::solving::linear;
use crate::solving::noise;
use crate::solving::predictor::Predictor;
use crate::solving::rounding::{Corrections, MAX_ITERATIONS, REMAINDER, Verdict, is_rounding};
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::vector::difference;

/// Lower bound on the estimated constant C of quadratic convergence: the next correction is C times the square of this one.
const LEAST_CURVATURE: f64 = 1e-3;

/// Of so many steps one looks a second time, to see that factor again.
const SECOND_LOOK: u32 = 64;

/// With more unknowns than this, an elimination costs more than the evaluations that it saves. The compiler has the number: up to it,
/// it emits a kernel for Newton's iteration.
const MOST_UNKNOWNS: usize = geoint_macros::most_unknowns!();

/// The factor by which corrections of the fixed point must shrink.
const SHRINKING: f64 = 0.3;

/// Of so many steps one tries the fixed point again.
const ANOTHER_TRY: u32 = 256;

/// Iterations after which a guess was no good.
const ROUGH: u32 = 3;

/// Solves one equation a step, and remembers what helps with the next one.
#[derive(Clone, Copy, Debug)]
pub struct Newton<A> {
    predictor: Predictor<A>,
    sizes: Sizes<A>,
    /// Of so many unknowns each of so many kinds has one unit.
    kinds: [usize; 2],
    /// The steps are too long to be extrapolated.
    rough: bool,
    /// The square of a correction after which the next one is nothing, from C as last seen.
    reach: f64,
    steps: u32,
    /// The fixed point attracts too weakly.
    stiff: bool,
}

impl<A: Array> Newton<A> {
    /// Unknowns come in `kinds` of `n` that have one unit.
    pub(crate) fn new(n: usize, kinds: usize) -> Self {
        Newton {
            predictor: Predictor::new(),
            sizes: Sizes::new(),
            kinds: [n, kinds],
            rough: true,
            reach: A::Real::epsilon() * REMAINDER,
            steps: 0,
            stiff: A::LEN <= MOST_UNKNOWNS,
        }
    }

    /// Solves an equation to rounding, from the increments before or from its explicit guess.
    ///
    /// The iteration does not stop at a tolerance but where the next correction is bound to be below the rounding of `origin + x`:
    /// symmetry of a step, and the order of its compositions, hold only at the solved point.
    ///
    /// Returned as well is what the last correction could not subtract from the digits of x. That has a bias: what is left of x − g
    /// is a multiple of the last digit of x, and so is, nearly, a small correction.
    ///
    /// Where h goes to 0 the matrix 1 − g' is the identity. If its determinant is negative at a solution, that one is not
    /// continuous in h: the equation has others, or an unstable direction has been turned round.
    #[inline(always)]
    pub(crate) fn solve<W, E: StepEquation<A, W>>(&mut self, equation: &E, watch: &mut W) -> Result<(A, A), Refusal> {
        if A::LEN > MOST_UNKNOWNS && (!self.stiff || self.steps.is_multiple_of(ANOTHER_TRY)) {
            let guess = if self.predictor.started { self.predictor.predict() } else { explicit(*equation) };
            let found = self.fixed_point(guess, equation, watch);
            self.stiff = found.is_none();
            if let Some(x) = found {
                self.push(&x);
                return Ok((x, A::zero()));
            }
        }
        let mut attempt = if self.rough { Attempt::Explicit } else { Attempt::Extrapolated };
        loop {
            let mut guess = self.predictor.predict();
            // Sizes for pivots. A guess may be wild: no correction is compared with it.
            let mut scale = self.sizes;
            match attempt {
                Attempt::Extrapolated => {}
                Attempt::Explicit => {
                    guess.copy_from(&explicit(*equation));
                    scale.include(&equation.origin(), &guess);
                }
                Attempt::Damped => {
                    if let Some(still) = E::STANDSTILL {
                        guess = damped::approach_solution(still, &self.sizes, *equation, watch);
                    }
                }
            }
            match self.iterate((guess, &scale), equation, watch) {
                Ok((x, lost, iterations)) => {
                    self.rough = iterations >= ROUGH && self.predictor.started;
                    self.push(&x);
                    return Ok((x, lost));
                }
                Err(refusal) => {
                    attempt = match attempt {
                        // Something may have happened that was not to be foreseen.
                        Attempt::Extrapolated => Attempt::Explicit,
                        // No guess leads to a solution.
                        Attempt::Explicit if E::STANDSTILL.is_some() => Attempt::Damped,
                        _ => return Err(refusal),
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn push(&mut self, x: &A) {
        self.predictor.push(x);
        self.steps = self.steps.wrapping_add(1);
    }

    #[inline(always)]
    fn iterate<W, E: StepEquation<A, W>>(
        &mut self,
        (guess, scale): (A, &Sizes<A>),
        equation: &E,
        watch: &mut W,
    ) -> Result<(A, A, u32), Refusal> {
        let origin = equation.origin();
        let mut x = guess;
        let mut matrix = A::fill(A::zero());
        let mut corrections = Corrections::of_order(2);
        for iterations in 1..=MAX_ITERATIONS {
            let mut delta = equation.residual(watch, &x, &mut matrix);
            let Some(positive) = linear::solve(&mut matrix, &mut delta, scale) else {
                return Err(if delta.is_finite() { Refusal::Singular } else { corrections.not_converged() });
            };
            let before = x;
            x = difference(&x, &delta);
            let lost = difference(&difference(&before, &x), &delta);
            // Convergence is quadratic: C times the square, of the first; from the second on, two of them show C.
            if iterations == 1 && self.sizes.exceed(&delta, self.reach) && !self.steps.is_multiple_of(SECOND_LOOK) {
                return if positive { Ok((x, lost, 1)) } else { Err(Refusal::Singular) };
            }
            let correction = self.sizes.relative(&delta, &origin, &x);
            if iterations == 2 {
                self.see(correction, corrections.last());
            }
            let verdict = corrections.judge::<A::Real>(correction);
            let mut noise =
                || E::STANDSTILL.is_some() && self.is_noise((x, corrections.neighbourhood()), *equation, watch);
            if verdict == Verdict::Solved || verdict == Verdict::Stuck && noise() {
                self.sizes.include(&origin, &x);
                return if positive { Ok((x, lost, iterations)) } else { Err(Refusal::Singular) };
            }
            if verdict == Verdict::Stuck {
                corrections.restart();
            }
            if !correction.is_finite() {
                break;
            }
        }
        Err(corrections.not_converged())
    }

    /// Whether what is left of x − g(x) is rounding.
    #[cold]
    #[inline(never)]
    fn is_noise<W, E: StepEquation<A, W>>(&self, (x, nearest): (A, f64), equation: E, watch: &mut W) -> bool {
        let mut unused = A::fill(A::zero());
        let mut residual = |x: &A| equation.residual(watch, x, &mut unused);
        let mut sizes = self.sizes;
        sizes.include(&equation.origin(), &x);
        let [n, kinds] = self.kinds;
        let noise = noise::measure(&sizes, (&x, nearest), |i| i / n % kinds, |x| Some(residual(x)));
        // Here last: who watches has seen the solution last.
        noise::explains(&noise, &residual(&x), &sizes)
    }

    /// x = g(x), if that attracts strongly enough. Where it does there is one solution, and it is continuous in h.
    #[inline(always)]
    fn fixed_point<W, E: StepEquation<A, W>>(&mut self, guess: A, equation: &E, watch: &mut W) -> Option<A> {
        let (origin, mut x) = (equation.origin(), guess);
        let mut corrections = Corrections::of_order(1);
        loop {
            let next = equation.image(watch, &x);
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

    /// Two corrections that follow each other. The second may be nothing but rounding; then C is at most that.
    #[inline(always)]
    fn see(&mut self, correction: f64, before: f64) {
        // A margin, since C is not the same all along an orbit.
        let before = before.min(1.0);
        let curvature = 16.0 * correction / (before * before);
        let reach = A::Real::epsilon() * REMAINDER / curvature.max(LEAST_CURVATURE);
        if correction > 64.0 * A::Real::epsilon() || reach > self.reach {
            self.reach = reach;
        }
    }
}

/// Where an iteration starts.
enum Attempt {
    Extrapolated,
    Explicit,
    Damped,
}

/// Out of line: the optimiser takes a sine to be so cheap that it computes it before it knows whether it is needed.
#[cold]
#[inline(never)]
fn explicit<A: Array, W>(equation: impl StepEquation<A, W>) -> A {
    let guess = equation.explicit();
    // It may look beyond the domain of the energy where the solution need not.
    if guess.is_finite() { guess } else { A::zero() }
}
