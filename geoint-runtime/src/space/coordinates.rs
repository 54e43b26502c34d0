//! Coordinates in the types that the user writes in the signature of the energy.

use crate::scalar::Real;
use crate::space::Array;
use nalgebra::SVector;

/// The types of coordinates: a scalar, an array, an array of arrays, a vector of nalgebra, or an array of vectors.
///
/// Users write this type. Kernels use [`Coordinates::Array`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be a coordinate",
    note = "coordinates are `f64`, `f32`, `[f64; N]`, `[[f64; D]; N]`, `SVector<f64, N>` or `[SVector<f64, D>; N]`"
)]
pub trait Coordinates: Copy + core::fmt::Debug + PartialEq {
    /// The scalar.
    type Real: Real;
    /// The type of the coordinates as nested arrays.
    type Array: Array<Real = Self::Real>;
    /// Converts to nested arrays.
    fn into_array(self) -> Self::Array;
    /// Converts from nested arrays.
    fn from_array(array: Self::Array) -> Self;
}

impl<R: Real> Coordinates for R {
    type Real = R;
    type Array = [R; 1];
    #[inline(always)]
    fn into_array(self) -> [R; 1] {
        [self]
    }
    #[inline(always)]
    fn from_array([x]: [R; 1]) -> Self {
        x
    }
}

impl<R: Real, const N: usize> Coordinates for [R; N] {
    type Real = R;
    type Array = Self;
    #[inline(always)]
    fn into_array(self) -> Self {
        self
    }
    #[inline(always)]
    fn from_array(array: Self) -> Self {
        array
    }
}

impl<R: Real, const D: usize, const N: usize> Coordinates for [[R; D]; N] {
    type Real = R;
    type Array = Self;
    #[inline(always)]
    fn into_array(self) -> Self {
        self
    }
    #[inline(always)]
    fn from_array(array: Self) -> Self {
        array
    }
}

impl<R: Real, const N: usize> Coordinates for SVector<R, N> {
    type Real = R;
    type Array = [R; N];
    #[inline(always)]
    fn into_array(self) -> [R; N] {
        self.into()
    }
    #[inline(always)]
    fn from_array(array: [R; N]) -> Self {
        array.into()
    }
}

impl<R: Real, const D: usize, const N: usize> Coordinates for [SVector<R, D>; N] {
    type Real = R;
    type Array = [[R; D]; N];
    #[inline(always)]
    fn into_array(self) -> [[R; D]; N] {
        core::array::from_fn(|i| self[i].into())
    }
    #[inline(always)]
    fn from_array(array: [[R; D]; N]) -> Self {
        core::array::from_fn(|i| array[i].into())
    }
}
