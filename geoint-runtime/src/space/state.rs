//! Points of phase space, in the types of the energy's signature.

use crate::scalar::{Real, zero};
use crate::sealed::Sealed;
use crate::space::Array;
use core::fmt::Debug;
use nalgebra::SVector;

/// What a coordinate may be: a scalar, an array, an array of arrays, a vector of nalgebra, an array of those.
///
/// Users see this type; kernels see [`Coordinates::Array`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be a coordinate",
    note = "coordinates are `f64`, `f32`, `[f64; N]`, `[[f64; D]; N]`, `SVector<f64, N>` or `[SVector<f64, D>; N]`"
)]
pub trait Coordinates: Copy + core::fmt::Debug + PartialEq {
    /// The scalar.
    type Real: Real;
    /// The same numbers as nested arrays.
    type Array: Array<Real = Self::Real>;
    /// To nested arrays.
    fn into_array(self) -> Self::Array;
    /// From nested arrays.
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

/// A point of phase space at a time: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<Q: Coordinates> {
    /// Time.
    pub t: Q::Real,
    /// Positions.
    pub q: Q,
    /// Momenta, in the shape of `q`.
    pub p: Q,
}

impl<Q: Coordinates> State<Q> {
    /// The point (`q`, `p`) at t = 0.
    pub fn new(q: Q, p: Q) -> Self {
        State { t: zero(), q, p }
    }

    /// The point (`q`, `p`) at time `t`.
    pub fn at(t: Q::Real, q: Q, p: Q) -> Self {
        State { t, q, p }
    }
}

/// A point of contact phase space at a time: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactState<Q: Coordinates> {
    /// Time.
    pub t: Q::Real,
    /// Positions.
    pub q: Q,
    /// Momenta, in the shape of `q`.
    pub p: Q,
    /// The action, s' = p·q' − H.
    pub s: Q::Real,
}

impl<Q: Coordinates> ContactState<Q> {
    /// The point (`q`, `p`, `s`) at t = 0.
    pub fn new(q: Q, p: Q, s: Q::Real) -> Self {
        ContactState { t: zero(), q, p, s }
    }

    /// The point (`q`, `p`, `s`) at time `t`.
    pub fn at(t: Q::Real, q: Q, p: Q, s: Q::Real) -> Self {
        ContactState { t, q, p, s }
    }
}

/// A point of phase space at a time, whatever its kind.
///
/// Sealed: phase spaces to come add to it.
pub trait Snapshot: Sealed + Copy + Debug + PartialEq {
    /// The scalar.
    type Real: Real;
    /// Its time.
    fn time(&self) -> Self::Real;
}

impl<Q: Coordinates> Sealed for State<Q> {}
impl<Q: Coordinates> Sealed for ContactState<Q> {}

impl<Q: Coordinates> Snapshot for State<Q> {
    type Real = Q::Real;
    fn time(&self) -> Q::Real {
        self.t
    }
}

impl<Q: Coordinates> Snapshot for ContactState<Q> {
    type Real = Q::Real;
    fn time(&self) -> Q::Real {
        self.t
    }
}

/// What phase space has beside positions and momenta: nothing, or the action of a contact system.
///
/// Sealed: methods tell the two kinds apart.
pub trait Action<R: Real>: Sealed + Copy + Debug + PartialEq {
    /// Points of such a phase space.
    type State<Q: Coordinates<Real = R>>: Snapshot<Real = R>;
    /// How many numbers it is.
    const LEN: usize;
    /// Zero, if there is one.
    fn zero() -> Self;
    /// The action, if there is one, as a list.
    fn numbers(&self) -> &[R];
    /// The same to be written to.
    fn numbers_mut(&mut self) -> &mut [R];
    /// Whether it is a finite number.
    fn is_finite(&self) -> bool;
    /// The action, if there is one.
    fn scalar(&self) -> Option<R>;
    /// Not a number.
    fn unknown() -> Self;
    /// A point from its parts.
    fn state<Q: Coordinates<Real = R>>(t: R, q: Q, p: Q, action: Self) -> Self::State<Q>;
    /// The parts of a point.
    fn parts<Q: Coordinates<Real = R>>(state: Self::State<Q>) -> (R, Q, Q, Self);
}

impl Sealed for () {}
impl<R: Real> Sealed for R {}

impl<R: Real> Action<R> for () {
    type State<Q: Coordinates<Real = R>> = State<Q>;
    const LEN: usize = 0;
    #[inline(always)]
    fn zero() {}
    #[inline(always)]
    fn numbers(&self) -> &[R] {
        &[]
    }
    #[inline(always)]
    fn numbers_mut(&mut self) -> &mut [R] {
        &mut []
    }
    #[inline(always)]
    fn is_finite(&self) -> bool {
        true
    }
    #[inline(always)]
    fn scalar(&self) -> Option<R> {
        None
    }
    fn unknown() {}
    #[inline(always)]
    fn state<Q: Coordinates<Real = R>>(t: R, q: Q, p: Q, (): ()) -> State<Q> {
        State { t, q, p }
    }
    fn parts<Q: Coordinates<Real = R>>(State { t, q, p }: State<Q>) -> (R, Q, Q, ()) {
        (t, q, p, ())
    }
}

impl<R: Real> Action<R> for R {
    type State<Q: Coordinates<Real = R>> = ContactState<Q>;
    const LEN: usize = 1;
    #[inline(always)]
    fn zero() -> R {
        zero()
    }
    #[inline(always)]
    fn numbers(&self) -> &[R] {
        core::slice::from_ref(self)
    }
    #[inline(always)]
    fn numbers_mut(&mut self) -> &mut [R] {
        core::slice::from_mut(self)
    }
    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.magnitude() < f64::INFINITY
    }
    #[inline(always)]
    fn scalar(&self) -> Option<R> {
        Some(*self)
    }
    fn unknown() -> R {
        R::from_f64(f64::NAN)
    }
    #[inline(always)]
    fn state<Q: Coordinates<Real = R>>(t: R, q: Q, p: Q, s: R) -> ContactState<Q> {
        ContactState { t, q, p, s }
    }
    fn parts<Q: Coordinates<Real = R>>(ContactState { t, q, p, s }: ContactState<Q>) -> (R, Q, Q, R) {
        (t, q, p, s)
    }
}
