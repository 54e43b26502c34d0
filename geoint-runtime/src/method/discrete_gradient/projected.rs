//! The step of `FourthOrder(DiscreteGradient)`: d = h·f̄(z, z + d) for the increment d of all coordinates z. [`FourthOrder`] documents the method.
//!
//! f̄ = F − M G (Gᵀ M G)⁻¹ Gᵀ F: F is a mean velocity of order 4, the columns of G are discrete gradients of the kept invariants (energy, momenta, first
//! integrals), and M is a metric. [`FourthOrderField`] defines f̄: for canonical systems by the functions of `canonical.rs`, for other fields by emitted code,
//! with M = 1.

use super::mean::MeanGradient;
use super::{DiscreteGradient, FourthOrder};
use crate::implicit_method;
use crate::method::corrected::range::is_representable;
use crate::method::corrected::rounded;
use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitMethod, ImplicitStep, Increment, Policy, Sums, Units,
    Watch,
};
use crate::method::{Claims, Failure, Name, Probe};
use crate::scalar::Real;
use crate::solving::equation::{Magnitudes, Solution, Solver};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Snapshot, Square};
use crate::system::{FourthOrderField, Invariants, KeptBy, Span};

implicit_method!(
    FourthOrder<DiscreteGradient>,
    |_| Name::new("FourthOrder").of(DiscreteGradient.mean_name()),
    Claims::of_order(4).symmetric().conserving_energy()
);

impl<S: FourthOrderField<R>, R: Real> ImplicitMethod<S, R> for FourthOrder<DiscreteGradient> {
    type Proof = <S as FourthOrderField<R>>::Proof;
    type Step = Self;

    fn step(self) -> Self {
        self
    }
}

impl<S: FourthOrderField<R>, R: Real> ImplicitStep<S, R> for FourthOrder<DiscreteGradient> {
    type Unknown = S::Phase;
    type Coefficients = S::FourthParameters;
    type Start = S::FourthStart;
    type History = ();
    type LastEvaluation = ();
    type Kept = KeptBy<S, R>;
    type Solver = Newton<S::Phase>;

    const POLICY: Policy = Policy {
        // Large forces may cancel in canonical systems. First integrals of fields may be steep where coordinates are small.
        magnitudes: if S::State::MOMENTA { Magnitudes::Recent } else { Magnitudes::Present },
        // Every solution satisfies the balance of the kept invariants.
        branch: if <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0 { Branch::OfEnergy } else { Branch::Continuous },
        sums: Sums::Compensated,
        evaluated: Evaluated::AtTheEnd,
        ..Policy::of(Units { alike: S::State::ALIKE, kinds: S::Phase::LEN / S::State::ALIKE })
    };

    fn coefficients(self, system: &S, h: R) -> S::FourthParameters {
        system.fourth_parameters(h)
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(
        from: &Departure<'_, S, R>,
        parameters: &S::FourthParameters,
        (): &mut (),
    ) -> Result<S::FourthStart, Failure> {
        Ok(from.system.fourth_begin(parameters, Span::of([from.t, from.end], from.h), &from.z))
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Phase {
        equation.from.z
    }

    /// Returns the increment of the explicit midpoint rule.
    fn guess(Equation { from: Departure { system, t, h, z, .. }, .. }: &Equation<'_, Self, S, R>) -> S::Phase {
        let (half, mut rate) = (R::from_f64(0.5) * *h, S::Phase::zero());
        system.rate(*t, z, &mut rate);
        system.rate(*t + half, &moved(z, half, &rate), &mut rate);
        scaled(*h, &rate)
    }

    /// Returns d − h·f̄, and writes its derivative.
    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        Equation { from, coefficients, start }: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        d: &S::Phase,
        matrix: &mut Square<S::Phase>,
    ) -> S::Phase {
        watch.visit(from.end, &sum(&from.z, d), &());
        // The exact ends are z + c and z + c + d with the compensation c. The increment d + 2c from z keeps their mean exact, and moves each end by c.
        let (compensated, mut image) = (moved(d, R::from_f64(2.0), &from.compensation), S::Phase::zero());
        from.system.fourth_slope(coefficients, start, &compensated, &mut image, matrix);
        difference(d, &image)
    }

    /// Returns the solution of the equation. Along some orbits, such as a circle, the gradients of invariants depend on each other, and the projection is
    /// singular. If a thorough attempt finds no solution, it therefore excludes nearly dependent momenta, and tries again.
    #[inline(always)]
    fn solve<P: Probe<S, R>>(
        mut equation: Equation<'_, Self, S, R>,
        newton: &mut Newton<S::Phase>,
        watch: &mut Watch<'_, S, R, P, ()>,
    ) -> Result<Solution<S::Phase>, Failure> {
        if !P::EFFORT.is_thorough() {
            return newton.solve(&equation, watch);
        }
        let before = *newton;
        newton.solve(&equation, watch).or_else(|refusal| {
            if !S::fourth_loosen(&mut equation.start) {
                return Err(refusal);
            }
            *newton = before;
            newton.solve(&equation, watch)
        })
    }

    #[inline(always)]
    fn update(
        _: &Equation<'_, Self, S, R>,
        Solution { x: z, rounding_error, .. }: &Solution<S::Phase>,
        (): &(),
    ) -> Result<Increment<S::Phase, ()>, Failure> {
        Ok(Increment { z: *z, s: (), rounding_error: *rounding_error })
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Phase>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Failure> {
        rounded::check_step::<S, R>(P::EFFORT, from, end)
    }

    /// Returns whether the kept invariants neither underflow nor overflow. Only canonical systems are checked: their metric M is made of
    /// energies, whose products may leave the range.
    fn is_in_range(system: &S, z: &S::Phase) -> bool {
        !S::State::MOMENTA || is_representable(system, &KeptBy::<S, R>::default(), z)
    }
}
