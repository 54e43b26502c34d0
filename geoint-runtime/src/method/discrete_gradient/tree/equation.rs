//! The equation of a step, impulse = h·f̄(y, y + d(impulse)), and what its roundings lose.
//!
//! The impulse is what f̄ adds to what it changes: to y = (q, p) itself; or, if T is quadratic, to the momenta alone, and then the
//! increment of y = q is d = h ∂T/∂p at the mean momentum.

use crate::method::{Deciding, Probe};
use crate::scalar::{Real, exact_sum, zero};
use crate::solving::Inverse;
use crate::solving::equation::Magnitudes;
use crate::solving::equation::{Effort, StepEquation};
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Compensated, Point, Snapshot, Square, Summation};
use crate::system::{DiscreteField, Invariants, KeptBy, Span};

/// Returns whether runs remove the drift of what steps keep.
const fn removes_drift<S: DiscreteField<R>, R: Real>() -> bool {
    <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0
}

/// Whether an impulse turns a momentum round, so that digits of the mean are lost.
#[inline(always)]
fn turns<R: Real>(mean: R, p: R) -> bool {
    mean.magnitude() < 0.125 * p.magnitude()
}

/// What depends on parameters and h.
#[derive(Clone, Debug)]
pub(super) struct Coefficients<S: DiscreteField<R>, R: Real> {
    constants: S::Constants,
    parameters: S::Parameters,
    pub(super) h: R,
}

impl<S: DiscreteField<R>, R: Real> Coefficients<S, R> {
    pub(super) fn new(system: &S, h: R) -> Self {
        Coefficients { constants: system.constants(), parameters: system.parameters(h), h }
    }

    /// The increment d of y that goes with an impulse on `changed`.
    ///
    /// It is one product of h/2m with 2p + dp, which is rounded as p + dp/2 is. h p/m + h dp/2m is not the same: where h is 0.1, roundings of its
    /// two products do not average out, and the energy of a pendulum drifts by 10⁻¹² in a million steps.
    #[inline(always)]
    fn change(&self, system: &S, changed: &S::Unknown, impulse: &S::Unknown) -> S::Unknown {
        if S::DERIVATIVE == 1 {
            return *impulse;
        }
        system.drift(&self.parameters, &sum(&sum(changed, changed), impulse))
    }

    /// h·f̄ and Newton's matrix.
    #[inline(always)]
    fn evaluate(
        &self,
        system: &S,
        start: &S::Start,
        d: &S::Unknown,
        image: &mut S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) {
        system.equation((&self.constants, self.h), &self.parameters, start, d, image, matrix);
    }

    /// Newton's matrix where that is the same in all steps.
    pub(super) fn constant_matrix(&self, system: &S) -> Square<S::Unknown> {
        let origin = S::Unknown::zero();
        let start = system.begin(&self.parameters, Span::at(zero()), &origin);
        let (mut f, mut matrix) = (origin, S::Unknown::fill(origin));
        self.evaluate(system, &start, &origin, &mut f, &mut matrix);
        matrix
    }
}

/// The equation of one step.
pub(super) struct Equation<'a, S: DiscreteField<R>, R: Real> {
    system: &'a S,
    coefficients: &'a Coefficients<S, R>,
    t: R,
    z: S::Phase,
    y: S::Unknown,
    /// What the impulse is added to.
    pub(super) changed: S::Unknown,
    /// Compensations: what y is too small by, nothing where the step is not to count with it, and what `changed` is too small by. No `Option`:
    /// whether it is one would be asked in every iteration that is out of line.
    compensation: (S::Unknown, S::Unknown),
    start: S::Start,
}

impl<S: DiscreteField<R>, R: Real> Clone for Equation<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: DiscreteField<R>, R: Real> Copy for Equation<'_, S, R> {}

impl<'a, S: DiscreteField<R>, R: Real> Equation<'a, S, R> {
    #[inline(always)]
    pub(super) fn of_step<C: Summation<S::Phase>>(
        system: &'a S,
        coefficients: &'a Coefficients<S, R>,
        ends: [R; 2],
        x: &Point<S::Phase, C>,
        sums: &Compensated<S::Phase>,
    ) -> Self {
        let mut z = x.z;
        // An array of one number is passed in an integer register: it is copied as a number.
        if const { S::Unknown::LEN == 1 } {
            z = S::Phase::zero();
            z.copy_from(&x.z);
        }
        let (y, changed) = S::start(&z);
        let start = system.begin(&coefficients.parameters, Span::of(ends, coefficients.h), &y);
        let lost = if C::PLAIN && S::DERIVATIVE == 1 { sums.compensation() } else { x.sums.compensation() };
        let (of_y, of_changed) = S::start(&lost);
        // Where drift is removed, rounding errors of single steps do not matter.
        let counts = const { !removes_drift::<S, R>() } && (!C::PLAIN || S::DERIVATIVE == 1);
        let compensation = (if counts { of_y } else { S::Unknown::nothing() }, of_changed);
        Equation { system, coefficients, t: ends[0], z, y, changed, compensation, start }
    }

    /// The increments of (q, p) that go with an impulse.
    #[inline(always)]
    pub(super) fn increments(&self, impulse: &S::Unknown) -> S::Phase {
        S::increments(&self.coefficients.change(self.system, &self.changed, impulse), impulse)
    }

    /// h·f̄ for no impulse.
    #[inline(always)]
    pub(super) fn without_impulse<P: Probe<S, R>>(&self, watch: &mut Deciding<'_, P, S::Phase>) -> S::Unknown {
        let none = S::Unknown::zero();
        let (mut image, mut unused) = (none, S::Unknown::fill(none));
        let change = self.coefficients.change(self.system, &self.changed, &none);
        watch.visit(self.t, &self.end(&change, &none));
        self.coefficients.evaluate(self.system, &self.start, &change, &mut image, &mut unused);
        image
    }

    /// The impulse where h·f̄ is affine in it, and the increments of (q, p) that go with it.
    ///
    /// Where a step is much longer than an oscillation an impulse turns p round, and of the mean of p no digits are left: it is then solved for
    /// itself, K p̄ = p + ½ h f̄(y, y) with the matrix K of the impulse, and the impulse follows from it. Without this the energy of an
    /// oscillator changes by hω roundings in every step.
    #[inline(always)]
    pub(super) fn affine<P: Probe<S, R>>(
        &self,
        inverse: &S::Inverse,
        watch: &mut Deciding<'_, P, S::Phase>,
    ) -> (S::Unknown, S::Phase) {
        let (mut impulse, half) = (inverse.times(&self.without_impulse(watch)), R::from_f64(0.5));
        let mean = moved(&self.changed, half, &impulse);
        let mut ends = mean.as_slice().iter().zip(self.changed.as_slice());
        if S::DERIVATIVE == 1 || !ends.any(|(mean, p)| turns(*mean, *p)) {
            return (impulse, self.increments(&impulse));
        }
        let mean = self.mean(inverse, mean, &mut impulse);
        (impulse, S::increments(&self.system.drift(&self.coefficients.parameters, &sum(&mean, &mean)), &impulse))
    }

    /// The mean of p, solved for where an impulse turns p round, and that impulse.
    #[cold]
    #[inline(never)]
    fn mean(&self, inverse: &S::Inverse, mut mean: S::Unknown, impulse: &mut S::Unknown) -> S::Unknown {
        let none = S::Unknown::zero();
        let (mut image, mut unused) = (none, S::Unknown::fill(none));
        self.coefficients.evaluate(self.system, &self.start, &none, &mut image, &mut unused);
        let solved = inverse.times(&moved(&self.changed, R::from_f64(0.5), &image));
        let entries = mean.as_mut_slice().iter_mut().zip(impulse.as_mut_slice());
        for ((mean, impulse), (solved, p)) in entries.zip(solved.as_slice().iter().zip(self.changed.as_slice())) {
            if turns(*mean, *p) {
                (*mean, *impulse) = (*solved, R::from_f64(2.0) * (*solved - *p));
            }
        }
        mean
    }

    /// The increment of y at which f̄ is evaluated.
    #[inline(always)]
    fn evaluated<P: Probe<S, R>>(&self, watch: &mut Deciding<'_, P, S::Phase>, impulse: &S::Unknown) -> S::Unknown {
        let change = self.coefficients.change(self.system, &self.changed, impulse);
        watch.visit(self.t, &self.end(&change, impulse));
        // f̄ reads the mean y + d/2. Doubled first: what is nothing leaves no operation behind where the compiler knows it.
        sum(&change, &sum(&self.compensation.0, &self.compensation.0))
    }

    /// The end of the step for these increments.
    #[inline(always)]
    fn end(&self, change: &S::Unknown, impulse: &S::Unknown) -> S::Phase {
        sum(&self.z, &S::increments(change, impulse))
    }

    /// Returns the rounding errors of the increments of (q, p): that of the impulse, `lost`, and for y the rounding of the mean in [`Coefficients::change`] with the
    /// compensation that the mean does not see.
    ///
    /// Without them, the energy of a pendulum drifts by 4·10⁻²⁰ a step at h = 0.1, and by 10⁻¹⁹ at 0.2. They are zero if runs remove drift.
    #[inline(always)]
    pub(super) fn lost<C: Summation<S::Phase>>(&self, impulse: &S::Unknown, lost: &S::Unknown) -> S::Phase {
        let mut change = S::Unknown::nothing();
        if S::DERIVATIVE == 1 {
            change = *lost;
        } else if !C::PLAIN {
            let (mut mean, half) = (self.compensation.1, R::from_f64(0.5));
            mean.add_scaled(half, lost);
            for (i, mean) in mean.as_mut_slice().iter_mut().enumerate() {
                *mean += exact_sum(self.changed.as_slice()[i], half * impulse.as_slice()[i]).1;
            }
            self.system.add(&self.coefficients.constants, self.coefficients.h, &mean, &mut change);
        }
        S::increments(&change, lost)
    }
}

impl<S: DiscreteField<R>, R: Real, P: Probe<S, R>> StepEquation<S::Unknown, Deciding<'_, P, S::Phase>>
    for Equation<'_, S, R>
{
    const EFFORT: Effort = P::EFFORT;
    const MAGNITUDES: Magnitudes = if S::State::MOMENTA { Magnitudes::Recent } else { Magnitudes::Present };

    /// Friction takes energy away, and only explicit time may add some.
    fn is_bound_by_energy(&self) -> bool {
        S::State::MOMENTA || removes_drift::<S, R>()
    }

    /// −2p as an impulse turns p round, and the mean of p is 0.
    fn standstill(&self) -> f64 {
        if S::DERIVATIVE == 1 { 0.0 } else { -2.0 }
    }

    #[inline(always)]
    fn origin(&self) -> S::Unknown {
        self.changed
    }

    /// The impulse of the explicit midpoint rule.
    fn guess(&self) -> S::Unknown {
        let Equation { system, coefficients: Coefficients { constants, h, .. }, t, y, changed, .. } = self;
        let (half, mut f) = (R::from_f64(0.5) * *h, S::Unknown::zero());
        let mut unused = S::Unknown::fill(f);
        let mut rate = system.velocity(constants, changed);
        if S::DERIVATIVE == 1 {
            system.field(constants, *t, y, &mut rate, &mut unused);
        }
        system.field(constants, *t + half, &moved(y, half, &rate), &mut f, &mut unused);
        scaled(*h, &f)
    }

    #[inline(always)]
    fn residual(
        &self,
        watch: &mut Deciding<'_, P, S::Phase>,
        impulse: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let change = self.evaluated(watch, impulse);
        let mut image = S::Unknown::zero();
        self.coefficients.evaluate(self.system, &self.start, &change, &mut image, matrix);
        difference(impulse, &image)
    }

    /// Without a matrix: its entries would be computed, because the optimiser cannot see that nobody reads them.
    #[inline(always)]
    fn image(&self, watch: &mut Deciding<'_, P, S::Phase>, impulse: &S::Unknown) -> S::Unknown {
        let change = self.evaluated(watch, impulse);
        let Coefficients { parameters, h, .. } = self.coefficients;
        let (mut f, mut unused) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        self.system.slope(parameters, &self.start, &change, &mut f, &mut unused);
        scaled(*h, &f)
    }
}
