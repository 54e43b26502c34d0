//! Lagrangians L(q, v, s, t) whose steps are solved for velocities, with or without an action s: the kernels of Gauss stages and of the polarised discrete
//! gradient. The attribute macros emit them. An associated `Proof` is `()`; a system without the property lacks it.
//!
//! The equations of motion are d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v and s' = L (Herglotz' principle). A step has half of the unknowns of a step for an energy
//! H, and needs no formula for v(p).

use super::mass::{MassForm, accelerated, velocity_of};
use crate::scalar::{Real, zero};
use crate::space::vector::{moved, opposite};
use crate::space::{Array, Square};
use crate::system::{Contact, Invariants, PhaseSpace};

/// L(q, v, s, t) and its derivatives at a stage: p = ∂L/∂v, f = ∂L/∂q − Cv + F with the friction matrix C and other forces F, and σ = −∂L/∂s. Without an
/// action, kernels write p, f and `derivatives` only. With an action, f is ∂L/∂q alone: it contains neither C nor F, nor the term −σp of p'.
#[derive(Clone, Copy, Debug)]
pub struct VelocityStage<A: Array> {
    /// L.
    pub lagrangian: A::Real,
    /// p.
    pub momentum: A,
    /// f.
    pub force: A,
    /// σ.
    pub decay: A::Real,
    /// ∂p/∂q, ∂p/∂v, ∂f/∂q and ∂f/∂v.
    pub derivatives: [Square<A>; 4],
    /// ∂p/∂s and ∂f/∂s, which are −∂σ/∂v and −∂σ/∂q.
    pub by_action: [A; 2],
    /// ∂σ/∂s.
    pub decay_by_action: A::Real,
}

/// The derivatives of p and f that may differ from zero, marked by true. Steps skip the products with the others. ∂p/∂v and ∂f/∂q are always multiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MixedDerivatives {
    /// ∂p/∂q.
    pub momentum_by_q: bool,
    /// ∂p/∂s.
    pub momentum_by_s: bool,
    /// ∂f/∂v, which contains friction.
    pub force_by_v: bool,
    /// ∂f/∂s.
    pub force_by_s: bool,
}

impl<A: Array> VelocityStage<A> {
    /// Returns zeros, which a kernel overwrites.
    pub(crate) fn none() -> Self {
        let none = A::zero();
        VelocityStage {
            lagrangian: zero(),
            momentum: none,
            force: none,
            decay: zero(),
            derivatives: [A::fill(none); 4],
            by_action: [none; 2],
            decay_by_action: zero(),
        }
    }
}

/// The kernels of L and its derivatives for the stages of Gauss methods.
pub trait VelocityForm<R: Real = f64>: MassForm<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The unknowns of a stage in a row: v, and s if σ depends on more than time, or p or f reads s.
    type Unknown: Array<Real = R>;
    /// Coefficients that depend on parameters only.
    type StageConstants: Copy + core::fmt::Debug;
    /// The derivatives of p and f that may differ from zero.
    const MIXED: MixedDerivatives;

    /// Computes the coefficients that depend on parameters only.
    fn stage_constants(&self) -> Self::StageConstants;
    /// Computes L and its derivatives at a stage.
    fn stage(
        &self,
        constants: &Self::StageConstants,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &Self::Action,
        stage: &mut VelocityStage<Self::Array>,
    );
    /// Returns f and σ alone. Without an action, σ is zero.
    fn force(
        &self,
        constants: &Self::StageConstants,
        t: R,
        q: &Self::Array,
        v: &Self::Array,
        s: &Self::Action,
    ) -> (Self::Array, R);
}

/// The polarised discrete gradient of a Lagrangian that is quadratic in v, L = ½vᵀM v + a·v − V, with M, a and V that depend on q, s and t. Order 2,
/// symmetric.
///
/// Let Λ(q, s; v₀, v₁) = ½v₀ᵀM v₁ + a·v̄ − V with v̄ = (v₀ + v₁)/2. Let Λ_q and Λ_s be its tree discrete gradient
/// ([`DiscreteGradient`](crate::DiscreteGradient)) between both ends, at the time in the middle. Without an action, p = Mv + a at the times t and t + h of
/// the ends. With the friction matrix C and other forces F, a step is
///
/// q₁ − q₀ = h v̄, p₁ − p₀ = h(Λ_q − C v̄ + F).
///
/// If L does not read time, H = p·v − L changes by h v̄·(F − C v̄). With an action there is neither C nor F, and p = Mv + a at both ends also reads the time
/// in the middle. Let p̄ = (p₀ + p₁)/2, H₀ the energy before the step, and φ₁(x) = (eˣ − 1)/x. A step is
///
/// q₁ − q₀ = h v̄, p₁ − p₀ = h(Λ_q + Λ_s p̄), s₁ − s₀ = h(p̄·v̄ − H₀ φ₁(hΛ_s)).
///
/// Then H₁ = H₀ exp(hΛ_s), with H₀ and H₁ at this time.
pub trait PolarisedForm<R: Real = f64>: VelocityForm<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The increments of v in a row, and of s if there is an action.
    type Increments: Array<Real = R>;
    /// The invariants that steps keep to rounding: the energy if there are no action, friction and forces, and L does not read time. Otherwise `()`.
    type Kept: Invariants<Self, R> + Default;
    /// Coefficients that depend on parameters and h only.
    type Parameters: Copy + core::fmt::Debug;
    /// Coefficients that also depend on the start of a step.
    type Start: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters and h only.
    fn parameters(&self, h: R) -> Self::Parameters;
    /// Computes the coefficients that all evaluations from a point have in common. `t` is the time of the middle of the step, also without an action: the
    /// kernel derives t + h/2 for p at the end.
    fn begin(
        &self,
        parameters: &Self::Parameters,
        t: R,
        z: &Self::Phase,
        s: &Self::Action,
        v: &Self::Array,
    ) -> Self::Start;
    /// Computes `values`, which are the residuals and the increments of p and s, and the derivatives of both by the increments d of v and s. The residuals
    /// are M v₁ + a at the end minus p₁ of the step, and the increment of s in d minus the increment of s in the step.
    fn equation(
        &self,
        parameters: &Self::Parameters,
        start: &Self::Start,
        d: &Self::Increments,
        values: [&mut Self::Increments; 2],
        derivatives: [&mut Square<Self::Increments>; 2],
    );
}

/// Computes (q', p') = (v, f) at a point of a system without an action. NaN if no velocity is found.
#[inline]
pub fn rate_of<S, R: Real>(system: &S, t: R, z: &S::Phase, dz: &mut S::Phase)
where
    S: VelocityForm<R> + PhaseSpace<R, Action = ()>,
{
    let v = velocity_of(system, t, z, &());
    *dz = [v, system.force(&system.stage_constants(), t, &z[0], &v, &()).0];
}

/// Computes ∂H/∂q = −∂L/∂q and ∂H/∂p = v into `slopes`, and ∂H/∂s = −∂L/∂s into `ds`. NaN if no velocity is found.
#[inline]
pub fn contact_gradient_of<S: VelocityForm<R> + Contact<R>, R: Real>(
    system: &S,
    t: R,
    z: &S::Phase,
    s: &R,
    slopes: &mut S::Phase,
    ds: &mut R,
) {
    let v = velocity_of(system, t, z, s);
    let (force, decay) = system.force(&system.stage_constants(), t, &z[0], &v, s);
    (*slopes, *ds) = ([opposite(&force), v], decay);
}

/// Returns v' and s' at a point, for a first guess. The explicit dependence of ∂L/∂v on time is left out.
#[inline]
pub(crate) fn rates_of_velocity<S: VelocityForm<R>, R: Real>(
    system: &S,
    t: R,
    q: &S::Array,
    v: &S::Array,
    s: &S::Action,
) -> (S::Array, R) {
    let mut at = VelocityStage::none();
    system.stage(&system.stage_constants(), t, q, v, s, &mut at);
    // M v' = f − σp − L ∂p/∂s − (∂p/∂q)v, with s' = L. `accelerated` subtracts the last term, and solves.
    let rate = moved(&moved(&at.force, -at.decay, &at.momentum), -at.lagrangian, &at.by_action[0]);
    let [by_q, mass, ..] = at.derivatives;
    (accelerated(rate, &by_q, v, mass), at.lagrangian)
}
