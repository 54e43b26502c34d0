//! Newton's iteration for the increment of an implicit step.

use crate::array::{Array, Square};
use crate::linear;
use crate::method::Refusal;
use crate::predictor::Predictor;
use crate::real::Real;

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

/// Iterations after which a guess was no good.
const ROUGH: u32 = 3;

/// Solves one equation a step, and remembers what helps with the next one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Newton<A> {
    predictor: Predictor<A>,
    /// The steps are too long to be extrapolated.
    rough: bool,
    /// The square of a correction after which the next one is nothing, from C as last seen.
    reach: f64,
    steps: u32,
}

impl<A: Array> Newton<A> {
    pub(crate) fn new() -> Self {
        Newton { predictor: Predictor::new(), rough: true, reach: A::Real::epsilon() * LEFT_OVER, steps: 0 }
    }

    /// Solves `residual(x) = 0` for an increment of `origin`, to rounding, from the increments before or from `explicit`.
    ///
    /// `residual` writes the residual and its derivative. The iteration does not stop at a tolerance but where the next
    /// correction is bound to be below the rounding of `origin + x`: symmetry of a step, and the order of its
    /// compositions, hold only at the solved point.
    ///
    /// Where h goes to 0 the derivative is the identity. If its determinant is negative at a solution, that one is not
    /// continuous in h: the equation has others, or an unstable direction has been turned round.
    #[inline(always)]
    pub(crate) fn solve(
        &mut self,
        origin: &A,
        explicit: impl Fn() -> A,
        mut residual: impl FnMut(&A, &mut A, &mut Square<A>),
    ) -> Result<A, Refusal> {
        let mut extrapolated = !self.rough;
        loop {
            let guess = if extrapolated { self.predictor.predict() } else { explicit() };
            match self.iterate(guess, origin, &mut residual) {
                Ok((x, iterations)) => {
                    self.rough = iterations >= ROUGH && self.predictor.started;
                    self.predictor.push(&x);
                    self.steps = self.steps.wrapping_add(1);
                    return Ok(x);
                }
                // Something may have happened that was not to be foreseen.
                Err(_) if extrapolated => extrapolated = false,
                Err(refusal) => return Err(refusal),
            }
        }
    }

    #[inline(always)]
    fn iterate(
        &mut self,
        guess: A,
        origin: &A,
        residual: &mut impl FnMut(&A, &mut A, &mut Square<A>),
    ) -> Result<(A, u32), Refusal> {
        let rounding = A::Real::epsilon() * LEFT_OVER;
        // A guess may look beyond the domain of the energy where the solution need not.
        let mut x = if guess.is_finite() { guess } else { A::zero() };
        let mut jacobian = A::fill(A::zero());
        let mut before = f64::INFINITY;
        for iterations in 1..=MAX_ITERATIONS {
            let mut delta = A::zero();
            residual(&x, &mut delta, &mut jacobian);
            let Some(positive) = linear::solve(&mut jacobian, &mut delta) else {
                return Err(if delta.is_finite() { Refusal::Singular } else { not_converged(iterations, before) });
            };
            x.add_scaled(A::Real::from_f64(-1.0), &delta);
            // Convergence is quadratic: C times the square, of the first; from the second on, two of them show C.
            if iterations == 1 && within(&delta, &x, origin, self.reach) && !self.steps.is_multiple_of(SECOND_LOOK) {
                return if positive { Ok((x, 1)) } else { Err(Refusal::Singular) };
            }
            let square = relative_square(&delta, &x, origin);
            let shrunk = square / before;
            if iterations == 2 {
                self.see(square, before);
            }
            let next = square * shrunk * shrunk;
            let done = iterations > 1
                && (square == 0.0
                    || next <= rounding * rounding
                    || (shrunk > 0.0625 && square <= STAGNATION * STAGNATION));
            if done {
                return if positive { Ok((x, iterations)) } else { Err(Refusal::Singular) };
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

#[cold]
fn not_converged(iterations: u32, square: f64) -> Refusal {
    Refusal::NotConverged { iterations, correction: square.sqrt() }
}

/// |origin| + |x|, squared, of every entry.
///
/// An entry that happens to be almost zero is measured against a millionth of the largest one: entries may have
/// different units, but are not solved beyond what rounding allows.
#[inline(always)]
fn sizes<'a, A: Array>(x: &'a A, origin: &'a A) -> impl Fn(usize) -> f64 + 'a {
    let size = move |i: usize| {
        let size = origin.as_slice()[i].magnitude() + x.as_slice()[i].magnitude();
        size * size
    };
    let mut largest = 0.0_f64;
    for i in 0..A::LEN {
        largest = largest.max(size(i));
    }
    move |i| size(i).max(1e-12 * largest)
}

/// Whether every entry of `delta`, squared, is at most `bound` of what it corrects.
#[inline(always)]
fn within<A: Array>(delta: &A, x: &A, origin: &A, bound: f64) -> bool {
    let size = sizes(x, origin);
    let mut within = true;
    for i in 0..A::LEN {
        let change = delta.as_slice()[i].magnitude();
        within &= change * change <= bound * size(i);
    }
    within
}

/// The square of the largest entry of `delta`, each relative to the entry of `origin + x` that it corrects.
#[inline(always)]
fn relative_square<A: Array>(delta: &A, x: &A, origin: &A) -> f64 {
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
