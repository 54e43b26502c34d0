//! The inverse of a matrix that is the same in all steps.

use super::linear;
use super::size::Sizes;
use crate::scalar::Real;
use crate::space::{Array, Square};
use core::fmt::Debug;

/// The inverse of the matrix of implicit steps, where that is the same in all of them: [`Inverted`]; or `()`, where it is not.
pub trait Inverse<A: Array>: Clone + Debug {
    /// Whether there is one.
    const EXISTS: bool;
    /// The inverse of `matrix`. Not a number if that is singular, or its determinant negative.
    fn new(matrix: impl FnOnce() -> Square<A>) -> Self;
    /// The product with a vector.
    fn times(&self, x: &A) -> A;
}

/// The matrix changes from step to step: nothing is kept.
impl<A: Array> Inverse<A> for () {
    const EXISTS: bool = false;

    fn new(_: impl FnOnce() -> Square<A>) -> Self {}

    fn times(&self, x: &A) -> A {
        *x
    }
}

/// The inverse of a matrix.
#[derive(Clone, Debug)]
pub struct Inverted<A: Array>(Square<A>);

impl<A: Array> Inverse<A> for Inverted<A> {
    const EXISTS: bool = true;

    fn new(matrix: impl FnOnce() -> Square<A>) -> Self {
        let matrix = matrix();
        let (mut inverse, sizes) = (A::fill(A::zero()), Sizes::<A>::of_blocks(&matrix));
        for j in 0..A::LEN {
            let (mut lu, mut column) = (matrix, A::zero());
            column.as_mut_slice()[j] = A::Real::from_f64(1.0);
            let solved = linear::solve(&mut lu, &mut column, &sizes) == Some(true);
            for (row, x) in A::entries::<A>(&mut inverse).iter_mut().zip(column.as_slice()) {
                row.as_mut_slice()[j] = if solved { *x } else { A::Real::from_f64(f64::NAN) };
            }
        }
        Inverted(inverse)
    }

    #[inline(always)]
    fn times(&self, x: &A) -> A {
        let mut product = A::zero();
        for (i, row) in A::entries_of::<A>(&self.0).iter().enumerate() {
            for (w, x) in row.as_slice().iter().zip(x.as_slice()) {
                product.as_mut_slice()[i] = w.multiply_add(*x, product.as_slice()[i]);
            }
        }
        product
    }
}
