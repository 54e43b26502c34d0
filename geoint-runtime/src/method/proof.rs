//! Proofs that a system has the properties of a method, and their conjunction; see [`Method::Proof`](crate::Method::Proof).

/// The conjunction of two proofs, a type that exists if both proofs exist.
pub trait And<Q> {
    /// The type `Q`, known to rustc only if `Self` and `Q` are known.
    type Both;
}

impl<P, Q> And<Q> for P {
    type Both = Q;
}

/// The proof for steps that obey the laws of the system forward in time only: [`DiscreteGradient`](crate::DiscreteGradient) never lowers an entropy in a
/// step of positive length.
#[derive(Clone, Copy, Debug)]
pub struct ForwardInTime;

/// A map whose steps obey the laws of systems `S` back in time as well. Compositions of order 4 and more have steps back in time. The proof of a method is one
/// if it holds in both directions.
#[diagnostic::on_unimplemented(
    message = "entropy would fall in a composition of `DiscreteGradient` for `{S}`, because some of its steps lead back in time",
    label = "this composition does not fit a system with an `entropy`",
    note = "`DiscreteGradient` alone, of order 2, keeps the energy and never lowers the entropy",
    note = "methods of higher order that keep neither exactly: `RK4`, `DOP853`, `Gauss`, `Suzuki4.of(ImplicitMidpoint)`"
)]
pub trait StepsBack<S, R> {}

impl<S, R> StepsBack<S, R> for () {}

/// The run `T`, given the proof `P` that the system has the properties that its method needs. In a program that compiles it is `T`.
///
/// `integrator` and `adaptive` of a system return it. If a property is missing, `P` and this type stay unknown, and rustc reports the missing property
/// only. With the return type `T` each later use of the run would be an error, too.
pub type Given<P, T> = <P as And<T>>::Both;
