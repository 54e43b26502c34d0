//! The step of `ContactMidpoint` and `ContactDiscreteGradient`. It solves d = Φ(d) for a row d with entries for q, p and s.
//!
//! The attribute macros implement [`ContactEquation`] for a system and each method: Φ, and a function `end` that returns the increments of q, p and s for a
//! solution. For the discrete gradient, d is these increments. For the midpoint rule, x₀ + d/2 is the point (q̄, p̄, s̄) of its documentation. The increment
//! of p is then the entry of d for p, divided by 1 + hσ/2 with σ = ∂H/∂s at this point.
//!
//! The result of `end` is not finite if the step has no end, as for |hσ| ≥ 2. The step is then refused.

use super::{ContactDiscreteGradient, ContactMidpoint};
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::implicit::{Departure, Equation, Evaluated, ImplicitStep, Increment, Policy, Units, Watch};
use crate::method::{Claims, Failure, Name, Probe};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, resized};
use crate::space::{Array, PerCoordinate, Square};
use crate::system::ContactEquation;

// `symplectic` claims a contact map, and `conserving_energy` claims the decay law of H. See `Claims`.
implicit_method!(ContactMidpoint, |_| Name::new("ContactMidpoint"), Claims::of_order(2).symmetric().symplectic());
implicit_method!(
    ContactDiscreteGradient,
    |_| Name::new("ContactDiscreteGradient"),
    Claims::of_order(2).symmetric().conserving_energy()
);
substeps!([] ContactMidpoint; [] ContactDiscreteGradient);

/// The step of the method `M`.
#[derive(Clone, Copy, Debug)]
pub struct ContactStep<M>(
    /// The method.
    pub M,
);

/// A method whose equation evaluates the energy at x₀ + w·d, and possibly also at x₀, the start (q, p, s) of the step. x₀ + w·d is shown to the probe.
pub(crate) trait EvaluatesAhead: Copy + core::fmt::Debug {
    /// w: 1/2 for the midpoint, 1 for the end of the step.
    const AHEAD: f64;
}

impl EvaluatesAhead for ContactMidpoint {
    const AHEAD: f64 = 0.5;
}

impl EvaluatesAhead for ContactDiscreteGradient {
    const AHEAD: f64 = 1.0;
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<K, A> {
    /// x₀: q, p and s in a row.
    x: A,
    /// Coefficients of Φ.
    kernel: K,
}

impl<S: ContactEquation<M, R>, M: EvaluatesAhead, R: Real> ImplicitStep<S, R> for ContactStep<M> {
    type Unknown = S::Unknown;
    type Coefficients = S::Constants;
    type Start = Start<S::Start, S::Unknown>;
    type History = ();
    type LastEvaluation = ();
    type Kept = ();
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy {
        // Not `ByDifferences`, although the discrete gradient contains divided differences. The check of points is stronger: it also tests the poles at which
        // divided differences are taken to be infinite or NaN, and the domain at the end.
        evaluated: if M::AHEAD == 1.0 { Evaluated::AtTheEnd } else { Evaluated::Elsewhere },
        ..Policy::of(Units { alike: S::Array::LEN, kinds: 3 })
    };

    fn coefficients(self, system: &S, h: R) -> S::Constants {
        system.constants(h)
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(from: &Departure<'_, S, R>, coefficients: &S::Constants, (): &mut ()) -> Result<Self::Start, Failure> {
        let x = resized(&from.z, from.s);
        Ok(Start { x, kernel: from.system.begin(coefficients, from.middle(), &x) })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Unknown {
        equation.start.x
    }

    /// Returns Φ(Φ(0)). The error of 0 is of order h. Each application of Φ gains one order, so the error is of order h³.
    fn guess(Equation { from, coefficients, start }: &Equation<'_, Self, S, R>) -> S::Unknown {
        let mut unused = S::Unknown::fill(S::Unknown::zero());
        let mut image = |d: &S::Unknown| {
            let mut image = S::Unknown::zero();
            from.system.image(coefficients, &start.kernel, d, &mut image, &mut unused);
            image
        };
        let once = image(&S::Unknown::zero());
        image(&once)
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        Equation { from, coefficients, start }: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        d: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let PerCoordinate { z, s } = apart::<S, M, R>(&moved(&start.x, R::from_f64(M::AHEAD), d));
        watch.visit(from.middle(), &z, &s);
        let mut image = S::Unknown::zero();
        from.system.image(coefficients, &start.kernel, d, &mut image, matrix);
        difference(d, &image)
    }

    #[inline(always)]
    fn update(
        Equation { from, coefficients, start }: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Unknown>,
        (): &(),
    ) -> Result<Increment<S::Phase, R>, Failure> {
        let increments = from.system.end(coefficients, &start.kernel, &solution.x);
        if !increments.is_finite() {
            return Err(Failure::Singular);
        }
        let PerCoordinate { z, s } = apart::<S, M, R>(&increments);
        Ok(Increment::of(z, s))
    }
}

/// Splits a row into z = (q, p) and s.
#[inline(always)]
fn apart<S: ContactEquation<M, R>, M, R: Real>(x: &S::Unknown) -> PerCoordinate<S::Phase, R> {
    PerCoordinate { z: resized(x, zero()), s: x.as_slice().last().copied().unwrap_or_else(zero) }
}
