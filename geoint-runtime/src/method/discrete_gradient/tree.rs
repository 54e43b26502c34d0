//! The step of the tree discrete gradient ∇̄H of an energy, or of a first integral of a field: u = h·f̄(y, y + d(u)) for the impulse u.
//!
//! f̄ is the mean right-hand side, J∇̄H for y = (q, p), and the impulse is the increment d of y. If T is quadratic, y = q and f̄ = −∇̄V: the impulse is the increment
//! of the momenta, and d = h ∂T/∂p at the mean momentum.

use super::energy::{Energy, Slope};
use super::mean::MeanGradient;
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::corrected::rounded;
use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Claims, Name, Probe, Refusal};
use crate::scalar::{Real, exact_sum, zero};
use crate::solving::Inverse;
use crate::solving::equation::{Magnitudes, Solution, Solver};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Snapshot, Square};
use crate::system::{Conservative, DiscreteField, Invariants, KeptBy, Span};

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with the tree discrete gradient: accepted steps keep the energy to rounding, for every h.
///
/// Order 2, symmetric, for every H; not symplectic. ∇̄H is the reverse sweep of H with divided differences in place of
/// derivatives, in forms without cancellation. Linear and quadratic momenta are kept as well, if they commute with each innermost
/// linear or quadratic form in which H is written: write central forces as functions of `x * x + y * y`. One
/// Newton solve a step, for half of the unknowns if T is quadratic, and none if H is a quadratic polynomial. With damping C the energy falls by exactly h ∇̄H·C ∇̄H
/// instead. In compositions with steps back in time, this balance holds for each substep.
/// T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020; R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[doc(alias("energy-momentum", "energy conserving", "energy-preserving"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DiscreteGradient;

implicit_method!(
    DiscreteGradient,
    |_| Name::new("DiscreteGradient"),
    Claims::of_order(2).symmetric().conserving_energy()
);
substeps!([] DiscreteGradient);

/// The tree discrete gradient, for methods that build on it.
impl MeanGradient for DiscreteGradient {
    fn mean_name(&self) -> Name {
        Name::new("DiscreteGradient")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Refusal> {
        Ok(energy.tree(x, d))
    }
}

/// The step along the tree discrete gradient of [`DiscreteField`].
#[derive(Clone, Copy, Debug)]
pub struct TreeStep;

/// Values that depend on parameters and h.
#[derive(Clone, Debug)]
pub struct Constants<S: DiscreteField<R>, R: Real> {
    constants: S::Constants,
    parameters: S::Parameters,
    /// The inverse of the matrix, if the matrix is the same in all steps.
    inverse: S::Inverse,
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: DiscreteField<R>, R: Real> {
    y: S::Unknown,
    /// The coordinates to which the impulse is added: y, or p.
    changed: S::Unknown,
    /// The compensation of y. Nothing if runs remove drift.
    compensation: S::Unknown,
    kernel: S::Start,
}

/// Returns whether runs remove the drift of what steps keep. The rounding error of the mean then does not matter.
const fn removes_drift<S: DiscreteField<R>, R: Real>() -> bool {
    <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0
}

/// Returns whether an impulse nearly reverses a momentum: the mean falls below p/8, and loses digits.
#[inline(always)]
fn turns<R: Real>(mean: R, p: R) -> bool {
    mean.magnitude() < 0.125 * p.magnitude()
}

impl<S: DiscreteField<R>, R: Real> Equation<'_, TreeStep, S, R> {
    /// Returns the increment d of y that belongs to an impulse dp.
    ///
    /// It is one product of h/2m with 2p + dp, which is rounded as p + dp/2 is. With h p/m + h dp/2m and h = 0.1, the roundings of the two products do not average
    /// out, and the energy of a pendulum drifts by 10⁻¹² in a million steps.
    #[inline(always)]
    fn change(&self, impulse: &S::Unknown) -> S::Unknown {
        if S::DERIVATIVE == 1 {
            return *impulse;
        }
        let p = &self.start.changed;
        self.from.system.drift(&self.constants.parameters, &sum(&sum(p, p), impulse))
    }

    /// Returns the increment of y at which f̄ is evaluated for an impulse.
    #[inline(always)]
    fn evaluated<P: Probe<S, R>>(&self, watch: &mut Watch<'_, S, R, P, ()>, impulse: &S::Unknown) -> S::Unknown {
        let change = self.change(impulse);
        watch.visit(self.from.t, &sum(&self.from.z, &S::increments(&change, impulse)), &());
        // Twice, because f̄ reads the mean y + d/2. The sum of the compensation with itself comes first: if it is nothing, the optimiser removes both sums.
        sum(&change, &sum(&self.start.compensation, &self.start.compensation))
    }

    /// Returns h·f̄ at an increment of y, and writes the matrix of Newton's iteration.
    #[inline(always)]
    fn impulse(&self, d: &S::Unknown, matrix: &mut Square<S::Unknown>) -> S::Unknown {
        let Constants { constants, parameters, .. } = self.constants;
        let mut impulse = S::Unknown::zero();
        self.from.system.equation((constants, self.from.h), parameters, &self.start.kernel, d, &mut impulse, matrix);
        impulse
    }

    /// Returns the increments of (q, p) if h·f̄ is affine in the impulse.
    ///
    /// In a step much longer than an oscillation, an impulse turns p round, and the mean of p has no digits left. The mean p̄ is then solved for itself,
    /// K p̄ = p + ½ h f̄(y, y) with the matrix K of the impulse, and the impulse follows from it. Without this, the energy of an oscillator changes by hω roundings
    /// in each step.
    #[inline(always)]
    fn affine_increments(&self, impulse: &S::Unknown) -> S::Phase {
        let (p, half) = (&self.start.changed, R::from_f64(0.5));
        let mean = moved(p, half, impulse);
        let mut ends = mean.as_slice().iter().zip(p.as_slice());
        if S::DERIVATIVE == 1 || !ends.any(|(mean, p)| turns(*mean, *p)) {
            return S::increments(&self.change(impulse), impulse);
        }
        self.turned(mean, *impulse)
    }

    /// Returns the increments of (q, p), with the mean of each momentum that turns round solved for itself.
    #[cold]
    #[inline(never)]
    fn turned(&self, mut mean: S::Unknown, mut impulse: S::Unknown) -> S::Phase {
        let (p, half) = (&self.start.changed, R::from_f64(0.5));
        let compensation = &self.start.compensation;
        let at_start = self.impulse(&sum(compensation, compensation), &mut S::Unknown::fill(S::Unknown::zero()));
        let solved = self.constants.inverse.times(&moved(p, half, &at_start));
        let entries = mean.as_mut_slice().iter_mut().zip(impulse.as_mut_slice());
        for ((mean, impulse), (solved, p)) in entries.zip(solved.as_slice().iter().zip(p.as_slice())) {
            if turns(*mean, *p) {
                (*mean, *impulse) = (*solved, R::from_f64(2.0) * (*solved - *p));
            }
        }
        S::increments(&self.from.system.drift(&self.constants.parameters, &sum(&mean, &mean)), &impulse)
    }

    /// Returns the rounding errors of the increments of (q, p): the error of the impulse, and for y the error of the mean in [`change`](Self::change).
    ///
    /// Without them, the energy of a pendulum drifts by 4·10⁻²⁰ a step at h = 0.1, and by 10⁻¹⁹ at 0.2. The error of the mean matters only if runs do not remove
    /// drift. In single precision, the error of the impulse matters in all runs.
    #[inline(always)]
    fn lost(&self, Solution { x: impulse, rounding_error, .. }: &Solution<S::Unknown>) -> S::Phase {
        let mut change = S::Unknown::nothing();
        if S::DERIVATIVE == 1 {
            change = *rounding_error;
        } else if const { !removes_drift::<S, R>() } {
            let half = R::from_f64(0.5);
            let (_, mut mean) = S::start(&self.from.compensation);
            mean.add_scaled(half, rounding_error);
            for (i, mean) in mean.as_mut_slice().iter_mut().enumerate() {
                *mean += exact_sum(self.start.changed.as_slice()[i], half * impulse.as_slice()[i]).1;
            }
            self.from.system.add(&self.constants.constants, self.from.h, &mean, &mut change);
        }
        S::increments(&change, rounding_error)
    }
}

impl<S: DiscreteField<R>, R: Real> ImplicitStep<S, R> for TreeStep {
    type Unknown = S::Unknown;
    type Constants = Constants<S, R>;
    type Start = Start<S, R>;
    type History = ();
    type Seen = ();
    type Kept = KeptBy<S, R>;
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy {
        magnitudes: if S::State::MOMENTA { Magnitudes::Recent } else { Magnitudes::Present },
        // With momenta, or with a first integral, all solutions satisfy the balance: friction takes energy away, and with explicit time the energy at frozen time
        // is kept. Otherwise solutions are followed to h = 0.
        branch: if S::State::MOMENTA || removes_drift::<S, R>() { Branch::OfEnergy } else { Branch::Continuous },
        // −2p turns p round, and the mean of p is 0.
        standstill: if S::DERIVATIVE == 1 { 0.0 } else { -2.0 },
        sums: Sums::Compensated,
        evaluated: Evaluated::ByDifferences,
        ..Policy::of(Units { alike: S::State::ALIKE, kinds: S::Phase::LEN / S::State::ALIKE })
    };

    fn constants(self, system: &S, h: R) -> Constants<S, R> {
        let (constants, parameters) = (system.constants(), system.parameters(h));
        let inverse = S::Inverse::new(|| {
            let none = S::Unknown::zero();
            let start = system.begin(&parameters, Span::at(zero()), &none);
            let (mut f, mut matrix) = (none, S::Unknown::fill(none));
            system.equation((&constants, h), &parameters, &start, &none, &mut f, &mut matrix);
            matrix
        });
        Constants { constants, parameters, inverse }
    }

    fn history() {}

    fn unseen() {}

    #[inline(always)]
    fn begin(from: &Departure<'_, S, R>, constants: &Constants<S, R>, (): &mut ()) -> Result<Start<S, R>, Refusal> {
        let (y, changed) = S::start(&from.z);
        let kernel = from.system.begin(&constants.parameters, Span::of([from.t, from.end], from.h), &y);
        let (of_y, _) = S::start(&from.compensation);
        let compensation = if const { removes_drift::<S, R>() } { S::Unknown::nothing() } else { of_y };
        Ok(Start { y, changed, compensation, kernel })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Unknown {
        equation.start.changed
    }

    /// The impulse of the explicit midpoint rule.
    fn guess(Equation { from, constants, start: Start { y, changed, .. } }: &Equation<'_, Self, S, R>) -> S::Unknown {
        let (half, constants) = (R::from_f64(0.5) * from.h, &constants.constants);
        let (mut f, mut unused) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        let mut rate = from.system.velocity(constants, changed);
        if S::DERIVATIVE == 1 {
            from.system.field(constants, from.t, y, &mut rate, &mut unused);
        }
        from.system.field(constants, from.t + half, &moved(y, half, &rate), &mut f, &mut unused);
        scaled(from.h, &f)
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        impulse: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        difference(impulse, &equation.impulse(&equation.evaluated(watch, impulse), matrix))
    }

    /// By `slope` instead of `equation`: the optimiser removes the unused derivative of `slope`, but not the matrix of `equation`.
    #[inline(always)]
    fn image<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        impulse: &S::Unknown,
    ) -> S::Unknown {
        let Equation { from, constants, start } = equation;
        let d = equation.evaluated(watch, impulse);
        let (mut f, mut unused) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        from.system.slope(&constants.parameters, &start.kernel, &d, &mut f, &mut unused);
        scaled(from.h, &f)
    }

    /// If h·f̄ is affine in the impulse, the solution is one product with the inverse of the matrix.
    #[inline(always)]
    fn solve<P: Probe<S, R>>(
        equation: Equation<'_, Self, S, R>,
        newton: &mut Newton<S::Unknown>,
        watch: &mut Watch<'_, S, R, P, ()>,
    ) -> Result<Solution<S::Unknown>, Refusal> {
        if const { !S::Inverse::EXISTS } {
            return newton.solve(&equation, watch);
        }
        let none = S::Unknown::zero();
        let d = equation.evaluated(watch, &none);
        let impulse = equation.constants.inverse.times(&equation.impulse(&d, &mut S::Unknown::fill(none)));
        if impulse.is_finite() { Ok(Solution::of(impulse)) } else { Err(Refusal::Singular) }
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Unknown>,
        (): &(),
    ) -> Result<Increment<S::Phase, ()>, Refusal> {
        if const { S::Inverse::EXISTS } {
            return Ok(Increment::of(equation.affine_increments(&solution.x)));
        }
        let z = S::increments(&equation.change(&solution.x), &solution.x);
        Ok(Increment { z, s: (), lost: equation.lost(solution) })
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Unknown>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        if const { S::Inverse::EXISTS } {
            return Ok(());
        }
        rounded::check_step::<S, R>(P::EFFORT, from, end)
    }
}
