//! H = A + B: a part with an exact flow, and a rest that is a kick.

use super::{Cotangent, FlowPart};
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate};

/// H = A(q, p, t) + B(q, t), A with an exact flow: where B is small, steps are as long as B is small.
///
/// A and B move in coordinates of their own, if the system has such: those of Jacobi for bodies that attract each other.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no part with an exact flow beside a rest that is a kick",
    label = "H was not parted into A + B",
    note = "methods for every energy: `ImplicitMidpoint`, `Gauss`, `DiscreteGradient`"
)]
pub trait Perturbed<R: Real = f64>: Cotangent<R, Action = ()> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What the flow of A of given length needs from the parameters.
    type Exact: Copy;
    /// What the flow of A after a kick needs from the parameters, if it is linear.
    type After: Copy;
    /// What a kick by B of given length needs from the parameters.
    type Rest: Copy;
    /// Whether the flow of A from t on is exact in its own time, or takes place at the frozen time t of the kicks.
    const EXACT_IN_TIME: bool = false;
    /// Whether a kick by B adds to p what positions alone decide.
    const KICKS_REPEAT: bool = false;
    /// Whether B is a function of positions and time, so that its flow is a kick. If not,
    /// [`rest_increments`](Perturbed::rest_increments) says what it adds.
    const REST_IS_KICK: bool = true;
    /// Whether [`rest`](Perturbed::rest) is the flow of B. If not, it is a symmetric step of order 2.
    const REST_IS_EXACT: bool = true;
    /// Whether the flow of A is a linear map whose coefficients are prepared, so that [`exact_after`](Perturbed::exact_after) is there.
    const IS_LINEAR: bool = false;
    /// Parts of the flow of A that may end within a step.
    const PARTS: &'static [FlowPart] = &[];
    /// Whether A and B move in other coordinates than those of states.
    const INNER: bool = false;

    /// Coefficients of the flow of A of length `h`.
    fn prepare_exact(&self, h: R) -> Self::Exact;
    /// Coefficients of a kick by B of length `h`.
    fn prepare_rest(&self, h: R) -> Self::Rest;
    /// The flow of A.
    fn exact(&self, flow: &Self::Exact, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut ());
    /// The flow of B at frozen time: p ← p − h ∂B/∂q.
    fn rest(&self, kick: &Self::Rest, t: R, q: &mut Self::Array, p: &mut Self::Array, s: &mut ());

    /// Coefficients of the flow of A after a kick.
    fn prepare_after(&self, h: R) -> Self::After;
    /// The flow of A after momenta have grown by `dp`: the sums of where they were do not wait for the kick.
    #[inline(always)]
    fn exact_after(&self, _: &Self::After, _: &mut Self::Array, p: &mut Self::Array, dp: &Self::Array) {
        p.add_scaled(R::from_f64(1.0), dp);
    }

    /// What the flow of A from `x` adds, for sums that compensate.
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

    /// What a kick by B from `x` adds, in the same way.
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

    /// From the coordinates of a state to those in which A and B move.
    #[inline(always)]
    fn enter(&self, _z: &mut Self::Phase) {}

    /// And back.
    #[inline(always)]
    fn leave(&self, _z: &mut Self::Phase) {}

    /// Why there are no such coordinates for these parameters.
    fn unsuitable(&self) -> Option<&'static str> {
        None
    }
}

/// The first mass beside which no digit is left of the sum of masses that it is divided by. Where a mass is zero the energy is not defined,
/// which is to be said instead.
#[cold]
pub fn unsuitable<R: Real>(masses: &[R], shares: &[([R; 2], &'static str)]) -> Option<&'static str> {
    if masses.iter().any(|mass| mass.magnitude() == 0.0) {
        return None;
    }
    let lost = |[mass, sum]: [R; 2]| sum.magnitude() < R::epsilon() * mass.magnitude();
    shares.iter().find(|(share, _)| lost(*share)).map(|(_, what)| *what)
}

/// A is of degree 2 in p, its squares with constant coefficients a: \[B, \[A, B\]\] = F·aF with F = −∂B/∂q is a function of q alone, and
/// \[B, \[B, \[B, A\]\]\] = 0, so that all tables of Runge–Kutta–Nyström type and with force gradients keep their order.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no kick with a force gradient beside its part with an exact flow",
    label = "that part is not of degree 2 in `p` with constant coefficients",
    note = "tables without force gradients: `WisdomHolman`, `Aba10_6_4`"
)]
pub trait PerturbedGradient<R: Real = f64>: Perturbed<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What a kick of given weights needs from the parameters.
    type GradientKick: Copy;
    /// Coefficients of a kick with `h` of the force and `g` of its gradient, both with their powers of the step size.
    fn prepare_gradient_kick(&self, h: R, g: R) -> Self::GradientKick;
    /// The flow of hB − g F·aF at frozen time: p ← p + hF + g ∇(F·aF).
    fn gradient_kick(&self, kick: &Self::GradientKick, t: R, q: &mut Self::Array, p: &mut Self::Array);
}
