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

/// The run `T`, given the proof `P` that the system has the properties that its method needs. In a program that compiles it is `T`.
///
/// `integrator` and `adaptive` of a system return it. If a property is missing, `P` and this type stay unknown, and rustc reports the missing property
/// only. With the return type `T` each later use of the run would be an error, too.
pub type Given<P, T> = <P as And<T>>::Both;
