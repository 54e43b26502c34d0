//! The implicit midpoint rule for contact systems.

/// The implicit midpoint rule in the symplectisation. Order 2, symmetric, a contact map, for every H(q, p, s, t). A step solves one equation for the 2n + 1
/// unknowns q, p and s, with n degrees of freedom.
///
/// The symplectisation adds one dimension θ. K = −θ H(q, −P/θ, s) is a Hamiltonian with the conjugate pairs (q, P) and (s, θ), homogeneous of degree 1 in
/// (P, θ). Its flow is the flow of H for p = −P/θ. The midpoint rule is symplectic. It commutes with scaling of (P, θ), because this scaling is linear. The
/// midpoint rule for K is therefore a contact map for H. Without θ, and with all derivatives at (q̄, p̄, s̄) and in the middle of the step, the equations
/// are
///
/// q₁ = q₀ + h ∂H/∂p, (1 + hσ/2) p₁ = (1 − hσ/2) p₀ − h ∂H/∂q, s₁ = s₀ + h (p̄·∂H/∂p − H), σ = ∂H/∂s.
///
/// q̄ and s̄ are means of both ends. p̄ = ((1 − hσ/2) p₀ + (1 + hσ/2) p₁)/2 is weighted by θ. A step multiplies the contact form ds − p dq by the factor
/// (1 − hσ/2)/(1 + hσ/2). A step is refused if |hσ| ≥ 2, where this factor is not positive. Let A be a constant matrix and b a constant
/// vector. If the flow multiplies p·(Aq + b) by the factor of its contact form, a step multiplies it by the factor of the step. An example is angular
/// momentum under a central force.
///
/// If H does not depend on s, this method is [`ImplicitMidpoint`](crate::ImplicitMidpoint). The decay of H agrees with the flow to order 2 only.
/// [`ContactDiscreteGradient`](crate::ContactDiscreteGradient) keeps the decay law of H, and is no contact map.
///
/// K. Feng & M. Qin, *Symplectic Geometric Algorithms for Hamiltonian Systems* (2010), 11.4.3, the contact algorithm C̄. Section 11.2 there describes
/// contact maps as symplectic maps that commute with scaling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactMidpoint;
