//! The step of a system with constraints, for [`Rattle`](super::Rattle), [`DiscreteGradient`](crate::DiscreteGradient), and their forms beside an action. The
//! attribute macros emit its equation as [`ConstrainedStep`]. This file connects the equation with the driver, and checks the constraints.
//!
//! The unknowns are multipliers μ = −½h²λ, and increments of positions and momenta if the method needs them. Both methods define their step by λ. μ moves the
//! positions by about W Gᵀμ, with G = ∂g/∂q and W = ∂²H/∂p². They also determine the normal parts of
//! momenta, if the equation makes its ends tangent.
//!
//! Constraints depend on each other if the rows of G do. A step is refused if det(G W G₁ᵀ) ≤ 0, where G₁ is G at a later position. This is a test, and no
//! proof: two changes of the sign within a step cancel. A step is also refused if its end is not on the constraints.

use crate::method::contact::ContactDiscreteGradient;
use crate::method::discrete_gradient::DiscreteGradient;
use crate::method::implicit::{
    Arrival, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Failure, Probe};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, sum};
use crate::space::{Array, PerCoordinate, Square};
use crate::system::{At, ConstrainedStep, held, on_one_side, tangent};

/// The step of the method `M`, whose equation is [`ConstrainedStep`].
#[derive(Clone, Copy, Debug)]
pub struct MultiplierStep<M>(
    /// The method.
    pub M,
);

/// A method for systems with constraints.
pub(crate) trait ConstrainedMethod: Copy + core::fmt::Debug {
    /// True if steps keep the energy, or its law of decay.
    const KEEPS_ENERGY: bool;
}

/// q₁ − q₀ = h ∇̄ₚH, P₁ − P₀ = −h (∇̄_qH + Ḡᵀλ), g(q₁) = 0 with multipliers λ. ∇̄H and the rows of Ḡ are the tree discrete gradients of H and of every g.
/// Without damping, H therefore changes by −λ·(g(q₁) − g(q₀)) = 0 between (q₀, P₀) and (q₁, P₁).
///
/// If T is quadratic in p, Pᵢ = pᵢ + Nᵀν with tangent pᵢ, the same ν at both ends, and rows of N along those of G(qᵢ) that are orthonormal in W. H(qᵢ, Pᵢ) is
/// then H(qᵢ, pᵢ) + |ν|²/2, so the energy is kept. For other T, Pᵢ = pᵢ.
impl ConstrainedMethod for DiscreteGradient {
    const KEEPS_ENERGY: bool = true;
}

/// The same step with the mean friction −hγ(P₀ + P₁)/2, and s₁ − s₀ = (P₀ + P₁)/2·(q₁ − q₀) − h H(x₀) φ₁(−hγ). If no constraint moves, H decays by e^(−hγ), and P₁ = p₁ + e^(−hγ/2)
/// Nᵀν.
impl ConstrainedMethod for ContactDiscreteGradient {
    const KEEPS_ENERGY: bool = true;
}

/// The momenta at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Momenta {
    /// Tangent to the constraints by a projection after the solution.
    Projected,
    /// Tangent by the equation of the step.
    Tangent,
    /// With a part normal to the constraints, of order h². A projection would change the energy.
    Carried,
}

/// Returns the momenta at the ends of steps of `M`.
const fn momenta<S: ConstrainedStep<M, R>, M: ConstrainedMethod, R: Real>() -> Momenta {
    match (M::KEEPS_ENERGY, S::QUADRATIC) {
        (false, _) => Momenta::Projected,
        (true, true) => Momenta::Tangent,
        (true, false) => Momenta::Carried,
    }
}

impl<S: ConstrainedStep<M, R>, M: ConstrainedMethod, R: Real> ImplicitStep<S, R> for MultiplierStep<M> {
    type Unknown = S::Unknown;
    type Coefficients = S::Constants;
    type Start = S::Start;
    type History = ();
    type LastEvaluation = ();
    type Kept = ();
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy {
        // Kept energy needs compensated sums.
        sums: if M::KEEPS_ENERGY { Sums::Compensated } else { Sums::OfTheRun },
        // RATTLE evaluates derivatives at both positions with the momenta of the middle. The other step evaluates divided differences between both ends.
        evaluated: if M::KEEPS_ENERGY { Evaluated::ByDifferences } else { Evaluated::Elsewhere },
        // g(q₁) = 0 determines μ to the rounding of q, and the momenta contain μ/h. Their error is about ε|q|/h. No projection removes it from carried momenta.
        // A state within a step is therefore computed from its farther end.
        is_rough_if_short: matches!(momenta::<S, M, R>(), Momenta::Carried),
        // `S::Unknown` does not tell multipliers from increments, so all unknowns count as one kind. Only the long searches read the units.
        ..Policy::of(Units { alike: S::Unknown::LEN, kinds: 1 })
    };
    /// A normal component changes H by its square only. Carried momenta have a normal component of order h². The state with tangent momenta is therefore off
    /// by O(h⁴) in its energy, and every composition has order 4 at most.
    const COMPOSES_TO: u32 = match momenta::<S, M, R>() {
        Momenta::Projected | Momenta::Tangent => u32::MAX,
        Momenta::Carried => 4,
    };

    fn coefficients(self, system: &S, h: R) -> S::Constants {
        system.constants(h)
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(from: &Departure<'_, S, R>, coefficients: &S::Constants, (): &mut ()) -> Result<S::Start, Failure> {
        Ok(from.system.begin(coefficients, from.middle(), from.t, from.end, &from.z, &from.s))
    }

    #[inline(always)]
    fn origin(Equation { from, coefficients, start }: &Equation<'_, Self, S, R>) -> S::Unknown {
        from.system.origin(coefficients, start)
    }

    /// Returns zero: no multiplier and no increment is known in advance.
    fn guess(_: &Equation<'_, Self, S, R>) -> S::Unknown {
        S::Unknown::zero()
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        Equation { from, coefficients, start }: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        x: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        // The time of the point only serves the message of a refusal. H is defined for every s.
        watch.visit(from.end, &sum(&from.z, &from.system.end(coefficients, start, x).z), &from.s);
        let mut residual = S::Unknown::zero();
        from.system.residual(coefficients, start, x, &mut residual, matrix);
        residual
    }

    #[inline(always)]
    fn update(
        Equation { from, coefficients, start }: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Unknown>,
        (): &(),
    ) -> Result<Increment<S::Phase, S::Action>, Failure> {
        let PerCoordinate { z: mut increments, s } = from.system.end(coefficients, start, &solution.x);
        let [q, p] = sum(&from.z, &increments);
        match momenta::<S, M, R>() {
            Momenta::Projected => {
                increments[1] = difference(&tangent(from.system, from.end, [q, p])?, &from.z[1]);
                independent(from, At { t: from.end, q: &q })?;
            }
            // The way to the middle suffices. Newton's matrix contains Ḡ W G₁ᵀ with G₁ at the end, and its determinant was positive. Ḡ is near G in the middle.
            Momenta::Tangent | Momenta::Carried => {
                let middle = moved(&from.z[0], R::from_f64(0.5), &increments[0]);
                independent(from, At { t: from.middle(), q: &middle })?;
            }
        }
        Ok(Increment::of(increments, s))
    }

    /// Checks g = 0 at the rounded end. The tolerance includes the rounding at the start, because the end is the rounded sum of the start and an increment.
    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Unknown>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Failure> {
        held(from.system, from.end, [&from.z, end.z])
    }

    /// Returns the dependence of constraints at the start of the step as the reason, if there is one.
    #[cold]
    fn explained(Equation { from, .. }: &Equation<'_, Self, S, R>, (): &(), refusal: Failure) -> Failure {
        independent(from, At { t: from.t, q: &from.z[0] }).err().unwrap_or(refusal)
    }
}

/// Refuses a step if the sign of det(G W G₁ᵀ) shows that constraints depend on each other at its start, at `later`, or between.
#[inline(always)]
fn independent<S: ConstrainedStep<M, R>, M, R: Real>(
    from: &Departure<'_, S, R>,
    later: At<'_, S::Array, R>,
) -> Result<(), Failure> {
    let first = At { t: from.t, q: &from.z[0] };
    on_one_side(from.system, &from.z, [first, later]).map_err(|what| Failure::DependentConstraints { what })
}
