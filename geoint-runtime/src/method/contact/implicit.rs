//! Implicit steps of contact systems: one equation for the increments of q, p and s together.

use super::{ContactDiscreteGradient, ContactMidpoint};
use crate::method::composition::substeps;
use crate::method::{Claims, Method, Name, Probe, Refusal, Step, StepsOf, check_end, start};
use crate::scalar::{Real, zero};
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved};
use crate::space::{Array, PerCoordinate, Square, Summation};
use crate::system::{ByField, ByTree, ContactCollocated, ContactGraded, ImplicitStep, Poles};

/// What a step needs.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    constants: P,
    half: R,
    poles: Poles,
}

/// What a step of `M` needs.
type PreparedFor<S, M, R> = Prepared<<S as ImplicitStep<M, R>>::Constants, R>;

/// d = Φ(d), where the energy is evaluated at x + `ahead`·d.
struct Equation<'a, S: ImplicitStep<M, R>, M, R: Real> {
    system: &'a S,
    constants: &'a S::Constants,
    begun: S::Start,
    /// The time of the middle of the step.
    middle: R,
    origin: S::Unknown,
    ahead: f64,
}

impl<S: ImplicitStep<M, R>, M, R: Real> Clone for Equation<'_, S, M, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: ImplicitStep<M, R>, M, R: Real> Copy for Equation<'_, S, M, R> {}

impl<S: ImplicitStep<M, R>, M, R: Real, P: Probe<S, R>> StepEquation<S::Unknown, P> for Equation<'_, S, M, R> {
    const EFFORT: Effort = P::EFFORT;

    #[inline(always)]
    fn origin(&self) -> S::Unknown {
        self.origin
    }

    /// Φ(Φ(0)) is the explicit midpoint rule, or as good.
    fn guess(&self) -> S::Unknown {
        let Equation { system, constants, begun, .. } = self;
        let none = S::Unknown::zero();
        let [mut once, mut twice] = [none; 2];
        let mut unused = S::Unknown::fill(none);
        system.image(constants, begun, &none, &mut once, &mut unused);
        system.image(constants, begun, &once, &mut twice, &mut unused);
        twice
    }

    #[inline(always)]
    fn residual(&self, probe: &mut P, d: &S::Unknown, matrix: &mut Square<S::Unknown>) -> S::Unknown {
        let Equation { system, constants, begun, middle, origin, ahead } = self;
        let PerCoordinate { z, s } = apart::<S, M, R>(&moved(origin, R::from_f64(*ahead), d));
        probe.visit(*middle, &z, &s);
        let mut image = S::Unknown::zero();
        system.image(constants, begun, d, &mut image, matrix);
        difference(d, &image)
    }
}

/// A step that evaluates the energy at x + `ahead`·d.
#[inline(always)]
fn step<S: ImplicitStep<M, R>, M, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    Prepared { constants, half, poles }: &PreparedFor<S, M, R>,
    newton: &mut Newton<S::Unknown>,
    ahead: f64,
    Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
) -> Result<(), Refusal> {
    let (n, middle) = (S::Phase::LEN, t + *half);
    let mut origin = S::Unknown::zero();
    let entries = origin.as_mut_slice();
    entries[..n].copy_from_slice(Array::as_slice(&x.z));
    entries[n] = x.s;
    let begun = system.begin(constants, middle, &origin);
    let equation = Equation::<S, M, R> { system, constants, begun, middle, origin, ahead };
    let Solution { x: d, .. } = newton.solve(&equation, probe)?;

    let increments = system.end(constants, &equation.begun, &d);
    if !increments.is_finite() {
        return Err(Refusal::Singular);
    }
    let before = start::<S, R, C>(x);
    x.add_everywhere(&apart::<S, M, R>(&increments));
    check_end(poles, &before, Step { system, t, end, x, probe })
}

/// Positions, momenta and the action.
#[inline(always)]
fn apart<S: ImplicitStep<M, R>, M, R: Real>(x: &S::Unknown) -> PerCoordinate<S::Phase, R> {
    let mut z = S::Phase::zero();
    Array::as_mut_slice(&mut z).copy_from_slice(&x.as_slice()[..S::Phase::LEN]);
    PerCoordinate { z, s: x.as_slice().last().copied().unwrap_or_else(zero) }
}

/// The steps of methods whose equation is that of increments: where they look at the energy.
macro_rules! steps {
    ($($method:ident by $form:ident: $ahead:literal;)*) => { $(
        impl<S: ImplicitStep<$method, R>, R: Real> StepsOf<$method, S, R> for $form {
            type Prepared = PreparedFor<S, $method, R>;
            type Memory = Newton<S::Unknown>;

            fn prepare(system: &S, h: R) -> Self::Prepared {
                Prepared { constants: system.constants(h), half: R::from_f64(0.5) * h, poles: Poles::of(system) }
            }

            fn memory() -> Self::Memory {
                Newton::new(S::Array::LEN, 3)
            }

            #[inline(always)]
            fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
                prepared: &Self::Prepared,
                memory: &mut Self::Memory,
                at: Step<'_, S, R, C, P>,
            ) -> Result<(), Refusal> {
                step::<S, $method, R, C, P>(prepared, memory, $ahead, at)
            }
        }
    )* };
}

steps! {
    ContactMidpoint by ByField: 0.5;
    ContactDiscreteGradient by ByTree: 1.0;
}

/// Makes methods of this: in which form systems have them, and what they claim.
macro_rules! methods {
    ($($method:ident: $form:ident, $of:ident, $claims:expr;)*) => { $(
        impl<S: $form<R>, R: Real> Method<S, R> for $method
        where
            S::$of: StepsOf<$method, S, R>,
        {
            type Proof = <S as $form<R>>::Proof;
            type Prepared = <S::$of as StepsOf<$method, S, R>>::Prepared;
            type Memory = <S::$of as StepsOf<$method, S, R>>::Memory;

            fn claims(&self) -> Claims {
                $claims
            }

            fn name(&self) -> Name {
                Name::new(stringify!($method))
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                <S::$of as StepsOf<$method, S, R>>::prepare(system, h)
            }

            fn memory() -> Self::Memory {
                <S::$of as StepsOf<$method, S, R>>::memory()
            }

            #[inline(always)]
            fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
                prepared: &Self::Prepared,
                memory: &mut Self::Memory,
                at: Step<'_, S, R, C, P>,
            ) -> Result<(), Refusal> {
                <S::$of as StepsOf<$method, S, R>>::step(prepared, memory, at)
            }
        }
    )* };
}

methods! {
    ContactMidpoint: ContactCollocated, Midpoint, Claims::of_order(2).symmetric().symplectic();
    ContactDiscreteGradient: ContactGraded, Gradient, Claims::of_order(2).symmetric().conserving_energy();
}
substeps!([] ContactMidpoint; [] ContactDiscreteGradient);
