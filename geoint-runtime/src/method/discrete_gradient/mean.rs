//! Steps along a mean g of ∇H between their ends: d = h J g(x₀, x₀ + d) for the increment d.

use super::energy::{Energy, Slope};
use super::matrix::turned;
use crate::method::composition::SymmetricMap;
use crate::method::corrected::range::is_representable;
use crate::method::corrected::{kept, rounded};
use crate::method::implicit::{
    Arrival, Branch, Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Sums, Units, Watch,
};
use crate::method::{Claims, Name, Probe, Refusal, Unwatched};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::quasi_newton::QuasiNewton;
use crate::space::vector::{entries, moved, scaled, sum};
use crate::space::{Array, Square};
use crate::system::{Conservative, DiscreteField, KeptBy};

/// A mean g of ∇H between x and x + d: the step is x₁ = x₀ + h J g(x₀, x₁).
///
/// A discrete gradient has g·d = H(x + d) − H(x), and then the energy is kept: d·g = h Jg·g = 0.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a step along a mean of gradients",
    note = "means of order 2: `DiscreteGradient`, `Gonzalez`, `MeanValue`, `SymmetrisedItohAbe`"
)]
pub trait MeanGradient: Copy + core::fmt::Debug {
    /// Whether ∂g/∂d is symmetric.
    const CURL_FREE: bool = false;

    /// True if g is computed from differences of H, which must be representable.
    const OF_ENERGIES: bool = false;

    /// The name of the method.
    fn mean_name(&self) -> Name;

    /// Returns whether g is a discrete gradient of the system. Steps then keep the energy.
    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        true
    }

    /// Whether steps are a symplectic map.
    fn is_symplectic<S: DiscreteField<R>, R: Real>() -> bool {
        false
    }

    /// Returns g and ∂g/∂d. An approximate derivative is enough for convergence. [`FourthOrder`](crate::FourthOrder) needs the exact one, because its order follows from
    /// it.
    ///
    /// # Errors
    /// If g does not exist.
    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Refusal>;
}

/// A symmetric mean that [`FourthOrder`](crate::FourthOrder) raises to order 4 by a modified structure matrix. (For the tree discrete gradient, it projects a mean
/// velocity instead.)
pub trait Corrected: MeanGradient + SymmetricMap {}

/// The step along the mean `G`. The derivative of g is known approximately, so corrections shrink by a factor.
#[derive(Clone, Copy, Debug)]
pub struct MeanStep<G>(
    /// The mean.
    pub G,
);

/// Values that depend on the mean, on parameters, and on h.
#[derive(Clone, Debug)]
pub struct Constants<G, S: DiscreteField<R>, R: Real> {
    mean: G,
    constants: S::Constants,
    parameters: S::Parameters,
}

impl<'a, G: MeanGradient, S: DiscreteField<R> + Conservative<R>, R: Real> Equation<'a, MeanStep<G>, S, R> {
    /// Returns the energy, at the time in the middle of the step unless stated otherwise.
    #[inline(always)]
    fn energy<'b, P>(&self, probe: &'b mut P) -> Energy<'b, S, R, P>
    where
        'a: 'b,
    {
        let Constants { constants, parameters, .. } = self.constants;
        Energy { system: self.from.system, constants, parameters, probe, t: self.from.middle(), h: self.from.h }
    }
}

impl<G: MeanGradient, S: DiscreteField<R> + Conservative<R>, R: Real> ImplicitStep<S, R> for MeanStep<G> {
    type Unknown = S::Phase;
    type Constants = Constants<G, S, R>;
    type Start = ();
    type History = ();
    /// The reason if g did not exist at a point. It explains an equation without a solution.
    type Seen = Option<Refusal>;
    type Kept = KeptBy<S, R>;
    type Solver = QuasiNewton<S::Phase>;

    const POLICY: Policy = Policy {
        // Discrete gradients keep the energy. Other means are symmetric, and their solutions are not examined either.
        branch: Branch::OfEnergy,
        sums: Sums::Compensated,
        evaluated: Evaluated::AtTheEnd,
        ..Policy::of(Units { alike: S::Array::LEN, kinds: 2 })
    };

    fn constants(self, system: &S, h: R) -> Constants<G, S, R> {
        Constants { mean: self.0, constants: system.constants(), parameters: system.parameters(h) }
    }

    fn claims(claims: Claims) -> Claims {
        Claims { symplectic: G::is_symplectic::<S, R>(), conserves_energy: G::is_exact::<S, R>(), ..claims }
    }

    fn history() {}

    fn unseen() -> Option<Refusal> {
        None
    }

    #[inline(always)]
    fn begin(_: &Departure<'_, S, R>, _: &Self::Constants, (): &mut ()) -> Result<(), Refusal> {
        Ok(())
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Phase {
        equation.from.z
    }

    /// The explicit midpoint rule.
    fn guess(equation: &Equation<'_, Self, S, R>) -> S::Phase {
        let (mut unwatched, Departure { t, h, z, .. }) = (Unwatched, equation.from);
        let (mut energy, half) = (equation.energy(&mut unwatched), R::from_f64(0.5) * h);
        let rate = turned(&energy.gradient(t, &z).g);
        let rate = turned(&energy.gradient(t + half, &moved(&z, half, &rate)).g);
        scaled(h, &rate)
    }

    /// d − h J g and 1 − h J ∂g/∂d.
    #[inline]
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
        d: &S::Phase,
        matrix: &mut Square<S::Phase>,
    ) -> S::Phase {
        let (n, Departure { h, z, .. }) = (S::Array::LEN, equation.from);
        watch.decide(&sum(&z, d), &());
        let slope = match equation.constants.mean.between(&mut equation.energy(watch.probe()), &z, d) {
            Ok(slope) => slope,
            Err(refusal) => {
                watch.seen = Some(refusal);
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
        moved(d, -h, &turned(&g))
    }

    #[inline(always)]
    fn update(
        _: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Phase>,
        _: &Self::Seen,
    ) -> Result<Increment<S::Phase, ()>, Refusal> {
        Ok(Increment::of(solution.x))
    }

    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        Equation { from, .. }: &Equation<'_, Self, S, R>,
        _: &Solution<S::Phase>,
        (): &mut (),
        end: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        if !G::is_exact::<S, R>() {
            return Ok(());
        }
        rounded::check_step::<S, R>(P::EFFORT, from, end)
    }

    #[cold]
    fn explained(_: &Equation<'_, Self, S, R>, seen: &Self::Seen, refusal: Refusal) -> Refusal {
        seen.unwrap_or(refusal)
    }

    fn is_in_range(system: &S, z: &S::Phase) -> bool {
        !G::OF_ENERGIES || is_representable(system, &KeptBy::<S, R>::default(), z)
    }

    /// A mean that is no discrete gradient of the system keeps nothing.
    fn way_back(system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        if G::is_exact::<S, R>() { kept::way_back(system, &Self::Kept::default(), origin, z) } else { S::Phase::zero() }
    }
}
