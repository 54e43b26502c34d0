//! Sets of invariants of a flow, as projection and relaxation need them: changes between two points, and gradients.

use super::turns::change_at_cuts;
use crate::method::And;
use crate::scalar::{Real, zero};
use crate::space::Array;
use crate::space::vector::{dot, moved, opposite, sum, sum_of_products};
use crate::system::{
    DiscreteField, Hamiltonian, KeepsEnergy, KeptMomenta, PhaseSpace, Span, SteadyIntegrals, VectorField, VelocityForm,
    energy_of, velocity_of,
};
pub use crate::system::{Invariants, Origin};

/// The energy H.
///
/// Its change is computed by the discrete gradient, ∇̄H(x, x + d)·d. This is the exact difference without cancellation, also if H is large. A
/// difference of values would add an error of ε|H|/|∇H| to the trajectory in each step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Energy;

impl<S: KeepsEnergy<R>, R: Real> Invariants<S, R> for Energy {
    /// The type is unknown if the system does not keep H; see [`Method::Proof`](crate::Method::Proof).
    type Values = <<S as KeepsEnergy<R>>::Proof as And<R>>::Both;
    const ORIGIN: Origin = Origin::Derived;

    #[inline]
    fn changes(&self, system: &S, z: &S::Phase, dz: &S::Phase) -> R {
        S::Kept::default().changes(system, z, dz)
    }

    #[inline]
    fn gradients(&self, system: &S, z: &S::Phase) -> S::Phase {
        S::Kept::default().gradients(system, z)
    }
}

/// H(q, p), with changes from the kernel of discrete gradients.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default)]
pub struct CanonicalEnergy;

impl<S: DiscreteField<R> + Hamiltonian<R>, R: Real> Invariants<S, R> for CanonicalEnergy {
    type Values = R;

    #[inline]
    fn changes(&self, system: &S, z: &S::Phase, dz: &S::Phase) -> R {
        let ((y, mut changed), (d, change)) = (S::start(z), S::start(dz));
        let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        let parameters = system.parameters(zero());
        let start = system.begin(&parameters, Span::at(zero()), &y);
        system.slope(&parameters, &start, &d, &mut f, &mut jacobian);
        if S::EQUATION_ORDER.is_first() {
            // f̄ = J∇̄H: the rates of q and of p.
            let ((rate_q, rate_p), [dq, dp]) = (f.as_slice().split_at(S::Array::LEN), dz);
            return sum_of_products(rate_q, dp.as_slice()) - sum_of_products(rate_p, dq.as_slice());
        }
        // f̄ = −∇̄V, and the mean gradient of a quadratic T is that of the mean momentum.
        changed.add_scaled(R::from_f64(0.5), &change);
        let velocity = system.velocity(&system.constants(), &changed);
        dot(&velocity, &change) - dot(&f, &d)
    }

    #[inline]
    fn gradients(&self, system: &S, z: &S::Phase) -> S::Phase {
        let mut gradient = S::Phase::zero();
        system.gradient(zero(), z, &mut gradient);
        gradient
    }
}

/// The kept momenta, and H(q, p) if `ENERGY` is true.
///
/// Momenta are of degree 2 at most. Their change is therefore the gradient at the midpoint times the increment.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default)]
pub struct EnergyAndMomenta<const ENERGY: bool>;

impl<S: DiscreteField<R> + KeptMomenta<R>, R: Real, const ENERGY: bool> Invariants<S, R> for EnergyAndMomenta<ENERGY> {
    type Values = S::Values;

    fn changes(&self, system: &S, z: &S::Phase, dz: &S::Phase) -> S::Values {
        let mut changes = S::Values::zero();
        let gradients = system.momenta(&moved(z, R::from_f64(0.5), dz));
        for (change, gradient) in changes.as_mut_slice().iter_mut().zip(S::Values::entries_of(&gradients)) {
            *change = dot(gradient, dz);
        }
        if ENERGY {
            changes.as_mut_slice()[0] = CanonicalEnergy.changes(system, z, dz);
        }
        changes
    }

    fn gradients(&self, system: &S, z: &S::Phase) -> <S::Values as Array>::Map<S::Phase> {
        let mut gradients = system.momenta(z);
        if ENERGY {
            S::Values::entries(&mut gradients)[0] = CanonicalEnergy.gradients(system, z);
        }
        gradients
    }
}

/// The energy p·v − L of a Lagrangian system whose velocities are found by iteration. The change is a difference of values, because H has no formula
/// for divided differences.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default)]
pub struct VelocityEnergy;

impl<S: VelocityForm<R> + VectorField<R> + PhaseSpace<R, Action = ()>, R: Real> Invariants<S, R> for VelocityEnergy {
    type Values = R;

    #[inline]
    fn changes(&self, system: &S, z: &S::Phase, dz: &S::Phase) -> R {
        let energy = |z: &S::Phase| energy_of(system, zero(), z, &());
        energy(&sum(z, dz)) - energy(z) - change_at_cuts(system, z, dz, energy)
    }

    /// ∂H/∂q = −∂L/∂q and ∂H/∂p = v.
    #[inline]
    fn gradients(&self, system: &S, z: &S::Phase) -> S::Phase {
        let v = velocity_of(system, zero(), z, &());
        let (force, _) = system.force(&system.stage_constants(), zero(), &z[0], &v, &());
        [opposite(&force), v]
    }
}

/// The time-independent first integral with the given index.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Integral<const INDEX: usize>;

impl<S: SteadyIntegrals<R>, R: Real, const INDEX: usize> Invariants<S, R> for Integral<INDEX> {
    type Values = R;

    #[inline]
    fn changes(&self, system: &S, z: &S::Phase, dz: &S::Phase) -> R {
        system.changes(z, dz).as_slice()[INDEX]
    }

    #[inline]
    fn gradients(&self, system: &S, z: &S::Phase) -> S::Phase {
        S::Steady::entries_of(&system.slopes(z))[INDEX]
    }
}

/// All first integrals that the system was proven to keep and that do not depend on time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Integrals;

impl<S: SteadyIntegrals<R>, R: Real> Invariants<S, R> for Integrals
where
    <S as SteadyIntegrals<R>>::Proof: And<S::Steady, Both = S::Steady>,
{
    type Values = S::Steady;
    const ORIGIN: Origin = Origin::Derived;

    #[inline]
    fn changes(&self, system: &S, x: &S::Phase, d: &S::Phase) -> S::Steady {
        system.changes(x, d)
    }

    #[inline]
    fn gradients(&self, system: &S, x: &S::Phase) -> <S::Steady as Array>::Map<S::Phase> {
        system.slopes(x)
    }
}

/// The empty set of invariants.
impl<S: PhaseSpace<R>, R: Real> Invariants<S, R> for () {
    type Values = [R; 0];

    #[inline]
    fn changes(&self, _: &S, _: &S::Phase, _: &S::Phase) -> [R; 0] {
        []
    }

    #[inline]
    fn gradients(&self, _: &S, _: &S::Phase) -> [S::Phase; 0] {
        []
    }
}

/// The type of the values, which is known only if the types of all members are known; see [`Method::Proof`](crate::Method::Proof).
macro_rules! known {
    ($last:ty;) => { $last };
    ($last:ty; $I:ident $($rest:ident)*) => { <$I::Values as And<known!($last; $($rest)*)>>::Both };
}

/// Implements [`Invariants`] for tuples of single invariants.
macro_rules! tuples {
    ($($n:literal: $($I:ident $i:tt)*;)*) => { $(
        impl<S: PhaseSpace<R>, R: Real, $($I: Invariants<S, R, Values = R>),*> Invariants<S, R> for ($($I,)*) {
            type Values = known!([R; $n]; $($I)*);
            const ORIGIN: Origin = Origin::of(&[$($I::ORIGIN),*]);

            #[inline]
            fn changes(&self, system: &S, x: &S::Phase, d: &S::Phase) -> [R; $n] {
                [$(self.$i.changes(system, x, d)),*]
            }
            #[inline]
            fn gradients(&self, system: &S, x: &S::Phase) -> [S::Phase; $n] {
                [$(self.$i.gradients(system, x)),*]
            }
        }
    )* };
}

tuples! {
    2: A 0 B 1;
    3: A 0 B 1 C 2;
}
