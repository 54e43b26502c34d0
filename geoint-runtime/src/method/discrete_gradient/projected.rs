//! Order 4 by projection of a mean velocity: the equation is the system's, the step is here.

use super::mean::MeanGradient;
use super::{DiscreteGradient, FourthOrder};
use crate::ablation;
use crate::method::corrected::range::is_representable;
use crate::method::corrected::{kept, rounded};
use crate::method::{Claims, Deciding, Method, Name, Probe, Refusal, Step, check_conditions, check_end, start};
use crate::scalar::Real;
use crate::solving::equation::StepEquation;
use crate::solving::newton::{Found, Newton};
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Compensated, Record, Snapshot, Square, Summation, Tape};
use crate::system::{FourthOrderField, Invariants, KeptBy, Poles, Span};

/// From so many unknowns on what is evaluated is so long that a call costs nothing beside it: Kepler's problem, with four, takes the same time, and
/// two thirds of the code. With two, as a pendulum, a call costs a fifth of the time.
const LONG: usize = 4;

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
    const PATIENT: bool = P::PATIENT;
    const SETTLED: bool = <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0;
    const OF_NOW: bool = !S::State::MOMENTA;
    /// For the gradients of momenta it would not do: they may nearly depend on that of the energy, and then the projection changes much on a short way.
    const NEARLY: bool = ablation::SERIES_MATRIX
        && S::State::MOMENTA
        && S::Phase::LEN >= LONG
        && <KeptBy<S, R> as Invariants<S, R>>::Values::LEN == 1;

    #[inline(always)]
    fn origin(&self) -> S::Phase {
        self.z
    }

    /// What counts is the mean z + d/2, as in steps of order 2.
    #[inline(always)]
    fn point(&self, d: &S::Phase) -> S::Phase {
        if ablation::CARRIES { moved(d, R::from_f64(2.0), &self.compensation) } else { *d }
    }

    #[inline(always)]
    fn unknown(&self, point: &S::Phase) -> S::Phase {
        if ablation::CARRIES { moved(point, R::from_f64(-2.0), &self.compensation) } else { *point }
    }

    /// The explicit midpoint rule.
    fn explicit(&self) -> S::Phase {
        let Equation { system, t, h, z, .. } = self;
        let half = R::from_f64(0.5) * *h;
        let mut rate = S::Phase::zero();
        system.rate(*t, z, &mut rate);
        system.rate(*t + half, &moved(z, half, &rate), &mut rate);
        scaled(*h, &rate)
    }

    #[inline(always)]
    fn evaluate(&self, watch: &mut Deciding<'_, P, S::Phase>, d: &S::Phase, matrix: &mut Square<S::Phase>) -> S::Phase {
        if const { S::Phase::LEN >= LONG } {
            return self.apart::<false, P>(watch, d, matrix);
        }
        watch.visit(self.t, &sum(&self.z, d));
        let mut image = S::Phase::zero();
        self.system.fourth_slope::<false>(self.parameters, &self.begun, d, &mut image, matrix);
        image
    }

    #[inline(always)]
    fn nearly(&self, watch: &mut Deciding<'_, P, S::Phase>, d: &S::Phase, matrix: &mut Square<S::Phase>) -> S::Phase {
        self.apart::<true, P>(watch, d, matrix)
    }

    /// Of a step that needs more than one evaluation, or is watched: apart for few unknowns, too. A pendulum is a fifth less to compile, and 3 to 5 %
    /// slower in long steps; kernels of fields are short, and up to a tenth slower.
    #[inline(always)]
    fn residual(&self, watch: &mut Deciding<'_, P, S::Phase>, x: &S::Phase, matrix: &mut Square<S::Phase>) -> S::Phase {
        let point = <Self as StepEquation<S::Phase, Deciding<'_, P, S::Phase>>>::point(self, x);
        if const { S::State::MOMENTA } {
            difference(x, &self.apart::<false, P>(watch, &point, matrix))
        } else {
            difference(x, &self.evaluate(watch, &point, matrix))
        }
    }
}

impl<S: FourthOrderField<R>, R: Real> Equation<'_, S, R> {
    #[inline(always)]
    fn apart<const NEARLY: bool, P: Probe<S, R>>(
        &self,
        watch: &mut Deciding<'_, P, S::Phase>,
        d: &S::Phase,
        matrix: &mut Square<S::Phase>,
    ) -> S::Phase {
        watch.visit(self.t, &sum(&self.z, d));
        let mut image = S::Phase::zero();
        if const { ablation::ONE_FUNCTION } {
            slope_apart::<NEARLY, _, _>(self.system, self.parameters, &self.begun, d, &mut image, matrix);
        } else {
            self.system.fourth_slope::<NEARLY>(self.parameters, &self.begun, d, &mut image, matrix);
        }
        image
    }
}

/// Here once for all evaluations that are not in the loop over steps.
#[inline(never)]
fn slope_apart<const NEARLY: bool, S: FourthOrderField<R>, R: Real>(
    system: &S,
    parameters: &S::FourthParameters,
    begun: &S::FourthStart,
    d: &S::Phase,
    image: &mut S::Phase,
    matrix: &mut Square<S::Phase>,
) {
    system.fourth_slope::<NEARLY>(parameters, begun, d, image, matrix);
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
        let before = P::PATIENT.then_some(*newton);
        let mut found = newton.solve(&equation, &mut deciding);
        if let (Some(before), Err(_)) = (before, found.outcome) {
            // On an orbit on which gradients depend on each other all along, as a circle, no step keeps all in this way.
            let mut loose = equation;
            if S::fourth_loosen(&mut loose.begun) {
                *newton = before;
                found = newton.solve(&loose, &mut deciding);
            }
        }
        let Found { x: d, lost, outcome } = found;
        outcome?;
        let Deciding { probe, decided } = deciding;
        let before = start::<S, R, C>(x);
        x.add_with(sums, &d, &if ablation::CARRIES { lost } else { S::Phase::zero() });
        rounded::check_step::<S, R, P, C>(system, [t, end], &before.0, x)?;
        check_conditions(system, span.middle, &decided, x)?;
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}
