//! The discrete gradient method for contact systems. It keeps the decay law of the energy.

/// Discrete gradient for H(q, p, s): H(x₁) = H(x₀) exp(−h g_s) to rounding, for every h, where g_s is a mean of ∂H/∂s. Order 2, symmetric; *not* a contact
/// map. A step solves one equation for the 2n + 1 unknowns x = (q, p, s), with n degrees of freedom.
///
/// The differential equation is x' = S(p) ∇H − H e_s with S = ((0, 1, 0), (−1, 0, −p), (0, pᵀ, 0)) and the unit vector e_s of s. Therefore H' = −H ∂H/∂s. Let
/// g be the tree discrete gradient of H between both ends, g_s its entry for s, and p̄ = (p₀ + p₁)/2. The step is
///
/// x₁ = x₀ + h (S(p̄) g − H̄ e_s), H̄ = H(x₀) φ₁(−h g_s), φ₁(z) = (e^z − 1)/z.
///
/// S is antisymmetric and drops out of H(x₁) − H(x₀) = g·(x₁ − x₀) = −h g_s H̄. The sign of H, and the level H = 0, are kept. If ∂H/∂s is a constant γ, H
/// decays as in the flow, by e^(−γh) a step. If ∂H/∂s is 0, H is kept.
///
/// If H depends on time, time is frozen at the middle t̄ of the step: H(x₁, t̄) = H(x₀, t̄) exp(−h g_s). Order and symmetry stay. If a contact map matters
/// more than the decay of H, use [`ContactMidpoint`](crate::ContactMidpoint).
///
/// Beside constraints g(q, t) = 0, for H = H₀(q, p, t) + γ(t)·s, the force −Ḡᵀλ joins, where Ḡ is the discrete gradient of g and g(q₁) = 0 determines λ. If
/// no constraint moves, the law of H stays; otherwise H₁ = e^(−hγ) H₀ + φ₁(−hγ)·W with their work W. If H₀ is quadratic in p, momenta are tangent to the
/// constraints. Steps with hγ ≤ −2 are refused.
///
/// A Lagrangian that is quadratic in the velocities v may have no short formula for H, for example because its mass matrix is full. Steps of such a
/// Lagrangian are solved for velocities, by the polarised discrete gradient. The law is H(x₁) = H(x₀) exp(hΛ_s) with p·v − L for H. Here Λ_s is the entry for
/// s of the tree discrete gradient of the polarised Lagrangian Λ, a mean of ∂L/∂s = −∂H/∂s. The kernel `PolarisedForm` defines Λ.
///
/// The differential equation: A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17. The discrete gradient g:
/// [`DiscreteGradient`](crate::DiscreteGradient). We are not aware of this method in the literature.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactDiscreteGradient;
