//! Lagrangians with an action whose steps are solved for velocities: Herglotz' principle without an energy as a function of momenta.

use super::velocities::{MassForm, accelerated, velocity_of};
use crate::scalar::{Real, zero};
use crate::space::vector::{moved, opposite};
use crate::space::{Array, Square};
use crate::system::Contact;

/// L(q, v, s, t) at a stage, by its derivatives: those by q, v and s of L are f, p and −σ.
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

    /// v' at velocity v, but for the change of L in time.
    pub(crate) fn acceleration(&self, v: &A) -> A {
        let ContactStage { derivatives: [by_q, mass, ..], by_action: [by_s, _], .. } = self;
        let rate = moved(&moved(&self.force, -self.decay, &self.momentum), -self.lagrangian, by_s);
        accelerated(rate, by_q, v, *mass)
    }
}

/// The equations of s' = L, d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v.
pub trait ContactVelocities<R: Real = f64>: MassForm<R> + Contact<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// v and s of a stage, in a row; or v alone, where ∂L/∂s depends on time alone.
    type Moved: Array<Real = R>;
    /// What depends on parameters only.
    type StageConstants: Copy + core::fmt::Debug;
    /// Whether L has second derivatives by q and v, by v and s, and by q and s.
    const MIXED: [bool; 3];

    /// What depends on parameters only.
    fn stage_constants(&self) -> Self::StageConstants;
    /// Everything of a stage.
    fn stage(
        &self,
        constants: &Self::StageConstants,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &R,
        stage: &mut ContactStage<Self::Array>,
    );
    /// f and σ alone.
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
/// With Λ(q, s; v₀, v₁) as in [`PolarisedForm`](super::PolarisedForm), its tree slopes Λ_q, Λ_s in q and s, p̄ = (p₀ + p₁)/2, and H₀ the
/// energy p·v − L before the step, all with time frozen in its middle:
///
/// q₁ − q₀ = h v̄, p₁ − p₀ = h(Λ_q + Λ_s p̄), s₁ − s₀ = h(p̄·v̄ − H₀ φ₁(hΛ_s)) with p = ∂L/∂v at both ends. Then H₁ = H₀ exp(hΛ_s).
pub trait ContactPolarised<R: Real = f64>: ContactVelocities<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The increments of v and s in a row.
    type Unknown: Array<Real = R>;
    /// What depends on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// What depends on the start of a step.
    type Start: Copy + core::fmt::Debug;

    /// What depends on parameters and h only.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// What all evaluations from a point have in common; `t` is the time of the middle of the step.
    fn begin(&self, parameters: &Self::Parameters, t: R, z: &Self::Phase, s: &R, v: &Self::Array) -> Self::Start;
    /// ∂L/∂v at the end less p₁ as the step gives it, and the increment of s less that of the step; then the increments of p and s as the
    /// step gives them; and the derivatives of all that.
    fn equation(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Unknown,
        values: [&mut Self::Unknown; 2],
        derivatives: [&mut Square<Self::Unknown>; 2],
    );
}

/// ∂H/∂q = −∂L/∂q, ∂H/∂p = v and ∂H/∂s = −∂L/∂s at a point.
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
