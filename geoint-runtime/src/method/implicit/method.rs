//! Connects implicit steps with methods. One method may have different steps for different kinds of systems: [`ImplicitMethod`] names the step for a kind, and
//! [`implicit_method!`](crate::implicit_method) implements [`Method`](crate::Method) by the driver of implicit steps.

use super::driver::{Memory, Prepared};
use super::step::ImplicitStep;
use crate::method::Handling;
use crate::method::proof::StepsBack;
use crate::scalar::Real;
use crate::space::Array;
use crate::system::{Invariants, PhaseSpace};

/// A method whose steps of systems `S` are implicit. The attribute macros implement this trait for each system and each method of this crate that fits it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a method for `{S}`",
    label = "this method does not fit this kind of system",
    note = "of a vector field name what it keeps: `#[vector_field(keeps(name = expression))]`",
    note = "methods for contact Hamiltonians: `ContactGauss`, `ContactMidpoint`, `ContactDiscreteGradient`; for a `lift`: `ContactSplitting`",
    note = "methods with forces beside an action: `DOP853`, `RK4`, and Taylor series by `system.taylor`",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`; with `rolling`: `DiscreteGradient`, `RK4`, `DOP853`",
    note = "methods that keep a `constraint` beside `s`: `ContactSplitting`, `ContactLeapfrog`, `ContactDiscreteGradient`",
    note = "methods for rigid bodies (`attitude = r`): tables of kicks and drifts such as `BlanesMoanSrkn14a`, `FiveRotations`, `RK4`, `DOP853`"
)]
pub trait ImplicitMethod<S: PhaseSpace<R>, R: Real = f64>: Copy {
    /// `()` if the system has the properties that the method needs; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The step of this method for systems `S`.
    type Step: ImplicitStep<S, R>;

    /// Returns the step, with the parameters of the method.
    fn step(self) -> Self::Step;
}

/// A system for which `M` is an [`ImplicitMethod`], at least for steps forward in time. All these systems implement it.
pub trait SteppedBy<M, R: Real = f64>: PhaseSpace<R> {
    /// See [`ImplicitMethod::Proof`].
    type Proof;
    /// See [`ImplicitMethod::Step`].
    type Step: ImplicitStep<Self, R>;

    /// See [`ImplicitMethod::step`].
    fn step_of(method: M) -> Self::Step;
}

impl<M: ImplicitMethod<S, R>, S: PhaseSpace<R>, R: Real> SteppedBy<M, R> for S {
    type Proof = <M as ImplicitMethod<S, R>>::Proof;
    type Step = <M as ImplicitMethod<S, R>>::Step;

    fn step_of(method: M) -> Self::Step {
        method.step()
    }
}

/// A system for which `M` is an [`ImplicitMethod`] in both directions of time, so that compositions of `M` fit it, too. All these systems implement it. It
/// states `M: ImplicitMethod<S>` as a bound of `S`, so that it can be a supertrait.
pub trait SolvedBy<M, R: Real = f64>: SteppedBy<M, R> {}

impl<M, S: SteppedBy<M, R, Proof: StepsBack<S, R>>, R: Real> SolvedBy<M, R> for S {}

/// Returns [`Method::HANDLING`](crate::Method::HANDLING) of the steps of a method.
pub const fn handling<M, S: SteppedBy<M, R>, R: Real>() -> Handling {
    Handling {
        is_rough_if_short: <StepFor<M, S, R> as ImplicitStep<S, R>>::POLICY.is_rough_if_short,
        keeps_invariants: <<StepFor<M, S, R> as ImplicitStep<S, R>>::Kept as Invariants<S, R>>::Values::LEN > 0,
        ..Handling::PLAIN
    }
}

/// Returns [`ImplicitStep::COMPOSES_TO`] of the steps of a method.
pub const fn composes_to<M, S: SteppedBy<M, R>, R: Real>() -> u32 {
    <StepFor<M, S, R> as ImplicitStep<S, R>>::COMPOSES_TO
}

/// The step of a method for a system.
pub type StepFor<M, S, R> = <S as SteppedBy<M, R>>::Step;

/// The coefficients of the steps of a method: [`Method::Prepared`](crate::Method::Prepared).
pub type PreparedFor<M, S, R> = Prepared<StepFor<M, S, R>, S, R>;

/// The values that a step of a method passes to the next one: [`Method::Memory`](crate::Method::Memory).
pub type MemoryFor<M, S, R> = Memory<StepFor<M, S, R>, S, R>;

/// Implements [`Method`](crate::Method) for a type, and for all systems for which it is an [`ImplicitMethod`].
///
/// Arguments: the type, a closure from the method to its [`Name`](crate::method::Name), and its [`Claims`](crate::method::Claims) for all systems. Generic
/// parameters of the type stand in brackets before it. One bound may follow: `implicit_method!([const S: usize] Gauss<S>, |_| …, …, Gauss<S>: Bound)`.
#[macro_export]
macro_rules! implicit_method {
    ([$($generic:tt)*] $method:ty, |$this:pat_param| $name:expr, $claims:expr $(, $bounded:ty: $bound:path)?) => {
        impl<System, Number, $($generic)*> $crate::Method<System, Number> for $method
        where
            System: $crate::method::implicit::SteppedBy<$method, Number>,
            Number: $crate::Real,
            $($bounded: $bound,)?
        {
            type Proof = <System as $crate::method::implicit::SteppedBy<$method, Number>>::Proof;
            type Prepared = $crate::method::implicit::PreparedFor<$method, System, Number>;
            type Memory = $crate::method::implicit::MemoryFor<$method, System, Number>;
            const COMPOSES_TO: u32 = $crate::method::implicit::composes_to::<$method, System, Number>();
            const HANDLING: $crate::method::Handling = $crate::method::implicit::handling::<$method, System, Number>();

            fn claims(&self) -> $crate::method::Claims {
                <$crate::method::implicit::StepFor<$method, System, Number> as $crate::method::implicit::ImplicitStep<System, Number>>::claims($claims)
            }

            fn name(&self) -> $crate::method::Name {
                let $this = self;
                $name
            }

            fn prepare(&self, system: &System, h: Number) -> Self::Prepared {
                Self::Prepared::new(<System as $crate::method::implicit::SteppedBy<$method, Number>>::step_of(*self), system, h)
            }

            fn memory(_: &System::Phase) -> Self::Memory {
                Self::Memory::new()
            }

            #[inline(always)]
            fn step<C: $crate::space::Summation<System::Phase>, P: $crate::method::Probe<System, Number>>(
                prepared: &Self::Prepared,
                memory: &mut Self::Memory,
                step: $crate::method::Step<'_, System, Number, C, P>,
            ) -> Result<(), $crate::method::Failure> {
                prepared.step(memory, step)
            }

            #[inline]
            fn way_back(_: &Self::Prepared, system: &System, origin: &System::Phase, z: &System::Phase) -> System::Phase {
                <$crate::method::implicit::StepFor<$method, System, Number> as $crate::method::implicit::ImplicitStep<System, Number>>::way_back(system, origin, z)
            }

            #[inline]
            fn is_in_range(_: &Self::Prepared, system: &System, z: &System::Phase) -> bool {
                <$crate::method::implicit::StepFor<$method, System, Number> as $crate::method::implicit::ImplicitStep<System, Number>>::is_in_range(system, z)
            }

            fn order_of_estimate(&self) -> Option<u32> {
                Self::Prepared::ORDER_OF_ESTIMATE
            }

            #[inline(always)]
            fn estimated<C: $crate::space::Summation<System::Phase>, P: $crate::method::Probe<System, Number>>(
                prepared: &Self::Prepared,
                memory: &mut Self::Memory,
                step: $crate::method::Step<'_, System, Number, C, P>,
            ) -> Option<Result<$crate::method::Estimate<System, Number>, $crate::method::Failure>> {
                prepared.estimated(memory, step)
            }
        }
    };
    ($method:ty, |$this:pat_param| $name:expr, $claims:expr) => {
        $crate::implicit_method!([] $method, |$this| $name, $claims);
    };
}
