//! The step of a system with constraints g(q) = 0. Its equation is given by [`ConstrainedStep`]: the unknowns are increments and multipliers, in units of positions.

use crate::method::discrete_gradient::DiscreteGradient;
use crate::method::implicit::{
    Arrival, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, sum};
use crate::space::{Array, Square};
use crate::system::{ConstrainedStep, held, on_one_side, tangent};

/// The step of the method `M`, whose equation is [`ConstrainedStep`].
#[derive(Clone, Copy, Debug)]
pub struct MultiplierStep<M>(
    /// The method.
    pub M,
);

/// The treatment of momenta by a method with constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Momenta {
    /// At the end of a step they are made tangent to the constraints.
    MadeTangent,
    /// Momenta are not projected: they keep a component normal to the constraints, of order h².
    Carried,
}

/// A method for systems with constraints.
pub trait ConstrainedMethod: Copy + core::fmt::Debug {
    /// The treatment of momenta.
    const MOMENTA: Momenta;
}

/// q₁ − q₀ = h ∇̄ₚH, p₁ − p₀ = −h (∇̄_qH + ḡᵀλ), g(q₁) = 0 with multipliers λ. ∇̄H and ḡ are the tree slopes of H and of
/// every g, so H changes by −λ·(g(q₁) − g(q₀)) = 0.
impl ConstrainedMethod for DiscreteGradient {
    const MOMENTA: Momenta = Momenta::Carried;
}

impl<S: ConstrainedStep<M, R>, M: ConstrainedMethod, R: Real> ImplicitStep<S, R> for MultiplierStep<M> {
    type Unknown = S::Unknown;
    type Constants = S::Constants;
    type Start = S::Start;
    type History = ();
    type Seen = ();
    type Kept = ();
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy {
        sums: match M::MOMENTA {
            Momenta::MadeTangent => Sums::OfTheRun,
            Momenta::Carried => Sums::Compensated,
        },
        evaluated: match M::MOMENTA {
            Momenta::MadeTangent => Evaluated::Elsewhere,
            Momenta::Carried => Evaluated::ByDifferences,
        },
        ..Policy::of(Units { alike: S::Unknown::LEN, kinds: 1 })
    };
    /// The normal component of momenta is of order h². A state with tangent momenta has another energy by O(h⁴), so compositions have order 4 at most.
    const COMPOSES_TO: u32 = match M::MOMENTA {
        Momenta::MadeTangent => u32::MAX,
        Momenta::Carried => 4,
    };
    /// g(q₁) = 0 determines h²λ to the rounding of q, so momenta have an error of ε|q|/h. No projection removes it.
    const ROUGH_IF_SHORT: bool = matches!(M::MOMENTA, Momenta::Carried);

    fn constants(self, system: &S, h: R) -> S::Constants {
        system.constants(h)
    }

    fn history() {}

    fn unseen() {}

    #[inline(always)]
    fn begin(from: &Departure<'_, S, R>, constants: &S::Constants, (): &mut ()) -> Result<S::Start, Refusal> {
        let t = match M::MOMENTA {
            Momenta::MadeTangent => from.t,
            Momenta::Carried => from.middle(),
        };
        Ok(from.system.begin(constants, t, &from.z))
    }

    #[inline(always)]
    fn origin(Equation { from, constants, start }: &Equation<'_, Self, S, R>) -> S::Unknown {
        from.system.origin(constants, start)
    }

    /// Zero: the first correction is that of an explicit step.
    fn guess(_: &Equation<'_, Self, S, R>) -> S::Unknown {
        S::Unknown::zero()
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        x: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        watch.visit(from.t, &sum(&from.z, &from.system.end(constants, start, x)), &());
        let mut residual = S::Unknown::zero();
        from.system.residual(constants, start, x, &mut residual, matrix);
        residual
    }

    #[inline(always)]
    fn update(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Unknown>,
        (): &(),
    ) -> Result<Increment<S::Phase, ()>, Refusal> {
        let mut increments = from.system.end(constants, start, &solution.x);
        let [q, p] = sum(&from.z, &increments);
        let checked = match M::MOMENTA {
            Momenta::MadeTangent => {
                increments[1] = difference(&tangent(from.system, from.end, [q, p])?, &from.z[1]);
                q
            }
            // The matrix of the equation pairs gradients in the middle with those at the end, and its determinant was positive.
            Momenta::Carried => moved(&from.z[0], R::from_f64(0.5), &increments[0]),
        };
        independent(from, &checked)?;
        Ok(Increment::of(increments))
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Unknown>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        held(from.system, from.end, [&from.z, end.z])
    }

    /// If constraints depend on each other at the start, this is the reason.
    #[cold]
    fn explained(Equation { from, .. }: &Equation<'_, Self, S, R>, (): &(), refusal: Refusal) -> Refusal {
        independent(from, &from.z[0]).err().unwrap_or(refusal)
    }
}

/// Refuses a step if constraints depend on each other at its start, or on the way to q.
#[inline(always)]
fn independent<S: ConstrainedStep<M, R>, M, R: Real>(from: &Departure<'_, S, R>, q: &S::Array) -> Result<(), Refusal> {
    on_one_side(from.system, (from.t, &from.z), [&from.z[0], q]).map_err(|what| Refusal::DependentConstraints { what })
}
