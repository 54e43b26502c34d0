//! Replaces the derivative of a residual r by difference quotients (r(x + d eⱼ) − r(x))/d, where the vector eⱼ moves unknown j by 1.
//!
//! [`rescue`](super::rescue) uses them if the search with an approximate derivative fails. A matrix for n unknowns takes n + 1 evaluations. Limit: the
//! quotients have truncation errors, so convergence remains linear.

use super::Observer;
use super::distant::Residual;
use super::size::{Sizes, largest, sum_of_magnitudes};
use crate::scalar::Real;
use crate::space::{Array, Square};

/// A residual with a matrix of difference quotients. An unknown of size zero keeps the column of the approximate derivative.
pub(super) struct Differences<'a, A> {
    pub(super) residual: &'a mut dyn Residual<A>,
    /// The origin of the unknowns. |origin| + |x| is the least size of an unknown.
    pub(super) origin: A,
    /// The sizes of the unknowns, which scale the distances d.
    pub(super) sizes: Sizes<A>,
    /// The standard deviation of the rounding of the residual near the guess. Differences have to exceed it.
    pub(super) noise: A,
    /// True if the caller has paused the observer. The end of a matrix then must not end this pause.
    pub(super) paused: bool,
}

impl<A> Observer for Differences<'_, A> {
    fn pause(&mut self, paused: bool) {
        self.paused = paused;
        self.residual.pause(paused);
    }
}

impl<A: Array> Residual<A> for Differences<'_, A> {
    /// Returns r(x), and writes difference quotients to `matrix`. Each unknown moves by the same part of its size. This part is so large that the noise of the
    /// residual is a small part of its change.
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A {
        let r = self.residual.at(x, matrix);
        let size = |i: usize| self.sizes.of(i).max(sum_of_magnitudes(&self.origin, x, i));
        let parts = (0..A::LEN).filter(|i| size(*i) > 0.0).map(|i| self.noise.as_slice()[i].magnitude() / size(i));
        // max(ε, noise)/√ε with the largest noise relative to a size. √ε balances rounding and truncation. Beyond ε^(1/4) the truncation error is too large.
        let root = Real::sqrt(A::Real::epsilon());
        let part = (A::Real::epsilon().max(largest(parts)) / root).min(Real::sqrt(root));
        let mut unused = A::fill(A::zero());
        self.residual.pause(true);
        for j in 0..A::LEN {
            let mut moved = *x;
            moved.as_mut_slice()[j] += A::Real::from_f64(part * size(j));
            let distance = moved.as_slice()[j] - x.as_slice()[j];
            if distance.magnitude() == 0.0 {
                continue;
            }
            let there = self.residual.at(&moved, &mut unused);
            for (i, row) in A::entries::<A>(matrix).iter_mut().enumerate() {
                row.as_mut_slice()[j] = (there.as_slice()[i] - r.as_slice()[i]) / distance;
            }
        }
        self.residual.pause(self.paused);
        r
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The residual x², which records whether its points are observed.
    #[derive(Default)]
    struct Recorded {
        paused: bool,
        points: alloc::vec::Vec<(f64, bool)>,
    }

    impl Observer for Recorded {
        fn pause(&mut self, paused: bool) {
            self.paused = paused;
        }
    }

    impl Residual<[f64; 1]> for Recorded {
        fn at(&mut self, [x]: &[f64; 1], _: &mut [[f64; 1]; 1]) -> [f64; 1] {
            self.points.push((*x, self.paused));
            [x * x]
        }
    }

    #[test]
    fn a_pause_of_the_caller_outlasts_a_matrix() {
        for paused in [false, true] {
            let (mut recorded, mut matrix) = (Recorded::default(), [[0.0]]);
            let sizes = Sizes::equal();
            let mut differences =
                Differences { residual: &mut recorded, origin: [0.0], sizes, noise: [0.0], paused: false };
            differences.pause(paused);
            assert_eq!(differences.at(&[1.0], &mut matrix), [1.0]);
            assert!((matrix[0][0] - 2.0).abs() < 1e-7, "{matrix:?}");
            assert_eq!(recorded.paused, paused);
            // The point itself is observed unless the caller has paused. The points of difference quotients never are.
            let [(1.0, first), (_, true)] = recorded.points[..] else { panic!("{:?}", recorded.points) };
            assert_eq!(first, paused);
        }
    }
}
