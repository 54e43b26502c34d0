//! What the flow keeps, as methods that project need to know it.

use crate::method::And;
use crate::scalar::{Real, zero};
use crate::space::Array;
use crate::system::{Autonomous, DiscreteField};

/// One or more functions of (q, p) that the flow of `S` keeps.
///
/// Points and increments are pairs (q, p) of nested arrays. Tuples of two or three single invariants are invariants.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a set of invariants of `{S}`",
    note = "`Energy` is one of every autonomous system whose divided differences are known"
)]
pub trait Invariants<S, R: Real = f64>: Copy
where
    S: crate::Hamiltonian<R>,
{
    /// `()`, or what an invariant needs of the system; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// One scalar an invariant: `R`, or an array.
    type Values: Array<Real = R>;
    /// Whether H is a function of the invariants.
    const KEEP_ENERGY: bool = false;

    /// What they change by between `x` and `x + d`. Write it without subtracting values where you can: what is lost in that
    /// difference is added to the trajectory.
    fn changes(&self, system: &S, x: &[S::Array; 2], d: &[S::Array; 2]) -> Self::Values;

    /// The gradient of each: its derivatives by q and by p.
    fn gradients(&self, system: &S, x: &[S::Array; 2]) -> <Self::Values as Array>::Map<[S::Array; 2]>;
}

/// H itself.
///
/// Its change is that of the discrete gradient, ∇̄H(x, x + d)·d: the exact difference without cancellation, however large H
/// is. Differences of values would add a noise of ε|H|/|∇H| to the trajectory in every step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Energy;

impl<S: DiscreteField<R> + Autonomous<R>, R: Real> Invariants<S, R> for Energy {
    type Proof = <S as Autonomous<R>>::Proof;
    type Values = R;
    const KEEP_ENERGY: bool = true;

    #[inline]
    fn changes(&self, system: &S, [q, p]: &[S::Array; 2], [dq, dp]: &[S::Array; 2]) -> R {
        let ((y, mut changed), (d, change)) = (S::start(q, p), S::start(dq, dp));
        let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        let parameters = system.parameters(zero());
        let start = system.begin(&parameters, zero(), &y);
        system.slope(&parameters, &start, &d, &mut f, &mut jacobian);
        if S::DERIVATIVE == 1 {
            // f̄ = J∇̄H: the rates of q and of p.
            let (rate_q, rate_p) = f.as_slice().split_at(S::Array::LEN);
            return dot(rate_q, dp.as_slice()) - dot(rate_p, dq.as_slice());
        }
        // f̄ = −∇̄V, and the mean gradient of a quadratic T is that of the mean momentum.
        changed.add_scaled(R::from_f64(0.5), &change);
        let velocity = system.velocity(&system.constants(), &changed);
        dot(velocity.as_slice(), change.as_slice()) - dot(f.as_slice(), d.as_slice())
    }

    #[inline]
    fn gradients(&self, system: &S, [q, p]: &[S::Array; 2]) -> [S::Array; 2] {
        let mut gradient = [S::Array::zero(); 2];
        let [by_q, by_p] = &mut gradient;
        system.gradient(zero(), q, p, by_q, by_p);
        gradient
    }
}

/// The proofs of all.
macro_rules! proofs {
    ($I:ident) => { $I::Proof };
    ($I:ident $($rest:ident)+) => { <$I::Proof as And<proofs!($($rest)+)>>::Both };
}

/// Single invariants side by side.
macro_rules! tuples {
    ($($n:literal: $($I:ident $i:tt)*;)*) => { $(
        impl<S: crate::Hamiltonian<R>, R: Real, $($I: Invariants<S, R, Values = R>),*> Invariants<S, R> for ($($I,)*) {
            type Proof = proofs!($($I)*);
            type Values = [R; $n];
            const KEEP_ENERGY: bool = $($I::KEEP_ENERGY)||*;

            #[inline]
            fn changes(&self, system: &S, x: &[S::Array; 2], d: &[S::Array; 2]) -> [R; $n] {
                [$(self.$i.changes(system, x, d)),*]
            }
            #[inline]
            fn gradients(&self, system: &S, x: &[S::Array; 2]) -> [[S::Array; 2]; $n] {
                [$(self.$i.gradients(system, x)),*]
            }
        }
    )* };
}

tuples! {
    2: A 0 B 1;
    3: A 0 B 1 C 2;
}

/// Σ xᵢ·yᵢ.
#[inline]
fn dot<R: Real>(x: &[R], y: &[R]) -> R {
    x.iter().zip(y).fold(zero(), |sum, (x, y)| x.multiply_add(*y, sum))
}

/// The same over positions and momenta.
#[inline]
pub(crate) fn product<A: Array>(x: &[A; 2], y: &[A; 2]) -> A::Real {
    dot(x[0].as_slice(), y[0].as_slice()) + dot(x[1].as_slice(), y[1].as_slice())
}

/// x + w·y.
#[inline]
pub(crate) fn plus<A: Array>(mut x: [A; 2], w: f64, y: &[A; 2]) -> [A; 2] {
    for (x, y) in x.iter_mut().zip(y) {
        x.add_scaled(A::Real::from_f64(w), y);
    }
    x
}
