//! Long searches for a solution of r(x) = 0. They rescue the steps that Newton's loop does not solve in a few evaluations. They are the only iteration of
//! [`QuasiNewton`](super::quasi_newton), whose derivative is approximate.
//!
//! 1. The first search starts from the explicit guess, computed at the start of the step, and makes at most 100 corrections. If corrections stop shrinking,
//!    or shrink slowly where convergence should be quadratic, x is accepted if the last digits of coordinates explain the residual. With [`Effort::Thorough`], measured rounding ([`noise`]) may explain it, too.
//! 2. With [`Effort::Thorough`] and an approximate derivative, the first search is repeated with a matrix of difference quotients.
//! 3. With [`Effort::Thorough`], the last search starts from the end of [`damped`] corrections.
//!
//! A solution after more than five evaluations, or after damped corrections, need not continue the solution from h = 0, where h is the step size. With
//! [`Effort::Thorough`], `branch` tests it. With [`Effort::Fast`], the step is refused, and the caller repeats it.
//!
//! Equations with [`Branch::OfEnergy`](crate::method::implicit::Branch::OfEnergy) are exempt, because all their solutions satisfy the balance of the energy
//! or of a first integral. Limit: they need not continue the solution from h = 0.

use super::branch::Continuation;
use super::differences::Differences;
use super::distant::{Distant, Residual, ResidualOf};
use super::equation::{Magnitudes, Solution, StepEquation, explicit_guess};
use super::experience::{Experience, MOST_EVALUATIONS};
use super::noise::LastCorrection;
use super::rounding::{Convergence, Corrections, MAX_ITERATIONS, Verdict, is_of_last_digits};
use super::{Effort, Failure, Observer, damped, linear, noise};
use crate::space::Array;

/// Solves an equation from the explicit guess. Returns the changed experience, too, which is invalid after an error.
#[cold]
#[inline(never)]
pub(super) fn solve_from_explicit_guess<A: Array, W: Observer + ?Sized, E: StepEquation<A, W>>(
    mut experience: Experience<A>,
    equation: E,
    convergence: Convergence,
    watch: &mut W,
) -> (Result<Solution<A>, Failure>, Experience<A>) {
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
    /// Tries one search after the other. Each one starts from the experience before the first one. If all fail, the experience is invalid.
    ///
    /// # Errors
    /// With quadratic convergence, the refusal of the last search. With linear convergence, the refusal of the first one, because the derivative of
    /// later searches is not that of the equation.
    #[inline(never)]
    fn try_searches(&mut self, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> Result<Solution<A>, Failure> {
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
                // There is no last correction at the guess. The guess takes its place, and scales the distances of the measurement.
                let last = LastCorrection { delta: equation.guess, multiple: 1.0 };
                let noise = self.noise(&equation.guess, last, equation, residual);
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
    ) -> Result<Solution<A>, Failure> {
        let guess =
            damped::approach(&equation.origin, equation.standstill, &self.sizes, |x, matrix| residual.at(x, matrix));
        self.search(&guess, GuessKind::Damped, equation, residual)
    }

    /// Iterates from a guess. A solution after many evaluations, or after damped corrections, must pass the test of [`branch`](super::branch), or be bound by
    /// energy.
    ///
    /// # Errors
    /// The errors of [`converge`](Self::converge). [`Failure::Singular`] also if the solution fails this test, or is not tested because of [`Effort::Fast`].
    fn search(
        &mut self,
        guess: &A,
        kind: GuessKind,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Solution<A>, Failure> {
        // The sizes before the search. Later sizes include a solution that may be wrong.
        let sizes = self.sizes;
        let Converged { solution, evaluations } = self.converge(guess, equation, residual)?;
        if (kind == GuessKind::Damped || evaluations > MOST_EVALUATIONS) && !equation.is_bound_by_energy {
            let is_continuous = equation.effort == Effort::Thorough
                && Continuation { sizes, units: self.units, equation, residual }.is_continuous(&solution.x);
            if !is_continuous {
                return Err(Failure::Singular);
            }
            // The observer, and methods that read the last evaluation, need the solution as the last point.
            residual.at(&solution.x, &mut A::fill(A::zero()));
        }
        self.choose_next_guess(evaluations, false);
        Ok(solution)
    }

    /// Corrects a guess until only rounding is left. A first correction ends the iteration only if it is zero: far away it may be small although the next one
    /// is larger.
    ///
    /// # Errors
    /// [`Failure::Singular`] if a matrix is singular, or if the determinant at the solution is negative. [`Failure::NotConverged`] after [`MAX_ITERATIONS`]
    /// evaluations, or after a residual or correction that is not finite. With [`Effort::Fast`], also if corrections are stuck and the last digits do not
    /// explain the residual.
    fn converge(
        &mut self,
        guess: &A,
        equation: &Distant<A>,
        residual: &mut dyn Residual<A>,
    ) -> Result<Converged<A>, Failure> {
        let Distant { origin, effort, magnitudes, convergence, .. } = *equation;
        let mut solution = Solution::of(*guess);
        // Pivots are compared in units of these sizes. Corrections are not: a guess that is far off would inflate the sizes.
        let mut pivot_sizes = self.sizes;
        pivot_sizes.include(&origin, guess);
        let mut matrix = A::fill(A::zero());
        let (mut corrections, mut stuck) = (Corrections::of(convergence), None);
        for evaluations in 1..=MAX_ITERATIONS {
            let x = solution.x;
            let r = residual.at(&x, &mut matrix);
            // With `Magnitudes::Present`, which belongs to steep first integrals such as logarithms, only a thorough attempt may take a residual for rounding,
            // because the method then checks the integrals.
            let may_be_accepted = effort == Effort::Thorough || magnitudes == Magnitudes::Recent;
            let last = stuck.take();
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
                None if delta.is_finite() => return Err(Failure::Singular),
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
                    Verdict::Solved => is_solved = self.sizes.residual_is_small(&r, &origin, &x),
                    Verdict::Stuck => {
                        stuck = Some(LastCorrection { delta, multiple: corrections.distance() });
                        corrections.restart();
                    }
                    Verdict::Continue => {}
                }
                if !correction.is_finite() {
                    break;
                }
            }
            if is_solved && !is_positive {
                return Err(Failure::Singular);
            }
            if is_solved {
                self.sizes.include(&origin, &solution.x);
                return Ok(Converged { solution, evaluations });
            }
        }
        Err(corrections.not_converged())
    }

    /// Returns whether the measured rounding explains the residual at x.
    fn is_noise(&self, x: &A, last: LastCorrection<A>, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> bool {
        let noise = self.noise(x, last, equation, residual);
        let mut sizes = self.sizes;
        sizes.include(&equation.origin, x);
        // The observer needs x as the last point.
        noise::explains(&noise, &residual.at(x, &mut A::fill(A::zero())), &sizes)
    }

    /// Returns the estimated rounding of every entry of the residual at x; see [`noise::measure`]. The observer is paused.
    fn noise(&self, x: &A, last: LastCorrection<A>, equation: &Distant<A>, residual: &mut dyn Residual<A>) -> A {
        let (mut unused, mut sizes) = (A::fill(A::zero()), self.sizes);
        sizes.include(&equation.origin, x);
        residual.pause(true);
        let noise = noise::measure(&sizes, x, last, self.units, |x| Some(residual.at(x, &mut unused)));
        residual.pause(false);
        noise
    }
}

/// The origin of a guess.
#[derive(Clone, Copy, PartialEq, Eq)]
enum GuessKind {
    /// The guess from the start of the step, which is near the solution of a short step.
    Explicit,
    /// The end of damped corrections, which may be near any solution.
    Damped,
}

/// A solution, and the number of evaluations that it took.
struct Converged<A> {
    solution: Solution<A>,
    evaluations: u32,
}

/// Returns the addresses of the searches for one shape of unknowns. Generic functions are compiled with this crate only if it names them: `private::compiled`
/// names them for usual shapes.
pub(crate) fn compiled<A: Array>() -> [*const (); 2] {
    [Experience::<A>::try_searches as *const (), Experience::<A>::converge as *const ()]
}
