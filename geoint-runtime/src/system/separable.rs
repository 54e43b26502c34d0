//! H = T + V: kick and drift.

use super::Cotangent;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate};

/// A part of a flow that may end before its time: what it is called, and the coordinates that it moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlowPart {
    /// In messages.
    pub name: &'static str,
    /// The first of its positions, as they are stored.
    pub first: usize,
    /// How many there are.
    pub count: usize,
}

impl FlowPart {
    /// Whether the positions are numbers.
    pub(crate) fn is_finite<R: Real, Z: Array<Real = R>>(&self, z: &Z) -> bool {
        let positions = &z.as_slice()[self.first..self.first + self.count];
        positions.iter().all(|x| x.magnitude() < f64::INFINITY)
    }
}

/// H = T(p, t) + V(q, t): each part has an exact flow. In contact systems with damping g·s the parts are T + g·s and V where T is
/// quadratic, and T and V + g·s where it is not.
#[diagnostic::on_unimplemented(
    message = "kick and drift do not exist for `{Self}`",
    label = "H was not proven to be T(p) + V(q)",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait Separable<R: Real = f64>: Cotangent<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What a kick of given length needs from the parameters.
    type Kick: Copy;
    /// What a drift of given length needs from the parameters.
    type Drift: Copy;
    /// Whether a drift from t on is exact in its own time, or takes place at the frozen time t of the kicks.
    const DRIFTS_ARE_EXACT_IN_TIME: bool = false;
    /// Whether a kick, with a force gradient too, adds to p what positions alone decide, and does nothing else.
    const KICKS_REPEAT: bool = false;
    /// Whether a kick does nothing but add to p. If not, [`kick_increments`](Separable::kick_increments) says what it adds.
    const KICKS_ADD: bool = true;
    /// Whether a kick where the energy is not defined leaves momenta that are not finite.
    const KICKS_SHOW: bool = false;
    /// Whether a drift is a linear map, so that it takes what a kick has added by itself.
    const DRIFTS_TAKE_KICKS: bool = false;
    /// Parts of a drift that may end within a step.
    const DRIFT_PARTS: &'static [FlowPart] = &[];
    /// Whether a drift adds to positions what momenta alone decide, and does nothing else. If not,
    /// [`drift_increments`](Separable::drift_increments) says what it adds.
    const DRIFTS_SHIFT: bool = true;

    /// Coefficients of a kick of length `h`.
    fn prepare_kick(&self, h: R) -> Self::Kick;
    /// Coefficients of a drift of length `h`.
    fn prepare_drift(&self, h: R) -> Self::Drift;
    /// The flow of V at frozen time: p ← p − h ∂V/∂q, s ← s − hV; of V + g·s: p ← e^(−gh)·p − …
    fn kick(&self, kick: &Self::Kick, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);
    /// The flow of T: q ← q + h ∂T/∂p; of T + g·s: p ← e^(−gh)·p, …
    fn drift(&self, drift: &Self::Drift, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut Self::Action);

    /// A drift after momenta have grown by `dp`. Where [`DRIFTS_TAKE_KICKS`](Separable::DRIFTS_TAKE_KICKS), the sums of where they were do not
    /// wait for the kick.
    #[inline(always)]
    fn drift_after(
        &self,
        drift: &Self::Drift,
        t: R,
        [q, p]: [&mut Self::Array; 2],
        s: &mut Self::Action,
        dp: &Self::Array,
    ) {
        p.add_scaled(R::from_f64(1.0), dp);
        self.drift(drift, t, q, p, s);
    }

    /// What a kick from `x` adds, for sums that compensate. A kick that does nothing but add is given zeros to add to.
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
    /// What a drift from `x` adds, in the same way.
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

/// T is a quadratic polynomial in p with constant coefficients: \[V, \[V, \[V, T\]\]\] = 0.
///
/// Runge–Kutta–Nyström tables need this; on any other T they would silently fall to order 3 or 4.
#[diagnostic::on_unimplemented(
    message = "the kinetic energy of `{Self}` is not quadratic in `p` with a constant mass matrix",
    label = "Runge–Kutta–Nyström tables lose their order on such a T",
    note = "tables for every separable energy: `StormerVerlet`, `BlanesMoan4`, `BlanesMoan6`, `Yoshida4.of(StormerVerlet)` …"
)]
pub trait QuadraticKinetic<R: Real = f64>: Separable<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
}

/// T is a quadratic polynomial in p: \[V, \[T, V\]\] is a function of q alone, and has an exact flow together with V.
///
/// With the force F = −∂V/∂q and the mass matrix M that function is F·M⁻¹F.
#[diagnostic::on_unimplemented(
    message = "the kinetic energy of `{Self}` is not quadratic in `p` with a constant mass matrix",
    label = "on such a T force gradients are no kicks",
    note = "tables for every separable energy: `StormerVerlet`, `BlanesMoan4`, `BlanesMoan6`, `Yoshida4.of(StormerVerlet)` …"
)]
pub trait ForceGradient<R: Real = f64>: QuadraticKinetic<R> {
    /// What a kick of given weights needs from the parameters.
    type GradientKick: Copy;

    /// Coefficients of a kick with `h` of the force and `g` of its gradient, both with their powers of the step size.
    fn prepare_gradient_kick(&self, h: R, g: R) -> Self::GradientKick;
    /// The flow of U = hV − g F·M⁻¹F at frozen time: p ← p + hF + g ∇(F·M⁻¹F), s ← s − U.
    fn gradient_kick(
        &self,
        kick: &Self::GradientKick,
        t: R,
        q: &mut Self::Array,
        p: &mut Self::Array,
        s: &mut Self::Action,
    );
}
