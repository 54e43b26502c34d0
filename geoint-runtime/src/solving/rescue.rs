//! Long searches for a solution of r(x) = 0. They rescue the steps that Newton's loop does not solve in a few evaluations. They are the normal way of
//! [`QuasiNewton`](super::quasi_newton), whose derivative is approximate.
//!
//! 1. From the guess at the start of the step, with at most 100 evaluations. If corrections stop shrinking, x is accepted if the last digits of coordinates
//!    explain the residual. With [`Effort::Thorough`], x is also accepted if the measured rounding explains it ([`noise`]).
//! 2. With [`Effort::Thorough`] and an approximate derivative, the first search is repeated with a matrix of difference quotients.
//! 3. With [`Effort::Thorough`], from the end of [`damped`] corrections.
//!
//! A solution after more than five evaluations, or after damped corrections, may not be continuous in the step size h. With [`Effort::Thorough`], [`branch`]
//! follows it to h = 0. With [`Effort::Fast`], the step is refused, and the caller repeats it. Equations that are bound by energy are exempt. The searches are
//! compiled once for all equations with unknowns of the same shape.

use super::branch::Continuation;
use super::differences::Differences;
use super::distant::{Distant, Residual, ResidualOf};
use super::equation::{Magnitudes, Solution, StepEquation, explicit_guess};
use super::experience::{Experience, MOST_EVALUATIONS};
use super::rounding::{Convergence, Corrections, MAX_ITERATIONS, Verdict, is_of_last_digits};
use super::{Effort, Observer, Refusal, damped, linear, noise};
use crate::space::Array;

/// Solves an equation from the guess at the start of the step, not from an extrapolated one. Returns the changed experience, too. After an error it is not
/// valid.
#[cold]
#[inline(never)]
pub(super) fn solve_from_explicit_guess<A: Array, W: Observer + ?Sized, E: StepEquation<A, W>>(
    mut experience: Experience<A>,
    equation: E,
    convergence: Convergence,
    watch: &mut W,
) -> (Result<Solution<A>, Refusal>, Experience<A>) {
    let distant = Distant {
        origin: equation.origin(),
        guess: explicit_guess(equation),
        standstill: equation.standstill(),
        is_bound_by_energy: equation.is_bound_by_energy(),
        effort: E::EFFORT,
        magnitudes: E::MAGNITUDES,
        convergence,
    };
    let solution = experience.try_searches(&distant, &mut ResidualOf { equation, watch });
    (solution, experience)
}

impl<A: Array> Experience<A> {
    /// Tries one search after the other. Each one starts from the experience before the first one. If all fail, the experience is not valid.
    ///
    /// # Errors
    /// With quadratic convergence, the refusal of the last search. With linear convergence, the refusal of the first one, because the derivative of
    /// later searches is not that of the equation.
    #[inline(never)]
    fn try_searches(&mut self, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> Result<Solution<A>, Refusal> {
        let start = *self;
        let found = self.search(&equation.guess, GuessKind::Explicit, equation, residual);
        if found.is_ok() || equation.effort == Effort::Fast {
            return found;
        }
        match equation.convergence {
            Convergence::Quadratic => {
                *self = start;
                self.search_after_damping(equation, residual)
            }
            Convergence::Linear => {
                // There is no last correction here. The guess takes its place, and scales the distances of the measurement.
                let noise =
                    self.noise(&equation.guess, Stalled { delta: equation.guess, distance: 1.0 }, equation, residual);
                *self = start;
                let (origin, mut sizes) = (equation.origin, self.sizes);
                sizes.include(&origin, &equation.guess);
                let mut differences = Differences { residual, origin, sizes, noise, paused: false };
                let solution = match self.search(&equation.guess, GuessKind::Explicit, equation, &mut differences) {
                    Ok(solution) => solution,
                    Err(_) => {
                        *self = start;
                        self.search_after_damping(equation, &mut differences).or(found)?
                    }
                };
                // The last evaluation must be that of the solution, not of a difference quotient.
                differences.residual.at(&solution.x, &mut A::fill(A::zero()));
                Ok(solution)
            }
        }
    }

    /// Iterates from the end of damped corrections.
    fn search_after_damping(
        &mut self,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Solution<A>, Refusal> {
        let guess =
            damped::approach(&equation.origin, equation.standstill, &self.sizes, |x, matrix| residual.at(x, matrix));
        self.search(&guess, GuessKind::Damped, equation, residual)
    }

    /// Iterates from a guess. Refuses a solution after many evaluations, or after damped corrections, that is not connected to h = 0.
    fn search(
        &mut self,
        guess: &A,
        kind: GuessKind,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Solution<A>, Refusal> {
        // The sizes before the search. Later sizes include a solution that may be wrong.
        let sizes = self.sizes;
        let Converged { solution, evaluations } = self.converge(guess, equation, residual)?;
        if (kind == GuessKind::Damped || evaluations > MOST_EVALUATIONS) && !equation.is_bound_by_energy {
            let is_continuous = equation.effort == Effort::Thorough
                && Continuation { sizes, units: self.units, equation, residual }.is_continuous(&solution.x);
            if !is_continuous {
                return Err(Refusal::Singular);
            }
            // The observer, and methods that use the last evaluation, need the solution as the last point.
            residual.at(&solution.x, &mut A::fill(A::zero()));
        }
        self.choose_next_guess(evaluations, false);
        Ok(solution)
    }

    /// Corrects a guess until nothing but rounding is left. A first correction ends the iteration only if it is zero: far away it may be small although the
    /// next one is larger.
    ///
    /// # Errors
    /// [`Refusal::Singular`] if the matrix is singular, or its determinant at the solution is negative. [`Refusal::NotConverged`] after
    /// [`MAX_ITERATIONS`] evaluations, or after a residual or correction that is not finite. With [`Effort::Fast`], also if corrections stop shrinking and the
    /// last digits do not explain the residual.
    fn converge(
        &mut self,
        guess: &A,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Converged<A>, Refusal> {
        let Distant { origin, effort, magnitudes, convergence, .. } = *equation;
        let mut solution = Solution::of(*guess);
        // Pivots are compared in units of these sizes. Corrections are not, because a guess that is far off would inflate the sizes.
        let mut pivot_sizes = self.sizes;
        pivot_sizes.include(&origin, guess);
        let mut matrix = A::fill(A::zero());
        let (mut corrections, mut stalled) = (Corrections::of(convergence), None);
        for evaluations in 1..=MAX_ITERATIONS {
            let x = solution.x;
            let r = residual.at(&x, &mut matrix);
            // First integrals may be steep. For them only a thorough attempt may take a residual for rounding, because the caller checks such a step.
            let may_be_accepted = effort == Effort::Thorough || magnitudes == Magnitudes::Recent;
            let last = stalled.take();
            // Linear convergence is always slow, so the residual is examined only if corrections stop shrinking.
            let is_suspect = last.is_some() || convergence == Convergence::Quadratic && corrections.slow();
            let mut is_rounding =
                may_be_accepted && is_suspect && is_of_last_digits(&self.sizes.with(&origin), &r, &matrix);
            if let (false, Some(last)) = (is_rounding, last) {
                if effort == Effort::Fast {
                    break;
                }
                is_rounding = self.is_noise(&x, last, equation, residual);
            }
            let mut delta = r;
            let is_positive = match linear::solve(&mut matrix, &mut delta, &pivot_sizes) {
                Some(is_positive) => is_positive,
                None if delta.is_finite() => return Err(Refusal::Singular),
                None => break,
            };
            let mut is_solved = is_rounding;
            if !is_rounding {
                solution = Solution::corrected(&x, &delta);
                let correction = self.sizes.relative(&delta, &origin, &solution.x);
                if evaluations == 2 && convergence == Convergence::Quadratic {
                    self.measure_curvature(correction, corrections.last());
                }
                match corrections.judge::<A::Real>(correction) {
                    // A huge derivative makes every correction small, so the residual has to be small, too.
                    Verdict::Solved => is_solved = self.sizes.resolve(&r, &origin, &x),
                    Verdict::Stuck => {
                        stalled = Some(Stalled { delta, distance: corrections.distance() });
                        corrections.restart();
                    }
                    Verdict::Continue => {}
                }
                if !correction.is_finite() {
                    break;
                }
            }
            if is_solved && !is_positive {
                return Err(Refusal::Singular);
            }
            if is_solved {
                self.sizes.include(&origin, &solution.x);
                return Ok(Converged { solution, evaluations });
            }
        }
        Err(corrections.not_converged())
    }

    /// Returns whether the measured rounding explains the residual at x.
    fn is_noise(&self, x: &A, last: Stalled<A>, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> bool {
        let noise = self.noise(x, last, equation, residual);
        let mut sizes = self.sizes;
        sizes.include(&equation.origin, x);
        // x is evaluated last, because the observer remembers the last point.
        noise::explains(&noise, &residual.at(x, &mut A::fill(A::zero())), &sizes)
    }

    /// Returns the standard deviation of the rounding of the residual at x. The points of the measurement are a pause for the observer.
    fn noise(
        &self,
        x: &A,
        Stalled { delta, distance }: Stalled<A>,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> A {
        let (mut unused, mut sizes) = (A::fill(A::zero()), self.sizes);
        sizes.include(&equation.origin, x);
        residual.pause(true);
        let noise = noise::measure(&sizes, x, (&delta, distance), self.units, |x| Some(residual.at(x, &mut unused)));
        residual.pause(false);
        noise
    }
}

/// The origin of a guess.
#[derive(Clone, Copy, PartialEq, Eq)]
enum GuessKind {
    /// The guess at the start of the step, which is near the solution of a short step.
    Explicit,
    /// The end of damped corrections, which may be near any solution.
    Damped,
}

/// A solution, and the number of evaluations that it took.
struct Converged<A> {
    solution: Solution<A>,
    evaluations: u32,
}

/// The state of an iteration whose corrections stopped shrinking.
struct Stalled<A> {
    /// The last correction.
    delta: A,
    /// The distance of the points at which rounding is measured, in units of `delta`.
    distance: f64,
}

/// Returns the addresses of the searches for one shape of unknowns. Only functions that are named somewhere are compiled with this crate: `private::compiled`
/// names these for usual shapes, so programs need not compile them.
pub(crate) fn compiled<A: Array>() -> [*const (); 2] {
    [Experience::<A>::try_searches as *const (), Experience::<A>::converge as *const ()]
}
