//! Discrete gradient of a contact system. The energy decays as the differential equation requires.

/// Discrete gradient for H(q, p, s): H(x₁) = H(x₀) exp(−h g_s) to rounding, for every h. Order 2, symmetric; *not* a contact map. One Newton solve a
/// step, for 2n + 1 unknowns.
///
/// The equation is x' = S(p) ∇H − H e_s with S = ((0, 1, 0), (−1, 0, −p), (0, pᵀ, 0)), so that H' = −H ∂H/∂s. With the tree discrete gradient g of H
/// between both ends, and p̄ = (p₀ + p₁)/2, the step is
///
/// x₁ = x₀ + h (S(p̄) g − H̄ e_s), H̄ = H(x₀) φ₁(−h g_s), φ₁(z) = (e^z − 1)/z.
///
/// S takes no part in H(x₁) − H(x₀) = g·(x₁ − x₀) = −h g_s H̄. The sign of H, and the level H = 0, are kept. If ∂H/∂s is a constant γ, H decays as in
/// the flow, by e^(−γh) a step. If ∂H/∂s is 0, H is kept.
///
/// If H depends on time, time is frozen at the middle t̄ of the step: H(x₁, t̄) = H(x₀, t̄) exp(−h g_s). Order and symmetry stay. For geometry instead
/// of decay use [`ContactMidpoint`](crate::ContactMidpoint).
///
/// A Lagrangian whose mass matrix is full is solved for velocities, and has the polarised discrete gradient. The law is unchanged, with p·v − L for H.
/// See [`PolarisedForm`](crate::system::PolarisedForm).
///
/// The equation: A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17. g is the discrete gradient of
/// [`DiscreteGradient`](crate::DiscreteGradient). We are not aware of this method in the literature.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactDiscreteGradient;
