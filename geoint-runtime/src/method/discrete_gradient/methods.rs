//! The table of methods that step along a mean of gradients.

use super::mean::{Corrected, MeanGradient, Memory, Prepared};
use super::{CoordinateIncrement, FourthOrder, Gonzalez, ItohAbe, ItohAbeAdjoint, MeanValue, SymmetrisedItohAbe};
use crate::method::composition::SymmetricMap;
use crate::method::corrected::kept;
use crate::method::corrected::range::is_representable;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::{Claims, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{Array, Summation};
use crate::system::{Conservative, DiscreteField, Invariants, KeptBy};

impl Corrected for Gonzalez {}
impl<const K: usize> Corrected for MeanValue<K> where MeanValue<K>: MeanGradient + SymmetricMap {}
impl Corrected for SymmetrisedItohAbe {}

/// Makes methods of means: the order, whether it is symmetric, whether symplectic, whether it keeps the energy.
macro_rules! methods {
    ($system:ident, $([$($generic:tt)*] $mean:ty $(where $bounded:ty: $bound:path)?: $order:literal, $symmetric:literal, $symplectic:expr, $energy:expr;)*) => { $(
        impl<$system, R, $($generic)*> Method<$system, R> for $mean
        where
            $system: DiscreteField<R> + Conservative<R>,
            R: Real,
            $($bounded: $bound,)?
        {
            type Proof = <$system as Conservative<R>>::Proof;
            type Prepared = Prepared<Self, $system, R>;
            type Memory = Memory<$system::Array>;
            const KEEPS: bool = <KeptBy<$system, R> as Invariants<$system, R>>::Values::LEN > 0;

            #[inline]
            fn way_back(_: &Self::Prepared, system: &$system, origin: &$system::Phase, z: &$system::Phase) -> $system::Phase {
                // A mean that is no discrete gradient of the system keeps nothing.
                let keeps: bool = $energy;
                if keeps { kept::way_back(system, &KeptBy::<$system, R>::default(), origin, z) } else { $system::Phase::zero() }
            }

            #[inline]
            fn is_in_range(_: &Self::Prepared, system: &$system, z: &$system::Phase) -> bool {
                !<$mean as MeanGradient>::OF_ENERGIES || is_representable(system, &KeptBy::<$system, R>::default(), z)
            }

            fn claims(&self) -> Claims {
                Claims { order: $order, symmetric: $symmetric, symplectic: $symplectic, conserves_energy: $energy, perturbed: &[], forces: None }
            }

            fn name(&self) -> Name {
                self.mean_name()
            }

            fn prepare(&self, system: &$system, h: R) -> Self::Prepared {
                Prepared::new(*self, system, h)
            }

            fn memory() -> Self::Memory {
                Memory::new()
            }

            #[inline]
            fn step<C: Summation<$system::Phase>, P: Probe<$system, R>>(
                prepared: &Self::Prepared,
                memory: &mut Self::Memory,
                step: Step<'_, $system, R, C, P>,
            ) -> Result<(), Refusal> {
                prepared.step(memory, step)
            }
        }
    )* };
}

// `FourthOrder` of each mean by itself: where there is one implementation for a type, the compiler says which of its bounds fails.
methods! { S,
    [] ItohAbe: 1, false, false, true;
    [] ItohAbeAdjoint: 1, false, false, true;
    [] SymmetrisedItohAbe: 2, true, false, true;
    [] Gonzalez: 2, true, false, true;
    [] CoordinateIncrement: 1, false, false, true;
    [const K: usize] MeanValue<K> where Gauss<K>: GaussTableau<K>: 2, true, MeanValue::<K>::is_midpoint::<S, R>(), MeanValue::<K>::is_exact::<S, R>();
    [] FourthOrder<Gonzalez>: 4, true, false, Gonzalez::is_exact::<S, R>();
    [] FourthOrder<SymmetrisedItohAbe>: 4, true, false, SymmetrisedItohAbe::is_exact::<S, R>();
    [const K: usize] FourthOrder<MeanValue<K>> where MeanValue<K>: Corrected: 4, true, false, MeanValue::<K>::is_exact::<S, R>();
}
