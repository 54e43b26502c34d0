//! Solves equations by Newton's iteration with an approximate derivative. Corrections shrink by a factor, not by squares.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::equation::Observer;
use crate::solving::rounding::{Corrections, MAX_ITERATIONS, Verdict, is_of_last_digits};
use crate::solving::size::{Sizes, largest, sum};
use crate::solving::{damped, linear, noise};
use crate::space::{Array, Record, Square, Tape};

/// A solver of one equation per step for increments of positions and momenta. It remembers the sizes of the unknowns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuasiNewton<A> {
    sizes: Sizes<A>,
    /// `true` if the last solution leaves a residual that was measured as rounding.
    pub(crate) leaves_rounding: bool,
}

impl<A: Array> Record<A::Real> for QuasiNewton<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        // `leaves_rounding` is not recorded, because it is read before the step ends.
        self.sizes.record(tape);
    }
}

impl<A: Array> QuasiNewton<A> {
    pub(crate) fn new() -> Self {
        QuasiNewton { sizes: Sizes::new(), leaves_rounding: false }
    }

    /// Solves `residual(x) = 0` for an increment of `origin`, to rounding, starting from `guess`. If the iteration fails, it is repeated with a
    /// matrix of difference quotients. If the repetition fails, it starts again from the end of damped corrections.
    ///
    /// `residual` writes the residual and a matrix near its derivative; `watch` observes the evaluations. The error after a correction is about as
    /// large as the next correction. The iteration ends if the next correction is bound to be below rounding, or if rounding keeps corrections from
    /// shrinking.
    ///
    /// The determinant has the same meaning as in Newton's iteration: a solution with a negative determinant is refused.
    #[inline(always)]
    pub(crate) fn solve<W: Observer>(
        &mut self,
        origin: &A,
        guess: A,
        watch: &mut W,
        mut residual: impl FnMut(&mut W, &A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
    ) -> Result<A, Refusal> {
        // A guess is not finite if it evaluates the energy outside its domain. The solution may still exist.
        let guess = if guess.is_finite() { guess } else { A::zero() };
        // These sizes serve pivots and difference quotients. The guess may be wild, so no correction is compared with them.
        let mut scale = self.sizes;
        scale.include(origin, &guess);
        let mut noise = A::zero();
        self.iterate(origin, (guess, &scale), None, &mut noise, watch, &mut residual)
            .or_else(|refusal| self.otherwise(origin, (guess, &scale), noise, watch, residual).map_err(|_| refusal))
    }

    /// Repeats the iteration with difference quotients, then from the end of damped corrections.
    #[cold]
    fn otherwise<W: Observer>(
        &mut self,
        origin: &A,
        (guess, scale): (A, &Sizes<A>),
        seen: A,
        watch: &mut W,
        mut residual: impl FnMut(&mut W, &A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
    ) -> Result<A, Refusal> {
        let mut noise = seen;
        self.iterate(origin, (guess, scale), Some(&seen), &mut noise, watch, &mut residual).or_else(|_| {
            let near = damped::approach(origin, 0.0, scale, |x, r, matrix| {
                residual(watch, x, r, matrix)?;
                differentiate(scale, origin, (x, r), &seen, matrix, watch, &mut residual)
            });
            self.iterate(origin, (near, scale), Some(&seen), &mut noise, watch, &mut residual)
        })
    }

    /// Iterates from `x`. If `differences` is present, the matrix consists of difference quotients, and `differences` is the noise of the residual
    /// that they have to exceed. `noise` becomes the noise at the point where the iteration was stuck last.
    fn iterate<W: Observer>(
        &mut self,
        origin: &A,
        (mut x, scale): (A, &Sizes<A>),
        differences: Option<&A>,
        noise: &mut A,
        watch: &mut W,
        residual: &mut impl FnMut(&mut W, &A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
    ) -> Result<A, Refusal> {
        let mut corrections = Corrections::of_order(1);
        let mut matrix = A::fill(A::zero());
        self.leaves_rounding = false;
        for _ in 0..MAX_ITERATIONS {
            let mut delta = A::zero();
            residual(watch, &x, &mut delta, &mut matrix)?;
            if let Some(seen) = differences {
                differentiate(scale, origin, (&x, &delta), seen, &mut matrix, watch, residual)?;
            }
            let left = delta;
            let positive = linear::solve(&mut matrix, &mut delta, scale).ok_or(Refusal::Singular)?;
            let before = x;
            x.add_scaled(A::Real::from_f64(-1.0), &delta);
            let relative = self.sizes.relative(&delta, origin, &x);
            let mut solved = None;
            match corrections.judge::<A::Real>(relative) {
                // If the matrix is large beyond measure, corrections are small at any `x`. The residual must therefore be small, too.
                Verdict::Solved if self.sizes.resolve(&left, origin, &before) => solved = Some(x),
                Verdict::Solved => break,
                Verdict::Stuck => {
                    let (mut left, mut sizes) = (A::zero(), self.sizes);
                    residual(watch, &before, &mut left, &mut matrix)?;
                    // The unknowns are not included yet. Far from all earlier states, any residual could be rounding.
                    sizes.include(origin, &A::zero());
                    let mut rounding = is_of_last_digits(&sizes, &left, &matrix);
                    if !rounding {
                        sizes.include(origin, &before);
                        // The first kind are the positions, the second kind the momenta.
                        let kinds = [A::LEN / 2, 2];
                        watch.pause(true);
                        *noise = noise::measure(&sizes, &before, (&delta, corrections.farther()), kinds, |x| {
                            let mut r = A::zero();
                            residual(watch, x, &mut r, &mut matrix).is_ok().then_some(r)
                        });
                        watch.pause(false);
                        // The solution is evaluated last, because the observer remembers the last point.
                        residual(watch, &before, &mut left, &mut matrix)?;
                        rounding = noise::explains(noise, &left, &sizes);
                    }
                    solved = rounding.then_some(before);
                    self.leaves_rounding = rounding;
                    corrections.restart();
                }
                Verdict::Continue => {}
            }
            if let Some(x) = solved {
                self.sizes.include(origin, &x);
                return if positive { Ok(x) } else { Err(Refusal::Singular) };
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
fn differentiate<A: Array, W>(
    sizes: &Sizes<A>,
    origin: &A,
    (x, r): (&A, &A),
    noise: &A,
    matrix: &mut Square<A>,
    watch: &mut W,
    residual: &mut impl FnMut(&mut W, &A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let size = |i: usize| sizes.of(i).max(sum(origin, x, i));
    let parts = (0..A::LEN).filter(|i| size(*i) > 0.0).map(|i| noise.as_slice()[i].magnitude() / size(i));
    // The part is √ε, or noise/√ε if the relative noise exceeds ε. A quotient over a distance above ε^(1/4) is no derivative.
    let root = Real::sqrt(A::Real::epsilon());
    let part = (A::Real::epsilon().max(largest(parts)) / root).min(Real::sqrt(root));
    let mut unused = A::fill(A::zero());
    for j in 0..A::LEN {
        let (mut moved, mut there) = (*x, A::zero());
        moved.as_mut_slice()[j] += A::Real::from_f64(part * size(j));
        let distance = moved.as_slice()[j] - x.as_slice()[j];
        if distance.magnitude() == 0.0 {
            continue;
        }
        residual(watch, &moved, &mut there, &mut unused)?;
        for (i, row) in A::entries::<A>(matrix).iter_mut().enumerate() {
            row.as_mut_slice()[j] = (there.as_slice()[i] - r.as_slice()[i]) / distance;
        }
    }
    Ok(())
}
