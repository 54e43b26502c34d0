//! Nested arrays of scalars: the coordinates of a point, as kernels and drivers use them.
//!
//! Lengths are part of the type. Thus the bounds of all loops are known to the compiler, and nothing is allocated.

use crate::scalar::{Real, zero};
use core::fmt::Debug;

/// A scalar, an array of scalars, an array of such arrays, and so on.
pub trait Array: Copy + Debug + PartialEq + 'static {
    /// The type of the scalars.
    type Real: Real;
    /// A nested array of this shape, with entries `T` in place of the scalars.
    type Map<T: Copy + Debug>: Copy + Debug;
    /// The number of scalars.
    const LEN: usize;

    /// Returns all scalars in order.
    fn as_slice(&self) -> &[Self::Real];
    /// Returns all scalars in order, mutably.
    fn as_mut_slice(&mut self) -> &mut [Self::Real];
    /// Returns an array with each entry `x`.
    fn fill<T: Copy + Debug>(x: T) -> Self::Map<T>;
    /// Returns the entries of a [`Map`](Array::Map) in order, mutably.
    fn entries<T: Copy + Debug>(map: &mut Self::Map<T>) -> &mut [T];
    /// Returns the entries of a [`Map`](Array::Map) in order.
    fn entries_of<T: Copy + Debug>(map: &Self::Map<T>) -> &[T];
    /// Returns an array of zeros.
    fn zero() -> Self;

    #[doc(hidden)]
    fn flatten(nested: &[Self]) -> &[Self::Real];
    #[doc(hidden)]
    fn flatten_mut(nested: &mut [Self]) -> &mut [Self::Real];
    #[doc(hidden)]
    fn flatten_entries<T: Copy + Debug>(nested: &mut [Self::Map<T>]) -> &mut [T];
    #[doc(hidden)]
    fn flatten_entries_of<T: Copy + Debug>(nested: &[Self::Map<T>]) -> &[T];

    /// self ← self + w·x.
    #[inline(always)]
    fn add_scaled(&mut self, w: Self::Real, x: &Self) {
        for (y, x) in self.as_mut_slice().iter_mut().zip(x.as_slice()) {
            *y = w.multiply_add(*x, *y);
        }
    }

    /// self ← x, entry by entry, so that `self` may stay in registers.
    #[inline(always)]
    fn copy_from(&mut self, x: &Self) {
        for (y, x) in self.as_mut_slice().iter_mut().zip(x.as_slice()) {
            *y = *x;
        }
    }

    /// Returns an array of −0, as the start of a sum. The optimiser removes −0 + x, but not 0 + x.
    #[inline(always)]
    fn nothing() -> Self {
        let mut nothing = Self::zero();
        for x in nothing.as_mut_slice() {
            *x = -*x;
        }
        nothing
    }

    /// Returns whether all entries are equal to those of `x`.
    #[inline(always)]
    fn is_same(&self, x: &Self) -> bool {
        // No branch for each entry.
        let mut same = true;
        for i in 0..Self::LEN {
            same &= self.as_slice()[i] == x.as_slice()[i];
        }
        same
    }

    /// Returns whether all entries are zero.
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.as_slice().iter().all(|x| x.magnitude() == 0.0)
    }

    /// Returns whether all entries are finite.
    #[inline(always)]
    #[allow(clippy::eq_op, reason = "a number less itself tells whether it is finite")]
    fn is_finite(&self) -> bool {
        // No branch for each entry. x − x is zero if x is finite, else NaN. A comparison with infinity would take more instructions.
        self.as_slice().iter().fold(true, |finite, x| finite & (*x - *x == Self::Real::from_f64(0.0)))
    }
}

/// A square matrix: one row of shape `A` for each entry of `A`.
pub type Square<A> = <A as Array>::Map<A>;

impl<R: Real> Array for R {
    type Real = R;
    type Map<T: Copy + Debug> = T;
    const LEN: usize = 1;

    #[inline(always)]
    fn as_slice(&self) -> &[R] {
        core::slice::from_ref(self)
    }
    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [R] {
        core::slice::from_mut(self)
    }
    #[inline(always)]
    fn fill<T: Copy + Debug>(x: T) -> T {
        x
    }
    #[inline(always)]
    fn entries<T: Copy + Debug>(map: &mut T) -> &mut [T] {
        core::slice::from_mut(map)
    }
    #[inline(always)]
    fn entries_of<T: Copy + Debug>(map: &T) -> &[T] {
        core::slice::from_ref(map)
    }
    #[inline(always)]
    fn zero() -> Self {
        zero()
    }
    #[inline(always)]
    fn flatten(nested: &[Self]) -> &[R] {
        nested
    }
    #[inline(always)]
    fn flatten_mut(nested: &mut [Self]) -> &mut [R] {
        nested
    }
    #[inline(always)]
    fn flatten_entries<T: Copy + Debug>(nested: &mut [T]) -> &mut [T] {
        nested
    }
    #[inline(always)]
    fn flatten_entries_of<T: Copy + Debug>(nested: &[T]) -> &[T] {
        nested
    }
}

impl<A: Array, const N: usize> Array for [A; N] {
    type Real = A::Real;
    type Map<T: Copy + Debug> = [A::Map<T>; N];
    const LEN: usize = N * A::LEN;

    #[inline(always)]
    fn as_slice(&self) -> &[A::Real] {
        A::flatten(self)
    }
    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [A::Real] {
        A::flatten_mut(self)
    }
    #[inline(always)]
    fn fill<T: Copy + Debug>(x: T) -> Self::Map<T> {
        [A::fill(x); N]
    }
    #[inline(always)]
    fn entries<T: Copy + Debug>(map: &mut Self::Map<T>) -> &mut [T] {
        A::flatten_entries(map)
    }
    #[inline(always)]
    fn entries_of<T: Copy + Debug>(map: &Self::Map<T>) -> &[T] {
        A::flatten_entries_of(map)
    }
    #[inline(always)]
    fn zero() -> Self {
        [A::zero(); N]
    }
    #[inline(always)]
    fn flatten(nested: &[Self]) -> &[A::Real] {
        A::flatten(nested.as_flattened())
    }
    #[inline(always)]
    fn flatten_mut(nested: &mut [Self]) -> &mut [A::Real] {
        A::flatten_mut(nested.as_flattened_mut())
    }
    #[inline(always)]
    fn flatten_entries<T: Copy + Debug>(nested: &mut [Self::Map<T>]) -> &mut [T] {
        A::flatten_entries(nested.as_flattened_mut())
    }
    #[inline(always)]
    fn flatten_entries_of<T: Copy + Debug>(nested: &[Self::Map<T>]) -> &[T] {
        A::flatten_entries_of(nested.as_flattened())
    }
}
