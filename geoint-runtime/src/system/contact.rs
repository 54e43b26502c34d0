//! Contact systems with H(q, p, s, t): q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

use super::{Cotangent, PhaseSpace, Separable};
use crate::scalar::{Real, zero};
use crate::space::{Array, ContactState, Square};

/// A system with a contact Hamiltonian H(q, p, s, t).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no contact system without constraints",
    label = "this method does not fit this kind of system",
    note = "methods that keep a `constraint` beside `s`: `ContactSplitting`, `ContactLeapfrog`, `ContactDiscreteGradient`"
)]
pub trait Contact<R: Real = f64>:
    Cotangent<R> + PhaseSpace<R, Action = R, State = ContactState<<Self as Cotangent<R>>::Coordinates>>
{
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Writes [∂H/∂q, ∂H/∂p] at a point to `slopes`, and ∂H/∂s to `ds`.
    fn gradient(&self, t: R, z: &Self::Phase, s: &R, slopes: &mut Self::Phase, ds: &mut R);

    /// Writes z' at a point to `slopes`, and s' to `ds`.
    #[inline]
    fn rate(&self, t: R, z: &Self::Phase, s: &R, slopes: &mut Self::Phase, ds: &mut R) {
        let mut by_s = zero();
        self.gradient(t, z, s, slopes, &mut by_s);
        *ds = -self.hamiltonian(t, z, s);
        let ([_, p], [q_rate, p_rate]) = (z, slopes);
        let halves = q_rate.as_mut_slice().iter_mut().zip(p_rate.as_mut_slice());
        for (p, (force, velocity)) in p.as_slice().iter().zip(halves) {
            *ds = p.multiply_add(*velocity, *ds);
            (*force, *velocity) = (*velocity, -p.multiply_add(by_s, *force));
        }
    }
}

/// A contact system with H = g(t)·s + H₀(q, p, t). The motion of (q, p) does not depend on s.
#[diagnostic::on_unimplemented(
    message = "positions and momenta of `{Self}` do not move without the action",
    label = "s acts back on q or p, and has to be followed"
)]
#[doc(alias = "linear damping")]
pub trait Conformal<R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// A contact system with H = T(p, t) + g(t)·s + V(q, t). The trait gives the flows of T and V without the damping g·s.
#[diagnostic::on_unimplemented(message = "`{Self}` was not proven to be T(p) + g·s + V(q)")]
pub trait Mechanical<R: Real = f64>: Contact<R> + Separable<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of a kick of given length.
    type FreeKick: Copy;
    /// Coefficients of a drift of given length.
    type FreeDrift: Copy;

    /// Computes the coefficients of a kick of length `h`.
    fn prepare_free_kick(&self, h: R) -> Self::FreeKick;
    /// Applies the flow of V alone.
    fn free_kick(&self, kick: &Self::FreeKick, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut R);
    /// Computes the coefficients of a drift of length `h`.
    fn prepare_free_drift(&self, h: R) -> Self::FreeDrift;
    /// Applies the flow of T alone.
    fn free_drift(&self, drift: &Self::FreeDrift, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut R);
    /// Returns g at time `t`.
    fn damping(&self, t: R) -> R;
}

/// The equation d = Φ(d) for the increment d of a step of the method `M` from x = (q, p, s).
pub trait ContactEquation<M, R: Real = f64>: Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The array (q, p, s).
    type Unknown: Array<Real = R>;
    /// Coefficients that depend on parameters and h.
    type Constants: Copy + core::fmt::Debug;
    /// Coefficients that depend on x and t.
    type Start: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters and h.
    fn constants(&self, h: R) -> Self::Constants;
    /// Computes the coefficients that all evaluations of a step from `x` share. `t` is the time at the middle of the step.
    fn begin(&self, constants: &Self::Constants, t: R, x: &Self::Unknown) -> Self::Start;
    /// Writes Φ(d) to `f`, and 1 − ∂Φ/∂d to `matrix`.
    fn image(
        &self,
        constants: &Self::Constants,
        start: &Self::Start,
        d: &Self::Unknown,
        f: &mut Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    );
    /// Returns the increment of x for a solution `d`. NaN if the step has no end.
    fn end(&self, constants: &Self::Constants, start: &Self::Start, d: &Self::Unknown) -> Self::Unknown;
}
