//! Splitting methods for H = T + V: kicks and drifts in alternation, with one driver for all tables.
//!
//! A table lists the fractions of h for the flows of T and V, in order of application. There are two clocks. A kick reads
//! the time that the drifts have reached, and a drift reads the time that the kicks have reached. In the phase space
//! extended by both clocks, kicks and drifts are exact flows. Every table therefore keeps its order if T or V depends on
//! time.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Two masses on springs that harden.
//! #[hamiltonian]
//! fn springs(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: f64) -> f64 {
//!     let stretch = q[1] - q[0];
//!     p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + k * (stretch.powi(2) / 2.0 + stretch.powi(4) / 4.0)
//! }
//!
//! let system = Springs { m: [0.5, 2.0], k: 3.0 };
//! let start = State::new([0.0, 1.0], [0.2, -0.1]);
//! // Energy errors do not grow with time. Order 4 has far smaller errors for the same number of forces.
//! let mut verlet = system.integrator(StormerVerlet, 0.01, start);
//! let mut fourth = system.integrator(BlanesMoan4, 0.06, start);
//! let energy = verlet.energy();
//! verlet.advance(60_000)?;
//! fourth.advance(10_000)?;
//! assert!((verlet.energy() / energy - 1.0).abs() < 1e-3);
//! assert!((fourth.energy() / energy - 1.0).abs() < 1e-5);
//! # Ok::<(), StepError>(())
//! ```
//!
//! A table of your own is a constant, which the compiler checks: see [`Splitting`].

mod between;
mod driver;
mod estimators;
mod field;
mod flows;
mod kicks;
mod last_kick;
mod moving;
mod nystrom;
mod processed;
mod rotations;
mod sequence;
mod table;
mod told;
mod verlet;

pub use estimators::Estimators;
pub(in crate::method) use estimators::Mirrored;
pub use field::{gradient_kick, modified_verlet};
pub use flows::{DriftFirst, KickFirst};
pub use kicks::{SomeKick, Weight, WithGradient, WithoutGradient};
pub use last_kick::LastKick;
pub use moving::{Moving, Times};
pub use nystrom::Nystrom;
pub use processed::ProcessedSplitting;
pub use rotations::{FiveRotations, KickAndRotations};
pub use sequence::Sequence;
pub use table::{Flow, Splitting};
pub use verlet::{PositionVerlet, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint};

/// Implements the steps of a method by the steps of an inner method. `part` and `own` are the coefficients and the memory of the inner method.
macro_rules! steps_of {
    ($inner:ty, |$prepared:ident| $part:expr) => {
        $crate::method::splitting::steps_of!($inner, |$prepared, memory| ($part, memory));
    };
    ($inner:ty, |$prepared:ident, $memory:ident| ($part:expr, $own:expr)) => {
        #[inline(always)]
        fn step<Sums: Summation<S::Phase>, Watching: Probe<S, R>>(
            $prepared: &Self::Prepared,
            $memory: &mut Self::Memory,
            step: Step<'_, S, R, Sums, Watching>,
        ) -> Result<(), Refusal> {
            <$inner as Method<S, R>>::step($part, $own, step)
        }

        #[inline(always)]
        fn advance<Sums: Summation<S::Phase>>(
            $prepared: &Self::Prepared,
            $memory: &mut Self::Memory,
            system: &S,
            clock: &Clock<R>,
            steps: u64,
            x: &mut Point<S::Phase, Sums, S::Action>,
        ) -> Result<(), Refusal> {
            <$inner as Method<S, R>>::advance($part, $own, system, clock, steps, x)
        }
    };
}
pub(in crate::method) use steps_of;

/// Implements a method by an inner method, under another name or a stricter condition on the system.
macro_rules! delegate {
    ($(#[$doc:meta])* [$($generics:tt)*] $method:ty, $system:ident, $inner:ty, |$this:ident| $table:expr, $name:expr) => {
        $(#[$doc])*
        impl<$($generics)* S: $system<R>, R: Real> Method<S, R> for $method
        where
            $inner: Method<S, R>,
        {
            type Proof = <S as $system<R>>::Proof;
            type Prepared = <$inner as Method<S, R>>::Prepared;
            type Memory = <$inner as Method<S, R>>::Memory;
            const SINGLY: bool = <$inner as Method<S, R>>::SINGLY;

            fn claims(&self) -> Claims {
                let $this = self;
                $table.claims()
            }
            fn name(&self) -> Name {
                let $this = self;
                $name
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                let $this = self;
                Method::prepare(&$table, system, h)
            }
            #[inline(always)]
            fn shows(prepared: &Self::Prepared) -> bool {
                <$inner as Method<S, R>>::shows(prepared)
            }
            fn memory() -> Self::Memory {
                <$inner as Method<S, R>>::memory()
            }
            $crate::method::splitting::steps_of!($inner, |prepared| prepared);
        }
    };
}
pub(in crate::method) use delegate;
