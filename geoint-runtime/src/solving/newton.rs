//! Newton's iteration for the unknown of one step: x ← x − J⁻¹ r(x), where J is the derivative of the residual r.
//!
//! A step predicts x from the unknowns of the steps before, evaluates r and J, and corrects x. Corrections shrink as |c₂| ≤ C |c₁|², and at least each 64th
//! step measures C. A step accepts x if the next correction is expected to be below 2⁻²⁰ ε ([`REMAINDER`]), relative to the size of each entry; ε is the
//! machine epsilon. Corrections that consist of rounding also end the loop. No tolerance of the user does, because a step is symmetric, and keeps the energy,
//! only at the solution. Limit: C is an estimate, and no bound.
//!
//! The determinant of J is positive in short steps of length h. If it is negative at a solution, the solutions from h = 0 to here pass a singular point. A
//! determinant that is not positive therefore ends the loop, and [`rescue`] refuses a solution at which it is negative. Limit: a positive determinant proves
//! nothing, because two changes of its sign cancel.
//!
//! The loop makes at most five evaluations. An equation that takes more, or whose guess is far off, goes to [`rescue`].
//!
//! More than 12 unknowns are first iterated without a matrix, as x ← x − r(x). This iteration has evaluations of its own, as long as each correction is at
//! most 0.3 times the one before. If it fails, Newton's loop starts again from the guess. Limit: the iteration without a matrix checks no determinant.
//!
//! All functions of this loop are inlined, so the state of the solver stays in local variables of the run. Cold functions take and return copies: a pointer to
//! the state would keep it in memory, and the next step would wait for it.

use super::equation::{Magnitudes, Solution, Solver, StepEquation, Units, explicit_guess};
use super::experience::{Experience, MOST_EVALUATIONS};
use super::predictor::Predictor;
use super::rounding::{Convergence, REMAINDER, is_rounding};
use super::size::Sizes;
use super::{Effort, Failure, Observer, linear, rescue};
use crate::ablation;
use crate::scalar::Real;
use crate::space::vector::difference;
use crate::space::{Array, Record, Tape};

/// With more unknowns than this, an elimination costs more than the evaluations that it saves, so the fixed-point iteration is tried first. The attribute
/// macros have the same constant, and a test compares both.
pub const MOST_UNKNOWNS: usize = 12;

/// The largest first correction of an extrapolated guess, in units of the sizes. After a larger one the iteration may reach another solution. A smaller limit
/// would send more steps to [`rescue`].
const FIRST_CORRECTION_LIMIT: f64 = 1.0 / 8.0;

/// The largest ratio of successive corrections with which the fixed-point iteration continues. A larger ratio takes more evaluations, and is a weaker sign of a
/// contraction. With a smaller limit, more steps need a matrix.
const CONTRACTION_LIMIT: f64 = 0.3;

/// Solves one equation per step. Precondition: successive steps have equal lengths h. Otherwise extrapolated guesses are poor, and the reach of corrections
/// belongs to another h, because C depends on h.
#[derive(Clone, Copy, Debug)]
pub struct Newton<A> {
    predictor: Predictor<A>,
    experience: Experience<A>,
}

impl<A: Array> Record<A::Real> for Newton<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.predictor.record(tape);
        self.experience.record(tape);
    }
}

impl<A: Array> Solver<A> for Newton<A> {
    fn new(units: Units) -> Self {
        Newton { predictor: Predictor::new(), experience: Experience::new(units) }
    }

    #[inline(always)]
    fn solve<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Result<Solution<A>, Failure> {
        if const { matches!(E::MAGNITUDES, Magnitudes::Present) } {
            self.experience.sizes = Sizes::at(&equation.origin());
        }
        let solution = match self.iterate(equation, watch) {
            Some(solution) => solution,
            None => {
                let (solution, experience) =
                    rescue::solve_from_explicit_guess(self.experience, *equation, Convergence::Quadratic, watch);
                self.experience = experience;
                solution?
            }
        };
        self.predictor.push(&solution.x);
        self.experience.steps = self.experience.steps.wrapping_add(1);
        Ok(solution)
    }
}

impl<A: Array> Newton<A> {
    /// Makes up to [`MOST_EVALUATIONS`] corrections of a guess. Returns `None` if they shrink too slowly, if they may lead to another solution, or if
    /// [`solve_fast`](linear::solve_fast) fails. The caller then starts again in [`rescue`].
    #[inline(always)]
    fn iterate<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Option<Solution<A>> {
        // Thorough steps are rare. Their equations are compiled once, for `rescue`.
        if const { matches!(E::EFFORT, Effort::Thorough) } {
            return None;
        }
        let (origin, experience) = (equation.origin(), &mut self.experience);
        let (extrapolates, measures) = (experience.extrapolates, experience.measures());
        let mut x = if extrapolates { self.predictor.predict() } else { explicit_guess(*equation) };
        if const { ablation::FIXED_POINT && A::LEN > MOST_UNKNOWNS }
            && let Some(x) = experience.fixed_point(x, equation, watch)
        {
            return Some(Solution::of(x));
        }
        let (mut matrix, mut before) = (A::fill(A::zero()), f64::INFINITY);
        for evaluation in 1..=MOST_EVALUATIONS {
            let (residual, point) = (equation.residual(watch, &x, &mut matrix), x);
            let mut delta = residual;
            if !linear::solve_fast(&mut matrix, &mut delta) {
                return None;
            }
            let solution = Solution::corrected(&x, &delta);
            x = solution.x;
            let next_is_negligible = extrapolates && experience.sizes.all_within(&delta, experience.reach);
            // Present magnitudes belong to steep first integrals, for which C may be out of date. Later evaluations compare two corrections instead. Limit: the
            // first evaluation relies on C all the same, because it has no earlier correction to compare with.
            let is_trusted = evaluation == 1 || matches!(E::MAGNITUDES, Magnitudes::Recent);
            if next_is_negligible && is_trusted && (evaluation > 2 || !measures) {
                if evaluation > 1 {
                    experience.choose_next_guess(evaluation, extrapolates);
                }
                return Some(solution);
            }
            if evaluation == 1 && extrapolates && !experience.sizes.all_within(&delta, FIRST_CORRECTION_LIMIT) {
                return None;
            }
            let correction = experience.sizes.relative(&delta, &origin, &x);
            if evaluation == 2 {
                experience.measure_curvature(correction, before);
            }
            let is_last = correction == 0.0 || evaluation > 1 && is_last::<A::Real>(correction, before);
            // Far from a solution the derivative may be huge. Corrections are then small although the residual is not. Extrapolated guesses count as near.
            if is_last && (extrapolates || experience.sizes.residual_is_small(&residual, &origin, &point)) {
                experience.sizes.include(&origin, &x);
                experience.choose_next_guess(evaluation, extrapolates);
                return Some(solution);
            }
            before = correction;
        }
        None
    }
}

impl<A: Array> Experience<A> {
    /// Iterates x ← x − r(x) = g(x) as long as each correction is at most [`CONTRACTION_LIMIT`] times the one before. Returns `None` after a correction that is
    /// larger than that and is not rounding. Fast convergence is taken as the sign of a contraction, which has one solution. Limit: no determinant is
    /// checked.
    #[inline(always)]
    fn fixed_point<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &mut self,
        guess: A,
        equation: &E,
        watch: &mut W,
    ) -> Option<A> {
        let (origin, mut x, mut before) = (equation.origin(), guess, f64::INFINITY);
        loop {
            let next = equation.image(watch, &x);
            let delta = difference(&x, &next);
            x = next;
            let correction = self.sizes.relative(&delta, &origin, &x);
            let next_correction = correction * (correction / before);
            let converged =
                correction == 0.0 || before.is_finite() && next_correction <= REMAINDER * A::Real::epsilon();
            let slow = correction.is_nan() || correction > CONTRACTION_LIMIT * before;
            if converged || slow && is_rounding::<A::Real>(correction) {
                self.sizes.include(&origin, &x);
                // The number 0 counts the guess as good: evaluations without a matrix are cheap.
                self.choose_next_guess(0, true);
                return Some(x);
            }
            if slow {
                return None;
            }
            before = correction;
        }
    }
}

/// Returns whether c₂ = `correction` after c₁ = `before` is the last correction. It is if the next one, about c₂(c₂/c₁)² with quadratic convergence, is below
/// 2⁻²⁰ ε, or if rounding keeps corrections from shrinking. Both are relative to sizes.
#[inline(always)]
fn is_last<R: Real>(correction: f64, before: f64) -> bool {
    let shrunk = correction / before;
    correction * shrunk * shrunk <= REMAINDER * R::epsilon() || shrunk > 0.5 && is_rounding::<R>(correction)
}
