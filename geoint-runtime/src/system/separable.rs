//! Separable systems H = T + V: kicks are flows of V, and drifts are flows of T.

use super::{Cotangent, FlowKind};
use crate::scalar::Real;
use crate::space::PerCoordinate;

/// A system with H = T(p, t) + V(q, t). Each part has an exact flow.
///
/// A contact system may have damping g·s. Its parts are then T + g·s and V if T is quadratic, else T and V + g·s.
#[diagnostic::on_unimplemented(
    message = "kick and drift do not exist for `{Self}`",
    label = "H was not proven to be T(p) + V(q)",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`",
    note = "methods that keep a `constraint` beside `s`: `ContactSplitting`, `ContactLeapfrog`, `ContactDiscreteGradient`"
)]
pub trait Separable<R: Real = f64>: Cotangent<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of a kick of given length.
    type Kick: Copy;
    /// Coefficients of a drift of given length.
    type Drift: Copy;
    /// The kind of a kick, with or without a force gradient. If a kick does not only add to p, [`kick_increments`](Separable::kick_increments) returns its
    /// increments.
    const KICK: FlowKind = FlowKind::ADDS;
    /// The kind of a drift. If a drift does not only add to q, [`drift_increments`](Separable::drift_increments) returns its increments.
    const DRIFT: FlowKind = FlowKind::ADDS;

    /// Computes the coefficients of a kick of length `h`.
    fn prepare_kick(&self, h: R) -> Self::Kick;
    /// Computes the coefficients of a drift of length `h`.
    fn prepare_drift(&self, h: R) -> Self::Drift;
    /// Applies the flow of V at frozen time: p ← p − h ∂V/∂q, s ← s − hV. For V + g·s it is p ← e^(−gh)·p − …
    fn kick(&self, kick: &Self::Kick, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);
    /// Applies the flow of T: q ← q + h ∂T/∂p. For T + g·s it is p ← e^(−gh)·p, …
    fn drift(&self, drift: &Self::Drift, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);

    /// Returns the increments of `x` by a kick, for compensated sums. The default is right if a kick only adds to p, because it then acts on zeros.
    #[inline(always)]
    fn kick_increments(
        &self,
        kick: &Self::Kick,
        t: R,
        x: &PerCoordinate<Self::Phase, Self::Action>,
    ) -> PerCoordinate<Self::Phase, Self::Action> {
        let mut d: PerCoordinate<Self::Phase, Self::Action> = PerCoordinate::nothing();
        self.kick(kick, t, &mut x.z[0].clone(), &mut d.z[1], &mut d.s);
        d
    }
    /// Returns the increments of `x` by a drift, for compensated sums. The default is right if a drift only adds to q.
    #[inline(always)]
    fn drift_increments(
        &self,
        drift: &Self::Drift,
        t: R,
        x: &PerCoordinate<Self::Phase, Self::Action>,
    ) -> PerCoordinate<Self::Phase, Self::Action> {
        let mut d: PerCoordinate<Self::Phase, Self::Action> = PerCoordinate::nothing();
        self.drift(drift, t, &mut d.z[0], &mut x.z[1].clone(), &mut d.s);
        d
    }
}

/// A separable system whose T is a quadratic polynomial in p with constant coefficients. Then \[V, \[V, \[V, T\]\]\] = 0.
///
/// Runge–Kutta–Nyström tables need this property. For any other T their order would be only 3 or 4.
#[diagnostic::on_unimplemented(
    message = "the kinetic energy of `{Self}` is not quadratic in `p` with a constant mass matrix",
    label = "Runge–Kutta–Nyström tables lose their order on such a T",
    note = "tables for every separable energy: `StormerVerlet`, `BlanesMoan4`, `BlanesMoan6`, `Yoshida4.of(StormerVerlet)` …"
)]
pub trait QuadraticKinetic<R: Real = f64>: Separable<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// A separable system whose T is a quadratic polynomial in p. Then \[V, \[T, V\]\] depends on q only, and has an exact flow together with V.
///
/// With the force F = −∂V/∂q and the mass matrix M, \[V, \[T, V\]\] = F·M⁻¹F.
#[diagnostic::on_unimplemented(
    message = "the kinetic energy of `{Self}` is not quadratic in `p` with a constant mass matrix",
    label = "on such a T force gradients are no kicks",
    note = "tables for every separable energy: `StormerVerlet`, `BlanesMoan4`, `BlanesMoan6`, `Yoshida4.of(StormerVerlet)` …"
)]
pub trait ForceGradient<R: Real = f64>: QuadraticKinetic<R> {
    /// Coefficients of a kick of given weights.
    type GradientKick: Copy;

    /// Computes the coefficients of a kick. `h` is the weight of the force and `g` that of its gradient. Both include their powers of the step size.
    fn prepare_gradient_kick(&self, h: R, g: R) -> Self::GradientKick;
    /// Applies the flow of U = hV − g F·M⁻¹F at frozen time: p ← p + hF + g ∇(F·M⁻¹F), s ← s − U.
    fn gradient_kick(
        &self,
        kick: &Self::GradientKick,
        t: R,
        q: &mut Self::Array,
        p: &mut Self::Array,
        s: &mut Self::Action,
    );
}
