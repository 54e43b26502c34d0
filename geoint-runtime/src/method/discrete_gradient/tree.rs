//! The step along the tree discrete gradient ∇̄H of an energy, or of first integrals of a field: u = h·f̄(y, y + d(u)) for the impulse u.
//!
//! [`DiscreteField`] defines the mean right-hand side f̄, and d is the increment of y. There are three forms:
//!
//! - y = (q, p), f̄ = J∇̄H, and d = u.
//! - If H = T(p) + V(q) with a quadratic T, and nothing is damped, y = q and f̄ = −∇̄V. The impulse u is the increment of the momenta p, and
//!   d = h ∂T/∂p(p + u/2). This form has half of the unknowns.
//! - For a field with first integrals, y are all coordinates, and d = u. f̄ is a mean velocity along which the integrals keep their values.

use super::energy::{Energy, Slope};
use super::mean::MeanGradient;
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::corrected::rounded;
use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, SolvedBy, Sums, Units, Watch,
};
use crate::method::{Claims, Failure, Name, Probe};
use crate::scalar::{Real, exact_sum, zero};
use crate::solving::Inverse;
use crate::solving::equation::{Magnitudes, Solution, Solver};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Snapshot, Square};
use crate::system::{Conservative, DiscreteField, Invariants, KeptBy, Span};

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with J(q, p) = (p, −q) and the tree discrete gradient ∇̄H. Accepted steps keep the energy to rounding, for every h.
///
/// Order 2, symmetric, for every H. In general not symplectic. ∇̄H is reverse-mode differentiation of the expression tree of H, with divided differences in
/// place of derivatives, in forms without cancellation. Conserved functions of degree 1 or 2 in (q, p) are kept as well, if their Poisson brackets with
/// each innermost linear or quadratic form of the tree vanish. Write central forces as functions of `x * x + y * y`, to keep the angular momentum.
///
/// A step solves one equation by Newton's iteration. If H = T(p) + V(q) with a quadratic T, it has half of the unknowns. If H is a quadratic polynomial that
/// does not read time, a product with a constant inverse solves it. With a damping matrix C, J − C replaces J, and the energy changes by −h ∇̄H·C∇̄H, to
/// rounding. In compositions with steps back in time, this balance holds for each substep. For x' = L ∇E + M ∇S the step is h (Q L Q ∇̄E + P M P ∇̄S), where Q
/// and P are projections across ∇̄S and ∇̄E: E is kept, and for h > 0 the entropy S never falls. If H reads time, a step takes H at the time of its middle.
///
/// Vector fields with first integrals keep these in place of H. Lagrangians that are solved for velocities have the step `PolarisedStep`. Systems with
/// constraints of positions or velocities have the step `MultiplierStep`, which keeps them and their rates, too.
///
/// T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020; R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[doc(alias("energy-momentum", "energy conserving", "energy-preserving"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DiscreteGradient;

implicit_method!(
    DiscreteGradient,
    |_| Name::new("DiscreteGradient"),
    Claims::of_order(2).symmetric().conserving_energy()
);
substeps!([] DiscreteGradient where SolvedBy<Self, R>);

/// The tree discrete gradient in all coordinates, for methods that build on it.
impl MeanGradient for DiscreteGradient {
    fn mean_name(&self) -> Name {
        Name::new("DiscreteGradient")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        Ok(energy.tree(x, d))
    }
}

/// The step of [`DiscreteGradient`] along the tree discrete gradient of [`DiscreteField`].
#[derive(Clone, Copy, Debug)]
pub struct TreeStep;

/// Coefficients that depend on the parameters of the system and on h.
#[derive(Clone, Debug)]
pub struct Coefficients<S: DiscreteField<R>, R: Real> {
    /// Coefficients of the field f. They do not depend on h.
    field: S::Constants,
    /// Coefficients of the mean field f̄, and of the drift h ∂T/∂p.
    mean_field: S::Parameters,
    /// The inverse of the matrix K = 1 − ∂(h·f̄)/∂u, if K is the same in all steps.
    inverse: S::Inverse,
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: DiscreteField<R>, R: Real> {
    /// y at the start.
    y: S::Unknown,
    /// The coordinates to which the impulse is added: y, or p.
    origin: S::Unknown,
    /// The compensation of the sums of y. Zero if runs remove the drift of invariants.
    compensation: S::Unknown,
    /// Coefficients of f̄ that depend on y and on the times of the step.
    mean_field: S::Start,
}

/// Returns whether steps keep invariants. Runs then remove the drift of these invariants, so the rounding error of the mean has no lasting effect.
const fn drift_is_removed<S: DiscreteField<R>, R: Real>() -> bool {
    <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0
}

/// Returns whether an impulse nearly reverses a momentum p: the mean momentum is below p/8, so the sum p + u/2 has lost at least three bits.
#[inline(always)]
fn nearly_reverses<R: Real>(mean: R, p: R) -> bool {
    mean.magnitude() < 0.125 * p.magnitude()
}

impl<S: DiscreteField<R>, R: Real> Equation<'_, TreeStep, S, R> {
    /// Returns the increment d of y that follows from an impulse u.
    ///
    /// If T is quadratic, it is one product of h/2m with 2p + u, which has the rounding of p + u/2; m is the mass. The roundings of two products,
    /// h p/m + h u/2m, would not average out. At h = 0.1 the energy of a pendulum would drift by 10⁻¹² in a million steps.
    #[inline(always)]
    fn increment(&self, impulse: &S::Unknown) -> S::Unknown {
        if S::EQUATION_ORDER.is_first() {
            return *impulse;
        }
        let p = &self.start.origin;
        self.from.system.drift(&self.coefficients.mean_field, &sum(&sum(p, p), impulse))
    }

    /// Returns the increment of y at which f̄ must be evaluated for an impulse: d plus twice the compensation. Shows the end of the step to `watch`.
    #[inline(always)]
    fn compensated_increment<P: Probe<S, R>>(
        &self,
        watch: &mut Watch<'_, S, R, P, ()>,
        impulse: &S::Unknown,
    ) -> S::Unknown {
        let d = self.increment(impulse);
        watch.visit(self.from.end, &sum(&self.from.z, &S::increments(&d, impulse)), &());
        // The exact mean of both ends is y + compensation + d/2, hence the factor 2. The compensation is doubled by a sum first: the optimiser then removes
        // both sums if the compensation is absent.
        sum(&d, &sum(&self.start.compensation, &self.start.compensation))
    }

    /// Returns the impulse h·f̄(y, y + d), and writes the matrix K = 1 − ∂(h·f̄)/∂u of Newton's iteration.
    #[inline(always)]
    fn impulse(&self, d: &S::Unknown, matrix: &mut Square<S::Unknown>) -> S::Unknown {
        let Coefficients { field, mean_field, .. } = self.coefficients;
        let mut impulse = S::Unknown::zero();
        self.from.system.equation((field, self.from.h), mean_field, &self.start.mean_field, d, &mut impulse, matrix);
        impulse
    }

    /// Returns the increments of (q, p) for an impulse. Precondition: h·f̄ is affine in the impulse.
    ///
    /// In a step much longer than an oscillation, the impulse nearly reverses p, and the mean momentum p̄ = p + u/2 has lost digits. The mean is then
    /// computed by its own equation, K p̄ = p + ½ h f̄(y, y), and the impulse follows from it. Otherwise the energy of an oscillator of frequency ω would
    /// change by hω roundings in each step.
    #[inline(always)]
    fn affine_increments(&self, impulse: &S::Unknown) -> S::Phase {
        let (p, half) = (&self.start.origin, R::from_f64(0.5));
        let mean = moved(p, half, impulse);
        let mut momenta = mean.as_slice().iter().zip(p.as_slice());
        if S::EQUATION_ORDER.is_first() || !momenta.any(|(mean, p)| nearly_reverses(*mean, *p)) {
            return S::increments(&self.increment(impulse), impulse);
        }
        self.increments_of_solved_means(mean, *impulse)
    }

    /// Returns the increments of (q, p). The mean of each momentum that is nearly reversed is computed by its own equation.
    #[cold]
    #[inline(never)]
    fn increments_of_solved_means(&self, mut mean: S::Unknown, mut impulse: S::Unknown) -> S::Phase {
        let (p, half) = (&self.start.origin, R::from_f64(0.5));
        let compensation = &self.start.compensation;
        let at_start = self.impulse(&sum(compensation, compensation), &mut S::Unknown::fill(S::Unknown::zero()));
        let solved = self.coefficients.inverse.times(&moved(p, half, &at_start));
        let entries = mean.as_mut_slice().iter_mut().zip(impulse.as_mut_slice());
        for ((mean, impulse), (solved, p)) in entries.zip(solved.as_slice().iter().zip(p.as_slice())) {
            if nearly_reverses(*mean, *p) {
                (*mean, *impulse) = (*solved, R::from_f64(2.0) * (*solved - *p));
            }
        }
        S::increments(&self.from.system.drift(&self.coefficients.mean_field, &sum(&mean, &mean)), &impulse)
    }

    /// Returns the rounding errors of the increments of (q, p): for p the error of the impulse, for q the error that the mean momentum causes in
    /// [`increment`](Self::increment). If y = (q, p), both are the error of the impulse.
    ///
    /// Without them, the energy of a pendulum drifts by 4·10⁻²⁰ a step at h = 0.1, and by 10⁻¹⁹ at h = 0.2. The error of the mean is omitted if runs remove
    /// drift. The error of the impulse is not, because single precision needs it in all runs.
    #[inline(always)]
    fn rounding_errors(&self, Solution { x: impulse, rounding_error, .. }: &Solution<S::Unknown>) -> S::Phase {
        let mut error = S::Unknown::nothing();
        if S::EQUATION_ORDER.is_first() {
            error = *rounding_error;
        } else if const { !drift_is_removed::<S, R>() } {
            let half = R::from_f64(0.5);
            let (_, mut mean) = S::start(&self.from.compensation);
            mean.add_scaled(half, rounding_error);
            for (i, mean) in mean.as_mut_slice().iter_mut().enumerate() {
                *mean += exact_sum(self.start.origin.as_slice()[i], half * impulse.as_slice()[i]).1;
            }
            self.from.system.add(&self.coefficients.field, self.from.h, &mean, &mut error);
        }
        S::increments(&error, rounding_error)
    }
}

impl<S: DiscreteField<R>, R: Real> ImplicitStep<S, R> for TreeStep {
    type Unknown = S::Unknown;
    type Coefficients = Coefficients<S, R>;
    type Start = Start<S, R>;
    type History = ();
    type LastEvaluation = ();
    type Kept = KeptBy<S, R>;
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy {
        magnitudes: if S::State::MOMENTA { Magnitudes::Recent } else { Magnitudes::Present },
        // With momenta, or with a first integral, all solutions satisfy the balance of the energy or of the integral. The balance includes friction. If H
        // reads time, it holds for H at the time of the middle. Without momenta and integrals, solutions are followed to h = 0.
        branch: if S::State::MOMENTA || drift_is_removed::<S, R>() { Branch::OfEnergy } else { Branch::Continuous },
        // The impulse −2p reverses p, so the mean of p is 0, and q does not move.
        standstill: if S::EQUATION_ORDER.is_first() { 0.0 } else { -2.0 },
        sums: Sums::Compensated,
        evaluated: Evaluated::ByDifferences,
        ..Policy::of(Units { alike: S::State::ALIKE, kinds: S::Phase::LEN / S::State::ALIKE })
    };

    fn coefficients(self, system: &S, h: R) -> Coefficients<S, R> {
        let (field, mean_field) = (system.constants(), system.parameters(h));
        // If K is the same in all steps, it may be evaluated at any point, here at zero.
        let inverse = S::Inverse::new(|| {
            let none = S::Unknown::zero();
            let start = system.begin(&mean_field, Span::at(zero()), &none);
            let (mut f, mut matrix) = (none, S::Unknown::fill(none));
            system.equation((&field, h), &mean_field, &start, &none, &mut f, &mut matrix);
            matrix
        });
        Coefficients { field, mean_field, inverse }
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(
        from: &Departure<'_, S, R>,
        coefficients: &Coefficients<S, R>,
        (): &mut (),
    ) -> Result<Start<S, R>, Failure> {
        let (y, origin) = S::start(&from.z);
        let mean_field = from.system.begin(&coefficients.mean_field, Span::of([from.t, from.end], from.h), &y);
        let (of_y, _) = S::start(&from.compensation);
        let compensation = if const { drift_is_removed::<S, R>() } { S::Unknown::nothing() } else { of_y };
        Ok(Start { y, origin, compensation, mean_field })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Unknown {
        equation.start.origin
    }

    /// Returns the impulse of the explicit midpoint rule.
    fn guess(Equation { from, coefficients, start: Start { y, origin, .. } }: &Equation<'_, Self, S, R>) -> S::Unknown {
        let (half, field) = (R::from_f64(0.5) * from.h, &coefficients.field);
        let (mut f, mut unused) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        let mut rate = from.system.velocity(field, origin);
        if S::EQUATION_ORDER.is_first() {
            from.system.field(field, from.t, y, &mut rate, &mut unused);
        }
        from.system.field(field, from.t + half, &moved(y, half, &rate), &mut f, &mut unused);
        scaled(from.h, &f)
    }

    /// Returns u − h·f̄, and writes its derivative K.
    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        impulse: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        difference(impulse, &equation.impulse(&equation.compensated_increment(watch, impulse), matrix))
    }

    /// Returns h·f̄. It calls `slope` instead of `equation`, because the optimiser removes the unused derivative of `slope`, but not the matrix of `equation`.
    #[inline(always)]
    fn image<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        impulse: &S::Unknown,
    ) -> S::Unknown {
        let Equation { from, coefficients, start } = equation;
        let d = equation.compensated_increment(watch, impulse);
        let (mut f, mut unused) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        from.system.slope(&coefficients.mean_field, &start.mean_field, &d, &mut f, &mut unused);
        scaled(from.h, &f)
    }

    /// Returns the solution. If h·f̄ is affine in the impulse, it is the product of K⁻¹ with h·f̄ for the impulse 0.
    #[inline(always)]
    fn solve<P: Probe<S, R>>(
        equation: Equation<'_, Self, S, R>,
        newton: &mut Newton<S::Unknown>,
        watch: &mut Watch<'_, S, R, P, ()>,
    ) -> Result<Solution<S::Unknown>, Failure> {
        if const { !S::Inverse::EXISTS } {
            return newton.solve(&equation, watch);
        }
        let none = S::Unknown::zero();
        let d = equation.compensated_increment(watch, &none);
        let impulse = equation.coefficients.inverse.times(&equation.impulse(&d, &mut S::Unknown::fill(none)));
        if impulse.is_finite() { Ok(Solution::of(impulse)) } else { Err(Failure::Singular) }
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Unknown>,
        (): &(),
    ) -> Result<Increment<S::Phase, ()>, Failure> {
        if const { S::Inverse::EXISTS } {
            return Ok(Increment::of(equation.affine_increments(&solution.x), ()));
        }
        let z = S::increments(&equation.increment(&solution.x), &solution.x);
        Ok(Increment { z, s: (), rounding_error: equation.rounding_errors(solution) })
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Unknown>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Failure> {
        // The solution is direct. No iteration has accepted a residual, so there is nothing to check.
        if const { S::Inverse::EXISTS } {
            return Ok(());
        }
        rounded::check_step::<S, R>(P::EFFORT, from, end)
    }
}
