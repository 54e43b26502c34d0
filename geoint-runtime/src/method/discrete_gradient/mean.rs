//! Steps along a mean g of ∇H between their ends: d = h J g(x₀, x₀ + d) for the increment d = x₁ − x₀. Here x = (q, p) and J(q, p) = (p, −q).
//!
//! [`MeanGradient`] defines g. [`MeanStep`] solves the equation for all coordinates (q, p), even if H = T(p) + V(q) with a quadratic T. There the step of
//! [`DiscreteGradient`](super::DiscreteGradient) has half of the unknowns; see `TreeStep`.

use super::energy::{Energy, Slope};
use super::matrix::j_times;
use crate::method::composition::SymmetricMap;
use crate::method::corrected::range::is_representable;
use crate::method::corrected::{kept, rounded};
use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Claims, Failure, Name, Probe, Unwatched};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::quasi_newton::QuasiNewton;
use crate::space::vector::{entries, moved, scaled, sum};
use crate::space::{Array, Square};
use crate::system::{Conservative, DiscreteField, KeptBy};

/// A mean g of ∇H between x and x + d. The step is x₁ = x₀ + h J g(x₀, x₁).
///
/// A discrete gradient satisfies g·d = H(x + d) − H(x). The step then keeps the energy, because g·d = h g·Jg = 0. Time is frozen in the middle of the step.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a step along a mean of gradients",
    note = "means of order 2: `DiscreteGradient`, `Gonzalez`, `MeanValue`, `SymmetrisedItohAbe`"
)]
pub trait MeanGradient: Copy + core::fmt::Debug {
    /// True if ∂g/∂d is symmetric. [`FourthOrder`](crate::FourthOrder) then omits its term with the matrix Q, which is zero.
    const CURL_FREE: bool = false;

    /// True if g contains products with energies, as in the metric of [`Gonzalez`](super::Gonzalez). A run is then refused if an energy underflows or
    /// overflows.
    const OF_ENERGIES: bool = false;

    /// Returns the name of the method.
    fn mean_name(&self) -> Name;

    /// Returns whether g is proven to be a discrete gradient of the system. Steps then keep the energy.
    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        true
    }

    /// Returns whether steps are a symplectic map.
    fn is_symplectic<S: DiscreteField<R>, R: Real>() -> bool {
        false
    }

    /// Returns g between x and x + d, and ∂g/∂d. The solver accepts an approximate derivative. [`FourthOrder`](crate::FourthOrder) does not: unless
    /// [`CURL_FREE`](Self::CURL_FREE), its order 4 needs the exact skew part of ∂g/∂x₁ − ∂g/∂x₀.
    ///
    /// # Errors
    /// If g does not exist between these points.
    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure>;
}

/// A mean of order 2, symmetric in both ends, that [`FourthOrder`](crate::FourthOrder) raises to order 4 by a modified structure matrix. The tree discrete
/// gradient is not among them: for it, `FourthOrder` projects a mean velocity.
pub(crate) trait FourthOrderBase: MeanGradient + SymmetricMap {}

/// The step along the mean `G`. The derivative of g may be approximate, so the solver is [`QuasiNewton`], with linear convergence.
#[derive(Clone, Copy, Debug)]
pub struct MeanStep<G>(
    /// The mean.
    pub G,
);

/// The mean gradient, and coefficients that depend on the parameters of the system and on h.
#[derive(Clone, Debug)]
pub struct Coefficients<G, S: DiscreteField<R>, R: Real> {
    mean: G,
    /// Coefficients of the field f = J∇H, or of the force if T is quadratic.
    field: S::Constants,
    /// Coefficients of the tree discrete gradient.
    mean_field: S::Parameters,
}

impl<'a, G: MeanGradient, S: DiscreteField<R> + Conservative<R>, R: Real> Equation<'a, MeanStep<G>, S, R> {
    /// Returns the evaluator of the gradients of H for this step. It shows the points of evaluations to `probe`.
    #[inline(always)]
    fn energy<'b, P>(&self, probe: &'b mut P) -> Energy<'b, S, R, P>
    where
        'a: 'b,
    {
        let Coefficients { field, mean_field, .. } = self.coefficients;
        Energy {
            system: self.from.system,
            field_coefficients: field,
            mean_field_coefficients: mean_field,
            probe,
            t: self.from.middle(),
            h: self.from.h,
        }
    }
}

impl<G: MeanGradient, S: DiscreteField<R> + Conservative<R>, R: Real> ImplicitStep<S, R> for MeanStep<G> {
    type Unknown = S::Phase;
    type Coefficients = Coefficients<G, S, R>;
    type Start = ();
    type History = ();
    /// The refusal of the mean, if g did not exist at a point of the iteration. It replaces the refusal of the solver.
    type LastEvaluation = Option<Failure>;
    type Kept = KeptBy<S, R>;
    type Solver = QuasiNewton<S::Phase>;

    const POLICY: Policy = Policy {
        // All solutions of a discrete gradient keep the energy. This constant cannot ask `is_exact`, so it holds for inexact means, too.
        branch: Branch::OfEnergy,
        sums: Sums::Compensated,
        evaluated: Evaluated::AtTheEnd,
        ..Policy::of(Units { alike: S::Array::LEN, kinds: 2 })
    };

    fn coefficients(self, system: &S, h: R) -> Coefficients<G, S, R> {
        Coefficients { mean: self.0, field: system.constants(), mean_field: system.parameters(h) }
    }

    fn claims(claims: Claims) -> Claims {
        Claims { symplectic: G::is_symplectic::<S, R>(), conserves_energy: G::is_exact::<S, R>(), ..claims }
    }

    fn history() {}

    fn no_evaluation() -> Option<Failure> {
        None
    }

    #[inline(always)]
    fn begin(_: &Departure<'_, S, R>, _: &Self::Coefficients, (): &mut ()) -> Result<(), Failure> {
        Ok(())
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Phase {
        equation.from.z
    }

    /// Returns the increment of the explicit midpoint rule.
    fn guess(equation: &Equation<'_, Self, S, R>) -> S::Phase {
        let (mut unwatched, Departure { t, h, z, .. }) = (Unwatched, equation.from);
        let (mut energy, half) = (equation.energy(&mut unwatched), R::from_f64(0.5) * h);
        let rate = j_times(&energy.gradient(t, &z).g);
        let rate = j_times(&energy.gradient(t + half, &moved(&z, half, &rate)).g);
        scaled(h, &rate)
    }

    /// Returns d − h J g, and writes 1 − h J ∂g/∂d. Returns NaN if g does not exist, so that the solver refuses the step.
    #[inline]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::LastEvaluation>,
        d: &S::Phase,
        matrix: &mut Square<S::Phase>,
    ) -> S::Phase {
        let (n, Departure { h, z, .. }) = (S::Array::LEN, equation.from);
        watch.record_end(&sum(&z, d), &());
        let slope = match equation.coefficients.mean.between(&mut equation.energy(watch.probe()), &z, d) {
            Ok(slope) => slope,
            Err(refusal) => {
                watch.last = Some(refusal);
                return scaled(R::from_f64(f64::NAN), d);
            }
        };
        let Slope { g, mut derivative } = slope;
        let (derivative, rows) = (derivative.rows(), <S::Phase>::entries::<S::Phase>(matrix));
        for i in 0..n {
            rows[i] = scaled(-h, &derivative[n + i]);
            rows[n + i] = scaled(h, &derivative[i]);
        }
        for (i, row) in rows.iter_mut().enumerate() {
            entries(row)[i] += R::from_f64(1.0);
        }
        moved(d, -h, &j_times(&g))
    }

    #[inline(always)]
    fn update(
        _: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Phase>,
        _: &Self::LastEvaluation,
    ) -> Result<Increment<S::Phase, ()>, Failure> {
        Ok(Increment::of(solution.x, ()))
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Phase>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Failure> {
        if !G::is_exact::<S, R>() {
            return Ok(());
        }
        rounded::check_step::<S, R>(P::EFFORT, from, end)
    }

    #[cold]
    fn explained(_: &Equation<'_, Self, S, R>, last: &Self::LastEvaluation, refusal: Failure) -> Failure {
        last.unwrap_or(refusal)
    }

    fn is_in_range(system: &S, z: &S::Phase) -> bool {
        !G::OF_ENERGIES || is_representable(system, &KeptBy::<S, R>::default(), z)
    }

    /// Returns zero for a mean that is not a discrete gradient of the system, because its steps keep no invariant.
    fn way_back(system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        if G::is_exact::<S, R>() { kept::way_back(system, &Self::Kept::default(), origin, z) } else { S::Phase::zero() }
    }
}
