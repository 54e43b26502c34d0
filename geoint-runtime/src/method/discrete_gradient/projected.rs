//! Order 4 by projection of a mean velocity: the equation is the system's, the step is here.

use super::mean::MeanGradient;
use super::{DiscreteGradient, FourthOrder};
use crate::method::corrected::range::is_representable;
use crate::method::corrected::{kept, rounded};
use crate::method::{Claims, Deciding, Method, Name, Probe, Refusal, Step, check_conditions, check_end, start};
use crate::scalar::Real;
use crate::solving::equation::Magnitudes;
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Compensated, Record, Snapshot, Square, Summation, Tape};
use crate::system::{FourthOrderField, Invariants, KeptBy, Poles, Span};

/// Coefficients of a step.
#[derive(Clone, Debug)]
pub struct Prepared<S: FourthOrderField<R>, R: Real> {
    parameters: S::FourthParameters,
    h: R,
    poles: Poles,
}

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<Z: Array> {
    newton: Newton<Z>,
    /// What is kept is worth compensated sums.
    sums: Compensated<Z>,
}

impl<Z: Array> Record<Z::Real> for Memory<Z> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        self.newton.record(tape);
        self.sums.record(tape);
    }
}

/// d = h·f̄(z, z + d).
struct Equation<'a, S: FourthOrderField<R>, R: Real> {
    system: &'a S,
    parameters: &'a S::FourthParameters,
    t: R,
    h: R,
    z: S::Phase,
    /// What z is too small by. Without it, what is kept drifts by some 10⁻²⁰ a step.
    compensation: S::Phase,
    begun: S::FourthStart,
}

impl<S: FourthOrderField<R>, R: Real> Clone for Equation<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: FourthOrderField<R>, R: Real> Copy for Equation<'_, S, R> {}

impl<S: FourthOrderField<R>, R: Real, P: Probe<S, R>> StepEquation<S::Phase, Deciding<'_, P, S::Phase>>
    for Equation<'_, S, R>
{
    const EFFORT: Effort = P::EFFORT;
    const MAGNITUDES: Magnitudes = if S::State::MOMENTA { Magnitudes::Recent } else { Magnitudes::Present };

    fn is_bound_by_energy(&self) -> bool {
        <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0
    }

    #[inline(always)]
    fn origin(&self) -> S::Phase {
        self.z
    }

    /// The explicit midpoint rule.
    fn guess(&self) -> S::Phase {
        let Equation { system, t, h, z, .. } = self;
        let half = R::from_f64(0.5) * *h;
        let mut rate = S::Phase::zero();
        system.rate(*t, z, &mut rate);
        system.rate(*t + half, &moved(z, half, &rate), &mut rate);
        scaled(*h, &rate)
    }

    #[inline(always)]
    fn residual(&self, watch: &mut Deciding<'_, P, S::Phase>, d: &S::Phase, matrix: &mut Square<S::Phase>) -> S::Phase {
        watch.visit(self.t, &sum(&self.z, d));
        let mut image = S::Phase::zero();
        // What counts is the mean z + d/2, as in steps of order 2.
        let point = moved(d, R::from_f64(2.0), &self.compensation);
        self.system.fourth_slope(self.parameters, &self.begun, &point, &mut image, matrix);
        difference(d, &image)
    }
}

impl<S: FourthOrderField<R>, R: Real> Method<S, R> for FourthOrder<DiscreteGradient> {
    type Proof = <S as FourthOrderField<R>>::Proof;
    type Prepared = Prepared<S, R>;
    type Memory = Memory<S::Phase>;
    const KEEPS: bool = <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0;

    #[inline]
    fn way_back(_: &Self::Prepared, system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &KeptBy::<S, R>::default(), origin, z)
    }

    /// The metric of a canonical system has the energy in it. That of a field has not.
    #[inline]
    fn is_in_range(_: &Self::Prepared, system: &S, z: &S::Phase) -> bool {
        !S::State::MOMENTA || is_representable(system, &KeptBy::<S, R>::default(), z)
    }

    fn claims(&self) -> Claims {
        Claims { order: 4, symmetric: true, symplectic: false, conserves_energy: true, perturbed: &[], forces: None }
    }

    fn name(&self) -> Name {
        Name::new("FourthOrder").of(self.0.mean_name())
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { parameters: system.fourth_parameters(h), h, poles: Poles::of(system) }
    }

    fn memory() -> Self::Memory {
        Memory { newton: Newton::new(S::State::ALIKE, S::Phase::LEN / S::State::ALIKE), sums: Compensated::new() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { parameters, h, poles }: &Self::Prepared,
        Memory { newton, sums }: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (z, h, span) = (x.z, *h, Span::of([t, end], *h));
        probe.visit(t, &z, &());
        let begun = system.fourth_begin(parameters, span, &z);
        let compensation = if C::PLAIN { sums.compensation() } else { x.sums.compensation() };
        let mut deciding = Deciding::of::<S, R>(probe, &z);
        let equation = Equation { system, parameters, t, h, z, compensation, begun };
        let before = P::EFFORT.is_thorough().then_some(*newton);
        let mut found = newton.solve(&equation, &mut deciding);
        if let (Some(before), Err(_)) = (before, found) {
            // On an orbit on which gradients depend on each other all along, as a circle, no step keeps all in this way.
            let mut loose = equation;
            if S::fourth_loosen(&mut loose.begun) {
                *newton = before;
                found = newton.solve(&loose, &mut deciding);
            }
        }
        let Solution { x: d, rounding_error } = found?;
        let Deciding { probe, decided } = deciding;
        let before = start::<S, R, C>(x);
        x.add_with(sums, &d, &rounding_error);
        rounded::check_step::<S, R, P, C>(system, [t, end], &before.0, x)?;
        check_conditions(system, span.middle, &decided, x)?;
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}
