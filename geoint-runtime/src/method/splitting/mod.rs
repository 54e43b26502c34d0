//! Kick and drift in alternation: one driver for every table of a splitting method.
//!
//! A table says in which order and for which fractions of h the flows of T and V are applied. Time goes along twice: a
//! kick happens at the time that the drifts so far have reached, a drift at the time that the kicks so far have
//! reached. In the space extended by both clocks T and V are still exact flows, so that no table loses its order when
//! T or V depends on time.

mod driver;
mod flows;
mod nystrom;
mod table;
mod verlet;

pub use driver::Sequence;
pub use flows::{DriftFirst, KickFirst, Kicks, Moving, Order, SomeKick, Times, Weight, WithGradient, WithoutGradient};
pub use nystrom::Nystrom;
pub use table::{Flow, Splitting};
pub use verlet::{PositionVerlet, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint};

/// A method that is another one under a stricter condition or another name.
macro_rules! delegate {
    ($(#[$doc:meta])* [$($generics:tt)*] $method:ty, $system:ident, $inner:ty, |$this:ident| $table:expr) => {
        $(#[$doc])*
        impl<$($generics)* S: $system<R>, R: Real> Method<S, R> for $method
        where
            $inner: Method<S, R, Memory = ()>,
        {
            type Prepared = <$inner as Method<S, R>>::Prepared;
            type Memory = ();

            fn claims(&self) -> Claims {
                let $this = self;
                $table.claims()
            }
            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                let $this = self;
                Method::prepare(&$table, system, h)
            }
            fn memory() {}
            #[inline(always)]
            fn step<C: Summation<S::Array>, P: Probe<S, R>>(
                prepared: &Self::Prepared,
                memory: &mut (),
                step: Step<'_, S, R, C, P>,
            ) -> Result<(), Refusal> {
                <$inner as Method<S, R>>::step(prepared, memory, step)
            }
            #[inline(always)]
            fn advance<C: Summation<S::Array>>(
                prepared: &Self::Prepared,
                memory: &mut (),
                system: &S,
                clock: &Clock<R>,
                steps: u64,
                x: &mut Point<S::Array, C, S::Action>,
            ) -> Result<(), Refusal> {
                <$inner as Method<S, R>>::advance(prepared, memory, system, clock, steps, x)
            }
        }
    };
}
use delegate;
