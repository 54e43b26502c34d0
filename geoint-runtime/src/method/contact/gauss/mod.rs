//! Gauss collocation for contact systems.

mod stages;

use crate::implicit_method;
use crate::method::implicit::SolvedBy;
use crate::method::{Claims, Name};
use crate::scalar::Real;
use crate::system::PhaseSpace;

pub use stages::ContactFieldStages;

/// Gauss collocation with `S` stages, 1 to 6, in the symplectisation. Order 2S, symmetric, a contact map, for every contact Hamiltonian H(q, p, s, t).
///
/// The symplectisation adds one dimension r to the [flow](crate::method::contact) of H: r' = r ∂H/∂s, and r = 1 at the start of a step. With P = r p, the flow
/// solves Hamilton's equations of r H(q, P/r, s) for the pairs (q, P) and (r, s). Collocation of Hamilton's equations is symplectic. It commutes with scaling
/// of (P, r), and is therefore a contact map (see [`ContactMidpoint`](crate::ContactMidpoint) for the reference). A step multiplies ds − p dq by 1/r₁, with r₁
/// at its end. Let aᵢⱼ and bⱼ be the coefficients and weights of Gauss's method. With derivatives at stage j under each sum, the equations are
///
/// qᵢ = q₀ + h Σ aᵢⱼ ∂H/∂p, rᵢ pᵢ = p₀ − h Σ aᵢⱼ rⱼ ∂H/∂q, sᵢ = s₀ + h Σ aᵢⱼ (p·∂H/∂p − H), rᵢ = 1 + h Σ aᵢⱼ rⱼ ∂H/∂s,
///
/// and r₁ = 1 + h Σ bⱼ rⱼ ∂H/∂s. With one stage the method is `ContactMidpoint`. The unknowns are the increments of q, p and s from the start to all stages. If
/// H = g(t)·s + H₀(q, p, t), s is no unknown: the factors rᵢ are known beforehand, and s follows from q and p. A step is refused if r₁ is not positive, or if
/// the equations of rᵢ or s' are singular. [Every implicit step](crate::method::implicit) has further causes of refusal.
///
/// Steps keep linear symmetries. Let A be a constant matrix and b a constant vector. If the flow multiplies p·(Aq + b) by the same factor as ds − p dq, a
/// step multiplies both by 1/r₁. An example is angular momentum under a central force.
///
/// A Lagrangian is solved for the velocities of stages if it is quadratic in v, or if its Legendre transform H has no short formula. The equation of the
/// momenta is then rᵢ ∂L/∂v(qᵢ, vᵢ, sᵢ) = p₀ + h Σ aᵢⱼ rⱼ ∂L/∂q. Unless L = L₀(q, v, t) − g(t)·s, s is also an unknown. The map does not change. A stage has n
/// or n + 1 unknowns in place of 2n or 2n + 1, with n degrees of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactGauss<const S: usize>;

// For contact systems, `symplectic` claims a contact map.
implicit_method!(
    [const S: usize] ContactGauss<S>,
    |_| Name::new(
        [
            "ContactGauss<1>",
            "ContactGauss<2>",
            "ContactGauss<3>",
            "ContactGauss<4>",
            "ContactGauss<5>",
            "ContactGauss<6>",
        ][S - 1]
    ),
    Claims::of_order(2 * S as u32).symmetric().symplectic()
);

/// A contact system with [`ContactGauss`] methods of 1 to 6 stages. Implemented automatically, as one bound for generic code.
pub trait SolvedByContactGauss<R: Real = f64>:
    PhaseSpace<R>
    + SolvedBy<ContactGauss<1>, R>
    + SolvedBy<ContactGauss<2>, R>
    + SolvedBy<ContactGauss<3>, R>
    + SolvedBy<ContactGauss<4>, R>
    + SolvedBy<ContactGauss<5>, R>
    + SolvedBy<ContactGauss<6>, R>
{
}

impl<Y, R: Real> SolvedByContactGauss<R> for Y where
    Y: PhaseSpace<R>
        + SolvedBy<ContactGauss<1>, R>
        + SolvedBy<ContactGauss<2>, R>
        + SolvedBy<ContactGauss<3>, R>
        + SolvedBy<ContactGauss<4>, R>
        + SolvedBy<ContactGauss<5>, R>
        + SolvedBy<ContactGauss<6>, R>
{
}
