//! The iteration for the increment of an implicit step: Newton's; or, in many unknowns, that of the fixed point.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::damped;
use crate::solving::linear;
use crate::solving::noise;
use crate::solving::predictor::Predictor;
use crate::solving::rounding::{Corrections, MAX_ITERATIONS, REMAINDER, Verdict, is_rounding};
use crate::solving::size::Sizes;
use crate::space::{Array, Square};

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

    /// Solves x = g(x) for an increment of `origin`, to rounding, from the increments before or from `explicit`.
    ///
    /// `image` is g, `derivative` writes 1 − g' as well; both are given the `context`. The iteration does not stop at a
    /// tolerance but where the next correction is bound to be below the rounding of `origin + x`: symmetry of a step, and the
    /// order of its compositions, hold only at the solved point.
    ///
    /// Returned as well is what the last correction could not subtract from the digits of x. That has a bias: what is left of x − g
    /// is a multiple of the last digit of x, and so is, nearly, a small correction.
    ///
    /// Where h goes to 0 the matrix 1 − g' is the identity. If its determinant is negative at a solution, that one is not
    /// continuous in h: the equation has others, or an unstable direction has been turned round.
    ///
    /// Where no guess leads to a solution, `still` times `origin`, if given, is a start from which one is approached: at that increment
    /// nothing moves, so that the energy is defined there if it is at the start of the step.
    #[inline(always)]
    pub(crate) fn solve<Q>(
        &mut self,
        (origin, still): (&A, Option<f64>),
        explicit: impl Fn() -> A + Copy,
        context: &mut Q,
        image: impl Fn(&mut Q, &A) -> A,
        derivative: impl Fn(&mut Q, &A, &mut Square<A>) -> A,
    ) -> Result<(A, A), Refusal> {
        if A::LEN > MOST_UNKNOWNS && (!self.stiff || self.steps.is_multiple_of(ANOTHER_TRY)) {
            let guess = if self.predictor.started { self.predictor.predict() } else { aside(explicit) };
            let found = self.fixed_point(guess, origin, |x| image(context, x));
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
                    guess.copy_from(&aside(explicit));
                    scale.include(origin, &guess);
                }
                Attempt::Damped(still) => {
                    guess = damped::approach(origin, still, &self.sizes, |x, residual, matrix| {
                        *residual = *x;
                        residual.add_scaled(A::Real::from_f64(-1.0), &derivative(context, x, matrix));
                        Ok(())
                    });
                }
            }
            match self.iterate((guess, &scale), origin, still.is_some(), |x, matrix| derivative(context, x, matrix)) {
                Ok((x, lost, iterations)) => {
                    self.rough = iterations >= ROUGH && self.predictor.started;
                    self.push(&x);
                    return Ok((x, lost));
                }
                Err(refusal) => {
                    attempt = match (attempt, still) {
                        // Something may have happened that was not to be foreseen.
                        (Attempt::Extrapolated, _) => Attempt::Explicit,
                        (Attempt::Explicit, Some(still)) => Attempt::Damped(still),
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
    fn iterate(
        &mut self,
        (guess, scale): (A, &Sizes<A>),
        origin: &A,
        patient: bool,
        mut derivative: impl FnMut(&A, &mut Square<A>) -> A,
    ) -> Result<(A, A, u32), Refusal> {
        let minus = A::Real::from_f64(-1.0);
        let mut x = guess;
        let mut matrix = A::fill(A::zero());
        let mut corrections = Corrections::of_order(2);
        for iterations in 1..=MAX_ITERATIONS {
            let (next, mut delta) = (derivative(&x, &mut matrix), x);
            delta.add_scaled(minus, &next);
            let Some(positive) = linear::solve(&mut matrix, &mut delta, scale) else {
                return Err(if delta.is_finite() { Refusal::Singular } else { corrections.not_converged() });
            };
            let mut lost = x;
            x.add_scaled(minus, &delta);
            lost.add_scaled(minus, &x);
            lost.add_scaled(minus, &delta);
            // Convergence is quadratic: C times the square, of the first; from the second on, two of them show C.
            if iterations == 1 && self.sizes.exceed(&delta, self.reach) && !self.steps.is_multiple_of(SECOND_LOOK) {
                return if positive { Ok((x, lost, 1)) } else { Err(Refusal::Singular) };
            }
            let correction = self.sizes.relative(&delta, origin, &x);
            if iterations == 2 {
                self.see(correction, corrections.last());
            }
            let verdict = corrections.judge::<A::Real>(correction);
            let image = |x: &A| derivative(x, &mut matrix);
            if verdict == Verdict::Solved || verdict == Verdict::Stuck && patient && self.is_noise(origin, &x, image) {
                self.sizes.include(origin, &x);
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
    fn is_noise(&self, origin: &A, x: &A, mut image: impl FnMut(&A) -> A) -> bool {
        let mut residual = |x: &A| {
            let mut r = *x;
            r.add_scaled(A::Real::from_f64(-1.0), &image(x));
            r
        };
        let mut sizes = self.sizes;
        sizes.include(origin, x);
        let [n, kinds] = self.kinds;
        let left = residual(x);
        let noise = noise::measure(&sizes, x, |i| i / n % kinds, |x| Some(residual(x)));
        noise::explains(&noise, &left, &sizes)
    }

    /// x = g(x), if that attracts strongly enough. Where it does there is one solution, and it is continuous in h.
    #[inline(always)]
    fn fixed_point(&mut self, guess: A, origin: &A, mut image: impl FnMut(&A) -> A) -> Option<A> {
        let mut x = guess;
        let mut corrections = Corrections::of_order(1);
        loop {
            let (next, mut delta) = (image(&x), x);
            delta.add_scaled(A::Real::from_f64(-1.0), &next);
            x = next;
            let correction = self.sizes.relative(&delta, origin, &x);
            let before = corrections.last();
            if corrections.judge::<A::Real>(correction) == Verdict::Solved {
                self.sizes.include(origin, &x);
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
    Damped(f64),
}

/// Out of line: the optimiser takes a sine to be so cheap that it computes it before it knows whether it is needed. By value:
/// what is pointed at from elsewhere is not kept in registers.
#[cold]
#[inline(never)]
fn aside<A: Array>(explicit: impl Fn() -> A) -> A {
    let guess = explicit();
    // It may look beyond the domain of the energy where the solution need not.
    if guess.is_finite() { guess } else { A::zero() }
}
