//! Newton's iteration with a matrix that is not quite the derivative: corrections shrink by a factor, not by squares.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::rounding::{Corrections, MAX_ITERATIONS, Verdict};
use crate::solving::size::{Sizes, is_far, sum};
use crate::solving::terms::Terms;
use crate::solving::{damped, linear};
use crate::space::{Array, Square};

/// Solves one equation a step for increments of positions and momenta, and remembers their sizes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuasiNewton<A> {
    sizes: Sizes<A>,
}

impl<A: Array> QuasiNewton<A> {
    pub(crate) fn new() -> Self {
        QuasiNewton { sizes: Sizes::new() }
    }

    /// Solves `residual(x) = 0` for an increment of `origin`, to rounding, from `guess` on. If that fails, with a matrix of
    /// difference quotients; if that fails, from where damped corrections lead.
    ///
    /// `residual` writes the residual and a matrix near its derivative. What is left after a correction is about the next one:
    /// the iteration ends where that is bound to be below rounding, or where rounding keeps corrections from shrinking.
    /// The determinant has the meaning that it has for Newton's iteration.
    #[inline(always)]
    pub(crate) fn solve(
        &mut self,
        origin: &A,
        guess: A,
        mut residual: impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
    ) -> Result<A, Refusal> {
        // A guess may look beyond the domain of the energy where the solution need not.
        let guess = if guess.is_finite() { guess } else { A::zero() };
        let sizes = self.sizes;
        self.sizes.include(origin, &guess);
        self.iterate(origin, guess, &mut residual)
            .and_then(|x| {
                if !is_far(&guess, origin, &x) {
                    return Ok(x);
                }
                self.sizes = sizes;
                self.iterate(origin, x, &mut residual)
            })
            .or_else(|refusal| self.otherwise(origin, guess, residual).map_err(|_| refusal))
    }

    #[cold]
    fn otherwise(
        &mut self,
        origin: &A,
        guess: A,
        mut residual: impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
    ) -> Result<A, Refusal> {
        let sizes = self.sizes;
        let mut precise = |x: &A, r: &mut A, matrix: &mut Square<A>| {
            residual(x, r, matrix)?;
            differentiate(&sizes, origin, x, r, matrix, &mut residual)
        };
        self.iterate(origin, guess, &mut precise).or_else(|_| {
            let near = damped::approach(origin, 0.0, &sizes, &mut precise);
            self.iterate(origin, near, &mut precise)
        })
    }

    fn iterate(
        &mut self,
        origin: &A,
        mut x: A,
        residual: &mut impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
    ) -> Result<A, Refusal> {
        let (mut corrections, mut terms) = (Corrections::of_order(1), Terms::new(&self.sizes));
        let mut matrix = A::fill(A::zero());
        for _ in 0..MAX_ITERATIONS {
            let mut delta = A::zero();
            residual(&x, &mut delta, &mut matrix)?;
            let positive = linear::solve(&mut matrix, &mut delta, &self.sizes).ok_or(Refusal::Singular)?;
            x.add_scaled(A::Real::from_f64(-1.0), &delta);
            let relative = self.sizes.relative(&delta, origin, &x);
            let verdict = corrections.judge::<A::Real>(relative);
            match verdict {
                Verdict::Solved if terms.are_valid() => {
                    self.sizes.include(origin, &x);
                    return if positive { Ok(x) } else { Err(Refusal::Singular) };
                }
                Verdict::Solved | Verdict::Stuck => {
                    let matrix = |x: &A, matrix: &mut _| residual(x, &mut delta, matrix).is_ok() && delta.is_finite();
                    // Positions, then momenta.
                    terms.include(&mut self.sizes, &x, verdict == Verdict::Solved, |i| i / (A::LEN / 2), matrix);
                    corrections.restart();
                }
                Verdict::Continue => {}
            }
            if !relative.is_finite() {
                break;
            }
        }
        Err(corrections.not_converged())
    }
}

/// The derivative of the residual `r` at `x` by difference quotients; a column whose unknown has no size stays as it is.
fn differentiate<A: Array>(
    sizes: &Sizes<A>,
    origin: &A,
    x: &A,
    r: &A,
    matrix: &mut Square<A>,
    residual: &mut impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let root = Real::sqrt(A::Real::epsilon());
    let mut unused = A::fill(A::zero());
    for j in 0..A::LEN {
        let (mut moved, mut there) = (*x, A::zero());
        moved.as_mut_slice()[j] += A::Real::from_f64(root * sizes.of(j).max(sum(origin, x, j)));
        let distance = moved.as_slice()[j] - x.as_slice()[j];
        if distance.magnitude() == 0.0 {
            continue;
        }
        residual(&moved, &mut there, &mut unused)?;
        for (i, row) in A::entries::<A>(matrix).iter_mut().enumerate() {
            row.as_mut_slice()[j] = (there.as_slice()[i] - r.as_slice()[i]) / distance;
        }
    }
    Ok(())
}
