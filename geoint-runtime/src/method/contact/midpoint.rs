//! The implicit midpoint rule one dimension up.

/// The implicit midpoint rule in the symplectisation. Order 2, symmetric, a contact map, for every H; one Newton solve a step,
/// for 2n + 1 unknowns.
///
/// K = −θ H(q, −P/θ, s) is a Hamiltonian with the conjugate pairs (q, P) and (s, θ), homogeneous of degree 1 in (P, θ), and its
/// flow is that of H for p = −P/θ. The midpoint rule is symplectic, and commutes with scaling of (P, θ) because that is linear:
/// so it is a contact map. Without θ, with all derivatives at (q̄, p̄, s̄) and in the middle of the step,
///
/// q₁ = q₀ + h ∂H/∂p, (1 + hσ/2) p₁ = (1 − hσ/2) p₀ − h ∂H/∂q, s₁ = s₀ + h (p̄·∂H/∂p − H), σ = ∂H/∂s;
///
/// q̄ and s̄ are means of both ends, p̄ = ((1 − hσ/2) p₀ + (1 + hσ/2) p₁)/2 is weighted by θ. A step multiplies the form
/// ds − p dq by (1 − hσ/2)/(1 + hσ/2), and is refused where |hσ| ≥ 2 and that is not positive. By the same factor it multiplies
/// p·(Aq + b) where the flow multiplies that by its own, as it does angular momentum under a central force.
///
/// Where H does not depend on s this is [`ImplicitMidpoint`](crate::ImplicitMidpoint). H itself decays as the flow has it to
/// order 2 only: [`ContactDiscreteGradient`](crate::ContactDiscreteGradient) has a law for that, and is no contact map.
///
/// K. Feng & M. Qin, *Symplectic Geometric Algorithms for Hamiltonian Systems* (2010), 11.4.3, the contact algorithm C̄; contact
/// maps as symplectic maps that commute with scaling are their section 11.2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactMidpoint;
