//! The iteration for the increment of an implicit step: Newton's; or, in many unknowns, that of the fixed point.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::damped;
use crate::solving::linear;
use crate::solving::predictor::Predictor;
use crate::space::{Array, Square};

/// Far more than quadratic convergence ever needs; reached only where there is no convergence.
const MAX_ITERATIONS: u32 = 40;

/// Where corrections no longer shrink because of rounding, they are at least this small.
const STAGNATION: f64 = 1e-9;

/// What is left over has the same sign in every step, and adds up: at ε/1024 a drift of the energy is seen after a million
/// steps.
const LEFT_OVER: f64 = 1.0 / 1_048_576.0;

/// Less than this is not believed of the factor in "the next correction is C times the square of this one".
const LEAST_CURVATURE: f64 = 1e-3;

/// Of so many steps one looks a second time, to see that factor again.
const SECOND_LOOK: u32 = 64;

/// With more unknowns than this, an elimination costs more than the evaluations that it saves. The compiler has the number: up to it,
/// it emits a kernel for Newton's iteration.
const MOST_UNKNOWNS: usize = geoint_macros::most_unknowns!();

/// The square of the factor by which corrections of the fixed point must shrink.
const SHRINKING: f64 = 0.1;

/// Of so many steps one tries the fixed point again.
const ANOTHER_TRY: u32 = 256;

/// Iterations after which a guess was no good.
const ROUGH: u32 = 3;

/// Solves one equation a step, and remembers what helps with the next one.
#[derive(Clone, Copy, Debug)]
pub struct Newton<A> {
    predictor: Predictor<A>,
    /// The steps are too long to be extrapolated.
    rough: bool,
    /// The square of a correction after which the next one is nothing, from C as last seen.
    reach: f64,
    steps: u32,
    /// The fixed point attracts too weakly.
    stiff: bool,
}

impl<A: Array> Newton<A> {
    pub(crate) fn new() -> Self {
        Newton {
            predictor: Predictor::new(),
            rough: true,
            reach: A::Real::epsilon() * LEFT_OVER,
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
            let found = fixed_point(guess, origin, |x| image(context, x));
            self.stiff = found.is_none();
            if let Some(x) = found {
                self.push(&x);
                return Ok((x, A::zero()));
            }
        }
        let mut attempt = if self.rough { Attempt::Explicit } else { Attempt::Extrapolated };
        loop {
            let mut guess = self.predictor.predict();
            match attempt {
                Attempt::Extrapolated => {}
                Attempt::Explicit => guess.copy_from(&aside(explicit)),
                Attempt::Damped(still) => {
                    guess = damped::approach(origin, still, |x, residual, matrix| {
                        *residual = *x;
                        residual.add_scaled(A::Real::from_f64(-1.0), &derivative(context, x, matrix));
                        Ok(())
                    });
                }
            }
            match self.iterate(guess, origin, |x, matrix| derivative(context, x, matrix)) {
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
        guess: A,
        origin: &A,
        mut derivative: impl FnMut(&A, &mut Square<A>) -> A,
    ) -> Result<(A, A, u32), Refusal> {
        let rounding = A::Real::epsilon() * LEFT_OVER;
        let mut x = guess;
        let mut matrix = A::fill(A::zero());
        let mut before = f64::INFINITY;
        for iterations in 1..=MAX_ITERATIONS {
            // That of the guess: it is known earlier, and within the test it differs by nothing that matters.
            let size = sizes(&x, origin);
            let (next, mut delta) = (derivative(&x, &mut matrix), x);
            delta.add_scaled(A::Real::from_f64(-1.0), &next);
            let Some(positive) = linear::solve(&mut matrix, &mut delta) else {
                return Err(if delta.is_finite() { Refusal::Singular } else { not_converged(iterations, before) });
            };
            let minus = A::Real::from_f64(-1.0);
            let mut lost = x;
            x.add_scaled(minus, &delta);
            lost.add_scaled(minus, &x);
            lost.add_scaled(minus, &delta);
            // Convergence is quadratic: C times the square, of the first; from the second on, two of them show C.
            if iterations == 1 && within(&delta, size, self.reach) && !self.steps.is_multiple_of(SECOND_LOOK) {
                return if positive { Ok((x, lost, 1)) } else { Err(Refusal::Singular) };
            }
            let square = relative_square(&delta, &x, origin);
            // What a correction shrinks to says nothing if it was larger than the solution.
            let last = before.min(1.0);
            let shrunk = square / last;
            if iterations == 2 {
                self.see(square, last);
            }
            let left = square * shrunk * shrunk;
            let done = iterations > 1
                && (square == 0.0
                    || left <= rounding * rounding
                    || (shrunk > 0.0625 && square <= STAGNATION * STAGNATION));
            if done {
                return if positive { Ok((x, lost, iterations)) } else { Err(Refusal::Singular) };
            }
            if !square.is_finite() {
                return Err(not_converged(iterations, square));
            }
            before = square;
        }
        Err(not_converged(MAX_ITERATIONS, before))
    }

    /// Two corrections, squared, that follow each other. The second may be nothing but rounding; then C is at most that.
    #[inline(always)]
    fn see(&mut self, square: f64, before: f64) {
        // A margin, since C is not the same all along an orbit.
        let curvature = 16.0 * square.sqrt() / before;
        let reach = A::Real::epsilon() * LEFT_OVER / curvature.max(LEAST_CURVATURE);
        if square.sqrt() > 64.0 * A::Real::epsilon() || reach > self.reach {
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

/// x = g(x), if that attracts strongly enough. Where it does there is one solution, and it is continuous in h.
#[inline(always)]
fn fixed_point<A: Array>(guess: A, origin: &A, mut image: impl FnMut(&A) -> A) -> Option<A> {
    let rounding = A::Real::epsilon() * LEFT_OVER;
    let mut x = guess;
    let mut before = f64::INFINITY;
    for iterations in 1..=MAX_ITERATIONS {
        let (next, mut delta) = (image(&x), x);
        delta.add_scaled(A::Real::from_f64(-1.0), &next);
        x = next;
        let square = relative_square(&delta, &x, origin);
        let shrunk = square / before;
        if square == 0.0 || (iterations > 1 && square * shrunk <= rounding * rounding) {
            return Some(x);
        }
        if !(square.is_finite() && (iterations == 1 || shrunk <= SHRINKING)) {
            // Rounding ends every iteration.
            return (square <= 4096.0 * A::Real::epsilon() * A::Real::epsilon()).then_some(x);
        }
        before = square.min(1.0);
    }
    None
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

#[cold]
fn not_converged(iterations: u32, square: f64) -> Refusal {
    Refusal::NotConverged { iterations, correction: square.sqrt() }
}

/// |origin| + |x|, squared, of every entry.
///
/// An entry that happens to be almost zero is measured against a millionth of the largest one: entries may have
/// different units, but are not solved beyond what rounding allows.
#[inline(always)]
fn sizes<A: Array>(x: &A, origin: &A) -> impl Fn(usize) -> f64 + use<A> {
    let (x, origin) = (*x, *origin);
    let size = move |i: usize| {
        let size = origin.as_slice()[i].magnitude() + x.as_slice()[i].magnitude();
        size * size
    };
    let mut largest = 0.0;
    for i in 0..A::LEN {
        largest = larger(size(i), largest);
    }
    move |i| larger(size(i), 1e-12 * largest)
}

/// One instruction, which `f64::max` is not: what is not a number is found in the correction.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Whether every entry of `delta`, squared, is at most `bound` of what it corrects.
#[inline(always)]
fn within<A: Array>(delta: &A, size: impl Fn(usize) -> f64, bound: f64) -> bool {
    let mut within = true;
    for i in 0..A::LEN {
        let change = delta.as_slice()[i].magnitude();
        within &= change * change <= bound * size(i);
    }
    within
}

/// The square of the largest entry of `delta`, each relative to the entry of `origin + x` that it corrects.
#[inline(always)]
pub(crate) fn relative_square<A: Array>(delta: &A, x: &A, origin: &A) -> f64 {
    let size = sizes(x, origin);
    let mut correction = 0.0;
    for i in 0..A::LEN {
        let change = delta.as_slice()[i].magnitude();
        let ratio = change * change / size(i);
        // Not `max`: that would lose a NaN. Nothing to correct is no correction, even of zero.
        if change != 0.0 && (ratio > correction || ratio.is_nan()) {
            correction = ratio;
        }
    }
    correction
}
