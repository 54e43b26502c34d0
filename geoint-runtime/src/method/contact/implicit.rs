//! Step of a contact system, solved for the increments of q, p and s together: d = Φ(d), with Φ of [`ContactEquation`].

use super::{ContactDiscreteGradient, ContactMidpoint};
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::implicit::{Departure, Equation, ImplicitStep, Increment, Policy, Units, Watch};
use crate::method::{Claims, Name, Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved};
use crate::space::{Array, PerCoordinate, Square};
use crate::system::ContactEquation;

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

/// A method whose equation evaluates the energy at x + w·d.
pub trait EvaluatesAhead: Copy + core::fmt::Debug {
    /// w.
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
    /// q, p and s in a row.
    x: A,
    kernel: K,
}

impl<S: ContactEquation<M, R>, M: EvaluatesAhead, R: Real> ImplicitStep<S, R> for ContactStep<M> {
    type Unknown = S::Unknown;
    type Constants = S::Constants;
    type Start = Start<S::Start, S::Unknown>;
    type History = ();
    type Seen = ();
    type Kept = ();
    type Solver = Newton<S::Unknown>;

    const POLICY: Policy = Policy::of(Units { alike: S::Array::LEN, kinds: 3 });

    fn constants(self, system: &S, h: R) -> S::Constants {
        system.constants(h)
    }

    fn history() {}

    fn unseen() {}

    #[inline(always)]
    fn begin(from: &Departure<'_, S, R>, constants: &S::Constants, (): &mut ()) -> Result<Self::Start, Refusal> {
        let mut x = S::Unknown::zero();
        let (entries, n) = (x.as_mut_slice(), S::Phase::LEN);
        entries[..n].copy_from_slice(Array::as_slice(&from.z));
        entries[n] = from.s;
        Ok(Start { x, kernel: from.system.begin(constants, from.middle(), &x) })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, S, R>) -> S::Unknown {
        equation.start.x
    }

    /// Returns Φ(Φ(0)), which is the explicit midpoint rule, or as good.
    fn guess(Equation { from, constants, start }: &Equation<'_, Self, S, R>) -> S::Unknown {
        let mut unused = S::Unknown::fill(S::Unknown::zero());
        let mut image = |d: &S::Unknown| {
            let mut image = S::Unknown::zero();
            from.system.image(constants, &start.kernel, d, &mut image, &mut unused);
            image
        };
        let once = image(&S::Unknown::zero());
        image(&once)
    }

    #[inline(always)]
    fn residual<P: Probe<S, R>>(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, ()>,
        d: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let PerCoordinate { z, s } = apart::<S, M, R>(&moved(&start.x, R::from_f64(M::AHEAD), d));
        watch.visit(from.middle(), &z, &s);
        let mut image = S::Unknown::zero();
        from.system.image(constants, &start.kernel, d, &mut image, matrix);
        difference(d, &image)
    }

    #[inline(always)]
    fn update(
        Equation { from, constants, start }: &Equation<'_, Self, S, R>,
        solution: &Solution<S::Unknown>,
        (): &(),
    ) -> Result<Increment<S::Phase, R>, Refusal> {
        let increments = from.system.end(constants, &start.kernel, &solution.x);
        if !increments.is_finite() {
            return Err(Refusal::Singular);
        }
        let PerCoordinate { z, s } = apart::<S, M, R>(&increments);
        Ok(Increment { z, s, lost: S::Phase::zero() })
    }
}

/// Splits a row into positions, momenta and the action.
#[inline(always)]
fn apart<S: ContactEquation<M, R>, M, R: Real>(x: &S::Unknown) -> PerCoordinate<S::Phase, R> {
    let mut z = S::Phase::zero();
    Array::as_mut_slice(&mut z).copy_from_slice(&x.as_slice()[..S::Phase::LEN]);
    PerCoordinate { z, s: x.as_slice().last().copied().unwrap_or_else(zero) }
}
