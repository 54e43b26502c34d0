//! States: points of phase space with a time, in the types of the user.

use super::coordinates::Coordinates;
use crate::scalar::{Real, zero};
use crate::sealed::Sealed;
use crate::space::Array;
use core::fmt::Debug;

/// A point of phase space at a time: plain data.
#[doc(alias("phase space point", "initial condition"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

/// The origin at t = 0.
impl<Q: Coordinates> Default for State<Q> {
    fn default() -> Self {
        let none = Q::from_array(Q::Array::zero());
        State::new(none, none)
    }
}

/// (q, p) at t = 0.
impl<Q: Coordinates> From<(Q, Q)> for State<Q> {
    fn from((q, p): (Q, Q)) -> Self {
        State::new(q, p)
    }
}

/// A point of contact phase space at a time: plain data.
#[doc(alias = "friction")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

/// The origin at t = 0, with s = 0.
impl<Q: Coordinates> Default for ContactState<Q> {
    fn default() -> Self {
        let none = Q::from_array(Q::Array::zero());
        ContactState::new(none, none, zero())
    }
}

/// (q, p, s) at t = 0.
impl<Q: Coordinates> From<(Q, Q, Q::Real)> for ContactState<Q> {
    fn from((q, p, s): (Q, Q, Q::Real)) -> Self {
        ContactState::new(q, p, s)
    }
}

/// A point of the phase space of a flow x' = f(x, t) at a time: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FlowState<X: Coordinates> {
    /// Time.
    pub t: X::Real,
    /// All coordinates.
    pub x: X,
}

impl<X: Coordinates> FlowState<X> {
    /// The point `x` at t = 0.
    pub fn new(x: X) -> Self {
        FlowState { t: zero(), x }
    }

    /// The point `x` at time `t`.
    pub fn at(t: X::Real, x: X) -> Self {
        FlowState { t, x }
    }
}

/// The origin at t = 0.
impl<X: Coordinates> Default for FlowState<X> {
    fn default() -> Self {
        FlowState::new(X::from_array(X::Array::zero()))
    }
}

/// x at t = 0.
impl<X: Coordinates> From<X> for FlowState<X> {
    fn from(x: X) -> Self {
        FlowState::new(x)
    }
}

/// The common interface of all states: a time, all coordinates in one array, and an action for contact systems.
///
/// Sealed, because later versions may add items.
pub trait Snapshot: Sealed + Copy + Debug + PartialEq {
    /// The scalar.
    type Real: Real;
    /// All coordinates: [q, p], or x.
    type Phase: Array<Real = Self::Real>;
    /// The scalar for the action of a contact system, else `()`.
    type Action: Action<Self::Real>;
    /// The length of groups of coordinates with a common unit, such as positions or momenta.
    const ALIKE: usize;
    /// Whether half of the coordinates are momenta.
    const MOMENTA: bool = true;
    /// Whether there are unit quaternions among the coordinates.
    const ATTITUDES: bool = false;
    /// Returns the time.
    fn time(&self) -> Self::Real;
    /// Returns the state with these parts.
    fn of(t: Self::Real, z: Self::Phase, action: Self::Action) -> Self;
    /// Returns time, coordinates and action.
    fn parts(self) -> (Self::Real, Self::Phase, Self::Action);
}

impl<Q: Coordinates> Sealed for State<Q> {}
impl<Q: Coordinates> Sealed for ContactState<Q> {}
impl<X: Coordinates> Sealed for FlowState<X> {}

impl<Q: Coordinates> Snapshot for State<Q> {
    type Real = Q::Real;
    type Phase = [Q::Array; 2];
    type Action = ();
    const ALIKE: usize = Q::Array::LEN;
    #[inline]
    fn time(&self) -> Q::Real {
        self.t
    }
    #[inline(always)]
    fn of(t: Q::Real, [q, p]: [Q::Array; 2], (): ()) -> Self {
        State { t, q: Q::from_array(q), p: Q::from_array(p) }
    }
    #[inline]
    fn parts(self) -> (Q::Real, [Q::Array; 2], ()) {
        (self.t, [self.q.into_array(), self.p.into_array()], ())
    }
}

impl<Q: Coordinates> Snapshot for ContactState<Q> {
    type Real = Q::Real;
    type Phase = [Q::Array; 2];
    type Action = Q::Real;
    const ALIKE: usize = Q::Array::LEN;
    #[inline]
    fn time(&self) -> Q::Real {
        self.t
    }
    #[inline(always)]
    fn of(t: Q::Real, [q, p]: [Q::Array; 2], s: Q::Real) -> Self {
        ContactState { t, q: Q::from_array(q), p: Q::from_array(p), s }
    }
    #[inline]
    fn parts(self) -> (Q::Real, [Q::Array; 2], Q::Real) {
        (self.t, [self.q.into_array(), self.p.into_array()], self.s)
    }
}

impl<X: Coordinates> Snapshot for FlowState<X> {
    type Real = X::Real;
    type Phase = X::Array;
    type Action = ();
    const ALIKE: usize = 1;
    const MOMENTA: bool = false;
    #[inline]
    fn time(&self) -> X::Real {
        self.t
    }
    #[inline]
    fn of(t: X::Real, x: X::Array, (): ()) -> Self {
        FlowState { t, x: X::from_array(x) }
    }
    #[inline]
    fn parts(self) -> (X::Real, X::Array, ()) {
        (self.t, self.x.into_array(), ())
    }
}

/// The action of a contact system, or `()` for all other systems.
///
/// Sealed, because methods distinguish exactly these two cases.
pub trait Action<R: Real>: Sealed + Copy + Debug + PartialEq {
    /// The number of scalars: 1 or 0.
    const LEN: usize;
    /// Returns an action of zero, or `()`.
    fn zero() -> Self;
    /// Returns the action as a slice, which is empty for `()`.
    fn numbers(&self) -> &[R];
    /// Returns the action as a mutable slice, which is empty for `()`.
    fn numbers_mut(&mut self) -> &mut [R];
    /// Returns whether the action is finite. `true` for `()`.
    fn is_finite(&self) -> bool;
    /// Returns the action, or `None` for `()`.
    fn scalar(&self) -> Option<R>;
    /// Returns the action with this value, or `()`.
    fn of(number: R) -> Self;
}

impl Sealed for () {}
impl<R: Real> Sealed for R {}

impl<R: Real> Action<R> for () {
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
    #[inline(always)]
    fn of(_: R) {}
}

impl<R: Real> Action<R> for R {
    const LEN: usize = 1;
    #[inline(always)]
    fn zero() -> Self {
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
    #[inline(always)]
    fn of(number: R) -> Self {
        number
    }
}
