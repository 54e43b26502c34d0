//! Lagrangians with an action whose steps are solved for velocities: Herglotz' principle without an energy as a function of momenta.

use super::velocities::{MassForm, accelerated, velocity_of};
use crate::scalar::{Real, zero};
use crate::space::vector::{moved, opposite};
use crate::space::{Array, Square};
use crate::system::Contact;

/// L(q, v, s, t) and its derivatives at a stage. The derivatives of L by q, v and s are f, p and −σ.
#[derive(Clone, Copy, Debug)]
pub struct ContactStage<A: Array> {
    /// L.
    pub lagrangian: A::Real,
    /// p = ∂L/∂v.
    pub momentum: A,
    /// f = ∂L/∂q.
    pub force: A,
    /// σ = −∂L/∂s.
    pub decay: A::Real,
    /// ∂p/∂q, ∂p/∂v, ∂f/∂q and ∂f/∂v.
    pub derivatives: [Square<A>; 4],
    /// ∂p/∂s and ∂f/∂s, which are −∂σ/∂v and −∂σ/∂q.
    pub by_action: [A; 2],
    /// ∂σ/∂s.
    pub decay_by_action: A::Real,
}

impl<A: Array> ContactStage<A> {
    pub(crate) fn none() -> Self {
        let none = A::zero();
        ContactStage {
            lagrangian: zero(),
            momentum: none,
            force: none,
            decay: zero(),
            derivatives: [A::fill(none); 4],
            by_action: [none; 2],
            decay_by_action: zero(),
        }
    }

    /// Returns v' at velocity v, without the change of L in time.
    pub(crate) fn acceleration(&self, v: &A) -> A {
        let ContactStage { derivatives: [by_q, mass, ..], by_action: [by_s, _], .. } = self;
        let rate = moved(&moved(&self.force, -self.decay, &self.momentum), -self.lagrangian, by_s);
        accelerated(rate, by_q, v, *mass)
    }
}

/// Equations of s' = L, d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v.
pub trait ContactVelocities<R: Real = f64>: MassForm<R> + Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// v and s of a stage, in a row; or v alone, if ∂L/∂s depends on time alone.
    type Moved: Array<Real = R>;
    /// Coefficients that depend on parameters only.
    type StageConstants: Copy + core::fmt::Debug;
    /// Second derivatives that L has: by q and v, by v and s, and by q and s.
    const MIXED: [bool; 3];

    /// Computes the coefficients that depend on parameters only.
    fn stage_constants(&self) -> Self::StageConstants;
    /// Computes all entries of a stage.
    fn stage(
        &self,
        constants: &Self::StageConstants,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &R,
        stage: &mut ContactStage<Self::Array>,
    );
    /// Computes f and σ alone.
    fn force(
        &self,
        constants: &Self::StageConstants,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &R,
    ) -> (Self::Array, R);
}

/// The polarised discrete gradient of an L that is quadratic in v, with decay.
///
/// Λ(q, s; v₀, v₁) is defined in [`PolarisedForm`](super::PolarisedForm). Its tree slopes in q and s are Λ_q and Λ_s, p̄ = (p₀ + p₁)/2, and H₀ is the
/// energy p·v − L before the step. Time is frozen in the middle of the step. With p = ∂L/∂v at both ends, the step is
///
/// q₁ − q₀ = h v̄, p₁ − p₀ = h(Λ_q + Λ_s p̄), s₁ − s₀ = h(p̄·v̄ − H₀ φ₁(hΛ_s)).
///
/// Then H₁ = H₀ exp(hΛ_s).
pub trait ContactPolarised<R: Real = f64>: ContactVelocities<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The increments of v and s in a row.
    type Unknown: Array<Real = R>;
    /// Coefficients that depend on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// Coefficients that depend on the start of a step.
    type Start: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters and h only.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// Computes the coefficients that all evaluations from a point have in common. `t` is the time of the middle of the step.
    fn begin(&self, parameters: &Self::Parameters, t: R, z: &Self::Phase, s: &R, v: &Self::Array) -> Self::Start;
    /// Computes the residuals, the increments of p and s, and the derivatives of both. The residuals are ∂L/∂v at the end minus p₁ of the step, and the
    /// increment of s minus its increment by the step.
    fn equation(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        values: [&mut Self::Unknown; 2],
        derivatives: [&mut Square<Self::Unknown>; 2],
    );
}

/// Computes ∂H/∂q = −∂L/∂q, ∂H/∂p = v and ∂H/∂s = −∂L/∂s at a point.
#[inline]
pub fn contact_gradient_of<S: ContactVelocities<R>, R: Real>(
    system: &S,
    t: R,
    z: &S::Phase,
    s: &R,
    slopes: &mut S::Phase,
    ds: &mut R,
) {
    let v = velocity_of(system, t, z, s);
    let (force, decay) = ContactVelocities::force(system, &system.stage_constants(), t, &z[0], &v, s);
    (*slopes, *ds) = ([opposite(&force), v], decay);
}
