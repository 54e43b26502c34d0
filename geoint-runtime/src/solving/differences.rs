//! An equation whose derivative is computed by difference quotients.

use super::Observer;
use super::distant::Residual;
use super::size::{Sizes, largest, sum};
use crate::scalar::Real;
use crate::space::{Array, Square};

/// A residual with a matrix of difference quotients.
pub(super) struct Differences<'a, A> {
    pub(super) residual: &'a mut dyn Residual<A>,
    pub(super) origin: A,
    pub(super) sizes: Sizes<A>,
    /// The rounding of the residual, which differences have to exceed.
    pub(super) noise: A,
}

impl<A> Observer for Differences<'_, A> {
    fn pause(&mut self, paused: bool) {
        self.residual.pause(paused);
    }
}

impl<A: Array> Residual<A> for Differences<'_, A> {
    /// Replaces each column of the matrix by a difference quotient, unless its unknown has no size. Unknowns move so far that the noise of the residual is a
    /// small part of its change.
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A {
        let residual = self.residual.at(x, matrix);
        let size = |i: usize| self.sizes.of(i).max(sum(&self.origin, x, i));
        let parts = (0..A::LEN).filter(|i| size(*i) > 0.0).map(|i| self.noise.as_slice()[i].magnitude() / size(i));
        // √ε of the size, or noise/√ε if the relative noise exceeds ε. Beyond ε^(1/4) the truncation error is too large.
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
                row.as_mut_slice()[j] = (there.as_slice()[i] - residual.as_slice()[i]) / distance;
            }
        }
        self.residual.pause(false);
        residual
    }
}
