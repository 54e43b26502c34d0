//! Perturbed systems H = A + B: A has an exact flow, and the perturbation B is a kick.

use super::{Cotangent, FlowKind};
use crate::scalar::Real;
use crate::space::PerCoordinate;

/// A system with H = A(q, p, t) + B(q, t), where A has an exact flow. The error of a step is proportional to B, so a small B permits long steps.
///
/// The flows of A and B may act in inner coordinates, for instance in Jacobi coordinates for bodies that attract each other.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no part with an exact flow beside a rest that is a kick",
    label = "H was not parted into A + B",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait Perturbed<R: Real = f64>: Cotangent<R, Action = ()> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of the flow of A of given length.
    type Exact: Copy;
    /// Coefficients of a kick by B of given length.
    type Rest: Copy;
    /// What the flow of A does.
    const EXACT: FlowKind = FlowKind::MOVES;
    /// What the flow of B does. If it is no kick, [`rest_increments`](Perturbed::rest_increments) returns its increments.
    const REST: FlowKind = FlowKind::ADDS;
    /// Whether [`rest`](Perturbed::rest) is the flow of B. If not, it is a symmetric step of order 2.
    const REST_IS_EXACT: bool = true;
    /// Whether A and B act in inner coordinates, which differ from those of states.
    const INNER: bool = false;

    /// Computes the coefficients of the flow of A of length `h`.
    fn prepare_exact(&self, h: R) -> Self::Exact;
    /// Computes the coefficients of a kick by B of length `h`.
    fn prepare_rest(&self, h: R) -> Self::Rest;
    /// Applies the flow of A.
    fn exact(&self, flow: &Self::Exact, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut ());
    /// Applies the flow of B at frozen time: p ← p − h ∂B/∂q.
    fn rest(&self, kick: &Self::Rest, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut ());

    /// Returns the increments of `x` by the flow of A, for compensated sums.
    #[inline(always)]
    fn exact_increments(
        &self,
        flow: &Self::Exact,
        t: R,
        x: &PerCoordinate<Self::Phase, ()>,
    ) -> PerCoordinate<Self::Phase, ()> {
        let mut d: PerCoordinate<Self::Phase, ()> = PerCoordinate::nothing();
        self.exact(flow, t, &mut d.z[0], &mut x.z[1].clone(), &mut d.s);
        d
    }

    /// Returns the increments of `x` by a kick by B, for compensated sums.
    #[inline(always)]
    fn rest_increments(
        &self,
        kick: &Self::Rest,
        t: R,
        x: &PerCoordinate<Self::Phase, ()>,
    ) -> PerCoordinate<Self::Phase, ()> {
        let mut d: PerCoordinate<Self::Phase, ()> = PerCoordinate::nothing();
        self.rest(kick, t, &mut x.z[0].clone(), &mut d.z[1], &mut d.s);
        d
    }

    /// Converts the coordinates of a state to the inner coordinates, in which A and B act.
    #[inline(always)]
    fn enter(&self, _z: &mut Self::Phase) {}

    /// Converts the inner coordinates to the coordinates of a state.
    #[inline(always)]
    fn leave(&self, _z: &mut Self::Phase) {}

    /// Returns a message if there are no inner coordinates for these parameters.
    fn unsuitable(&self) -> Option<&'static str> {
        None
    }
}

/// Returns the message of the first mass whose sum with other masses, by which it is divided, has lost all digits: |sum| < ε |mass|.
///
/// Returns `None` if a mass is zero. The energy is then undefined, which is reported elsewhere.
#[cold]
pub fn unsuitable<R: Real>(masses: &[R], shares: &[([R; 2], &'static str)]) -> Option<&'static str> {
    if masses.iter().any(|mass| mass.magnitude() == 0.0) {
        return None;
    }
    let lost = |[mass, sum]: [R; 2]| sum.magnitude() < R::epsilon() * mass.magnitude();
    shares.iter().find(|(share, _)| lost(*share)).map(|(_, what)| *what)
}

/// A perturbed system in which A is of degree 2 in p, with a constant matrix a of the squares.
///
/// Then \[B, \[A, B\]\] = F·aF with F = −∂B/∂q depends on q only, and \[B, \[B, \[B, A\]\]\] = 0. Thus all tables of Runge–Kutta–Nyström type, and those with
/// force gradients, keep their order.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no kick with a force gradient beside its part with an exact flow",
    label = "that part is not of degree 2 in `p` with constant coefficients",
    note = "tables without force gradients: `WisdomHolman`, `Aba10_6_4`"
)]
pub trait PerturbedGradient<R: Real = f64>: Perturbed<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of a kick of given weights.
    type GradientKick: Copy;
    /// Computes the coefficients of a kick. `h` is the weight of the force and `g` that of its gradient. Both include their powers of the step size.
    fn prepare_gradient_kick(&self, h: R, g: R) -> Self::GradientKick;
    /// Applies the flow of hB − g F·aF at frozen time: p ← p + hF + g ∇(F·aF).
    fn gradient_kick(&self, kick: &Self::GradientKick, t: R, q: &mut Self::Array, p: &mut Self::Array);
}
