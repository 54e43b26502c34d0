//! Solves equations by Newton's iteration with an approximate derivative. Convergence is linear, not quadratic.

use super::equation::{Solution, Solver, StepEquation, Units, explicit_guess};
use super::rounding::{Corrections, MAX_ITERATIONS, Verdict, is_of_last_digits};
use super::size::{Sizes, largest, sum};
use super::{Observer, Refusal, damped, linear, noise};
use crate::scalar::Real;
use crate::space::{Array, Record, Square, Tape};

/// A solver of one equation per step. It remembers the sizes of the unknowns.
#[derive(Clone, Copy, Debug)]
pub struct QuasiNewton<A> {
    sizes: Sizes<A>,
    units: Units,
}

impl<A: Array> Record<A::Real> for QuasiNewton<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sizes.record(tape);
    }
}

impl<A: Array> Solver<A> for QuasiNewton<A> {
    fn new(units: Units) -> Self {
        QuasiNewton { sizes: Sizes::new(), units }
    }

    /// Iterates from the guess. If the iteration fails, it is repeated with a matrix of difference quotients. If the repetition fails, it starts again from the end
    /// of damped corrections.
    ///
    /// The iteration ends if the predicted next correction is below rounding. If corrections stop shrinking, it ends if the residual is rounding. As in Newton's
    /// iteration, a solution with a negative determinant is refused. If all attempts fail, the first refusal is returned.
    #[inline(always)]
    fn solve<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Result<Solution<A>, Refusal> {
        let (guess, mut noise) = (explicit_guess(*equation), A::zero());
        // These sizes serve pivots and difference quotients. The guess may be far off, so corrections are not compared with them.
        let mut scale = self.sizes;
        scale.include(&equation.origin(), &guess);
        self.iterate(equation, Start { x: guess, scale: &scale }, None, &mut noise, watch).or_else(|refusal| {
            self.retry(*equation, Start { x: guess, scale: &scale }, noise, watch).map_err(|_| refusal)
        })
    }
}

/// Where an iteration starts, and sizes for pivots and difference quotients.
#[derive(Clone, Copy)]
struct Start<'a, A> {
    x: A,
    scale: &'a Sizes<A>,
}

impl<A: Array> QuasiNewton<A> {
    /// Repeats the iteration with difference quotients, then from the end of damped corrections.
    #[cold]
    fn retry<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: E,
        start: Start<'_, A>,
        seen: A,
        watch: &mut W,
    ) -> Result<Solution<A>, Refusal> {
        let mut noise = seen;
        self.iterate(&equation, start, Some(&seen), &mut noise, watch).or_else(|_| {
            let origin = equation.origin();
            let x = damped::approach(&origin, 0.0, start.scale, |x, r, matrix| {
                *r = equation.residual(watch, x, matrix);
                differentiate(&equation, start.scale, (x, r), &seen, matrix, watch);
                Ok(())
            });
            self.iterate(&equation, Start { x, ..start }, Some(&seen), &mut noise, watch)
        })
    }

    /// Iterates from a start. If `differences` is present, the matrix consists of difference quotients, and `differences` is the noise of the residual
    /// that they have to exceed. `noise` becomes the noise at the point where the iteration was stuck last.
    fn iterate<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        Start { mut x, scale }: Start<'_, A>,
        differences: Option<&A>,
        noise: &mut A,
        watch: &mut W,
    ) -> Result<Solution<A>, Refusal> {
        let origin = &equation.origin();
        let mut corrections = Corrections::of_order(1);
        let mut matrix = A::fill(A::zero());
        for _ in 0..MAX_ITERATIONS {
            let left = equation.residual(watch, &x, &mut matrix);
            if let Some(seen) = differences {
                differentiate(equation, scale, (&x, &left), seen, &mut matrix, watch);
            }
            let mut delta = left;
            let positive = linear::solve(&mut matrix, &mut delta, scale).ok_or(Refusal::Singular)?;
            let before = x;
            x.add_scaled(A::Real::from_f64(-1.0), &delta);
            let relative = self.sizes.relative(&delta, origin, &x);
            let mut solved = None;
            match corrections.judge::<A::Real>(relative) {
                // A huge matrix makes every correction small. The residual must be small as well.
                Verdict::Solved if self.sizes.resolve(&left, origin, &before) => solved = Some(Solution::of(x)),
                Verdict::Solved => break,
                Verdict::Stuck => {
                    let (mut left, mut sizes) = (equation.residual(watch, &before, &mut matrix), self.sizes);
                    // Without the size of x: far from all earlier states, any residual would pass as rounding.
                    sizes.include(origin, &A::zero());
                    let mut rounding = is_of_last_digits(&sizes, &left, &matrix);
                    if !rounding {
                        sizes.include(origin, &before);
                        watch.pause(true);
                        *noise = noise::measure(&sizes, &before, (&delta, corrections.distance()), self.units, |x| {
                            Some(equation.residual(watch, x, &mut matrix))
                        });
                        watch.pause(false);
                        // The solution is evaluated last, because the observer remembers the last point.
                        left = equation.residual(watch, &before, &mut matrix);
                        rounding = noise::explains(noise, &left, &sizes);
                    }
                    solved = rounding.then(|| Solution { leaves_noise: true, ..Solution::of(before) });
                    corrections.restart();
                }
                Verdict::Continue => {}
            }
            if let Some(solution) = solved {
                // The observer must see the solution last, not a point of a difference quotient.
                if differences.is_some() {
                    equation.residual(watch, &solution.x, &mut matrix);
                }
                self.sizes.include(origin, &solution.x);
                return if positive { Ok(solution) } else { Err(Refusal::Singular) };
            }
            if !relative.is_finite() {
                break;
            }
        }
        Err(corrections.not_converged())
    }
}

/// Computes the derivative of the residual `r` at `x` by difference quotients. A column whose unknown has no size stays unchanged. Unknowns move so
/// far that the `noise` of the residual is a small part of its change.
fn differentiate<A: Array, W: Observer, E: StepEquation<A, W>>(
    equation: &E,
    sizes: &Sizes<A>,
    (x, r): (&A, &A),
    noise: &A,
    matrix: &mut Square<A>,
    watch: &mut W,
) {
    let origin = equation.origin();
    let size = |i: usize| sizes.of(i).max(sum(&origin, x, i));
    let parts = (0..A::LEN).filter(|i| size(*i) > 0.0).map(|i| noise.as_slice()[i].magnitude() / size(i));
    // The part is √ε, or noise/√ε if the relative noise exceeds ε. A quotient over a distance above ε^(1/4) is no derivative.
    let root = Real::sqrt(A::Real::epsilon());
    let part = (A::Real::epsilon().max(largest(parts)) / root).min(Real::sqrt(root));
    let mut unused = A::fill(A::zero());
    watch.pause(true);
    for j in 0..A::LEN {
        let mut moved = *x;
        moved.as_mut_slice()[j] += A::Real::from_f64(part * size(j));
        let distance = moved.as_slice()[j] - x.as_slice()[j];
        if distance.magnitude() == 0.0 {
            continue;
        }
        let there = equation.residual(watch, &moved, &mut unused);
        for (i, row) in A::entries::<A>(matrix).iter_mut().enumerate() {
            row.as_mut_slice()[j] = (there.as_slice()[i] - r.as_slice()[i]) / distance;
        }
    }
    watch.pause(false);
}
