//! Equations that Newton's iteration does not solve in a few evaluations, and equations whose derivative is known approximately.
//!
//! 1. From the guess at the start of the step, with at most 100 evaluations. If corrections stop shrinking, the solution is accepted if the residual is rounding
//!    of the last digits of coordinates, or, with [`Effort::Thorough`], if its rounding is measured to be as large ([`noise`]).
//! 2. With [`Effort::Thorough`] and an approximate derivative, the same with a matrix of difference quotients.
//! 3. With [`Effort::Thorough`], from the end of [`damped`] corrections.
//!
//! A solution that took many corrections may not be continuous in h. With [`Effort::Thorough`], [`branch`] follows it to h = 0. With [`Effort::Fast`], the step
//! is refused, and the caller repeats it. The searches are compiled once for all equations with the same number of unknowns.

use super::branch::Continuation;
use super::differences::Differences;
use super::distant::{Distant, Residual, ResidualOf};
use super::equation::{Magnitudes, Solution, StepEquation, explicit_guess};
use super::experience::{Experience, MOST_EVALUATIONS};
use super::rounding::{Convergence, Corrections, MAX_ITERATIONS, Verdict, is_of_last_digits};
use super::{Effort, Observer, Refusal, damped, linear, noise};
use crate::space::Array;

/// Solves an equation from the start of the step. Returns the changed experience, too.
#[cold]
#[inline(never)]
pub(super) fn from_start<A: Array, W: Observer + ?Sized, E: StepEquation<A, W>>(
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
    let solution = experience.rescue(&distant, &mut ResidualOf { equation, watch });
    (solution, experience)
}

impl<A: Array> Experience<A> {
    /// Tries one way after the other. Each one starts from the experience before the first one. If all fail, the caller discards the experience.
    #[inline(never)]
    fn rescue(&mut self, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> Result<Solution<A>, Refusal> {
        let start = *self;
        let found = self.search(&equation.guess, Distance::Near, equation, residual);
        if found.is_ok() || equation.effort == Effort::Fast {
            return found;
        }
        match equation.convergence {
            Convergence::Quadratic => {
                *self = start;
                self.search_from_afar(equation, residual)
            }
            Convergence::Linear => {
                // The guess is the direction of the measurement.
                let noise =
                    self.noise(&equation.guess, Stalled { delta: equation.guess, distance: 1.0 }, equation, residual);
                *self = start;
                let (origin, mut sizes) = (equation.origin, self.sizes);
                sizes.include(&origin, &equation.guess);
                let mut differences = Differences { residual, origin, sizes, noise };
                let solution = match self.search(&equation.guess, Distance::Near, equation, &mut differences) {
                    Ok(solution) => solution,
                    Err(_) => {
                        *self = start;
                        self.search_from_afar(equation, &mut differences).or(found)?
                    }
                };
                // The observer must see the solution last, not a point of a difference quotient.
                differences.residual.at(&solution.x, &mut A::fill(A::zero()));
                Ok(solution)
            }
        }
    }

    /// Iterates from the end of damped corrections.
    fn search_from_afar(
        &mut self,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Solution<A>, Refusal> {
        let guess =
            damped::approach(&equation.origin, equation.standstill, &self.sizes, |x, matrix| residual.at(x, matrix));
        self.search(&guess, Distance::Far, equation, residual)
    }

    /// Iterates from a guess, and checks that a solution after many corrections is connected to h = 0.
    fn search(
        &mut self,
        guess: &A,
        distance: Distance,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Solution<A>, Refusal> {
        // The sizes before the search: the solution may be wrong.
        let sizes = self.sizes;
        let Converged { solution, evaluations } = self.converge(guess, equation, residual)?;
        if (distance == Distance::Far || evaluations > MOST_EVALUATIONS) && !equation.is_bound_by_energy {
            let is_continuous = equation.effort == Effort::Thorough
                && Continuation { sizes, units: self.units, equation, residual }.is_continuous(&solution.x);
            if !is_continuous {
                return Err(Refusal::Singular);
            }
            // The observer, and methods that use the last evaluation, must see the solution last.
            residual.at(&solution.x, &mut A::fill(A::zero()));
        }
        self.settle(evaluations, false);
        Ok(solution)
    }

    /// Corrects a guess until nothing but rounding is left. One correction is not enough, however small it is: far away it may be small although the next one is
    /// larger.
    fn converge(
        &mut self,
        guess: &A,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Converged<A>, Refusal> {
        let Distant { origin, effort, magnitudes, convergence, .. } = *equation;
        let mut solution = Solution::of(*guess);
        // Pivots are compared in units of these sizes. Corrections are not, because a guess that is far off would inflate them.
        let mut pivots = self.sizes;
        pivots.include(&origin, guess);
        let mut matrix = A::fill(A::zero());
        let (mut corrections, mut stalled) = (Corrections::of(convergence), None);
        for evaluations in 1..=MAX_ITERATIONS {
            let x = solution.x;
            let left = residual.at(&x, &mut matrix);
            // First integrals may be steep. For them only a thorough attempt may take a residual for rounding, because the caller checks such a step.
            let decides = effort == Effort::Thorough || magnitudes == Magnitudes::Recent;
            let last = stalled.take();
            // Linear convergence is always slow, so the residual is examined only if corrections stop shrinking.
            let is_suspect = last.is_some() || convergence == Convergence::Quadratic && corrections.slow();
            let mut is_rounding = decides && is_suspect && is_of_last_digits(&self.sizes.with(&origin), &left, &matrix);
            if let (false, Some(last)) = (is_rounding, last) {
                if effort == Effort::Fast {
                    break;
                }
                is_rounding = self.is_noise(&x, last, equation, residual);
            }
            let mut delta = left;
            let is_positive = match linear::solve(&mut matrix, &mut delta, &pivots) {
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
                    // A huge derivative makes every correction small.
                    Verdict::Solved => is_solved = self.sizes.resolve(&left, &origin, &x),
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

    /// Returns whether the residual at x is rounding, by measurement.
    fn is_noise(&self, x: &A, last: Stalled<A>, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> bool {
        let noise = self.noise(x, last, equation, residual);
        let mut sizes = self.sizes;
        sizes.include(&equation.origin, x);
        // The solution is evaluated last, because the observer remembers the last point.
        noise::explains(&noise, &residual.at(x, &mut A::fill(A::zero())), &sizes)
    }

    /// Returns the rounding of the residual at x.
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

/// The distance of a guess from the solution of a short step.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Distance {
    Near,
    Far,
}

/// A solution, and the number of evaluations that it took.
struct Converged<A> {
    solution: Solution<A>,
    evaluations: u32,
}

/// The last correction of an iteration whose corrections stopped shrinking, and the distance of the points at which rounding is measured, in units of this correction.
struct Stalled<A> {
    delta: A,
    distance: f64,
}

/// The addresses of what is compiled once for a shape of unknowns.
pub(crate) fn compiled<A: Array>() -> [*const (); 2] {
    [Experience::<A>::rescue as *const (), Experience::<A>::converge as *const ()]
}
