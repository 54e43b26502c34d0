//! All methods and tables by name, for `use geoint_runtime::methods::*` beside the [`prelude`](crate::prelude).
//!
//! The prelude has the methods that programs use most. [`method`](crate::method) explains all methods, and has a table of them.
//! [Which method](crate::guide::_03_which_method) helps to choose.
//!
//! ```
//! use geoint_runtime::methods::*;
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian]
//! fn oscillator(q: f64, p: f64) -> f64 {
//!     p * p / 2.0 + q * q / 2.0
//! }
//!
//! let mut sim = Oscillator.integrator(KahanLi8_17a.of(Gonzalez), 0.1, State::new(1.0, 0.0));
//! sim.advance(100)?;
//! assert!((sim.state().q - 10_f64.cos()).abs() < 1e-10);
//! # Ok::<(), StepError>(())
//! ```

#[doc(inline)]
pub use crate::method::composition::{Composed, Composition};
#[doc(inline)]
pub use crate::method::constrained::Rattle;
#[doc(inline)]
pub use crate::method::contact::{ContactDiscreteGradient, ContactGauss, ContactLeapfrog, ContactMidpoint};
#[doc(inline)]
pub use crate::method::corrected::{Energy, Integrals, Projection, Relaxation};
#[doc(inline)]
pub use crate::method::discrete_gradient::{
    CoordinateIncrement, DiscreteGradient, FourthOrder, Gonzalez, ItohAbe, ItohAbeAdjoint, ItohAbePair, MeanValue,
    SymmetrisedItohAbe,
};
#[doc(inline)]
pub use crate::method::explicit::{DOP853, ExplicitEuler, RK4, RungeKutta};
#[doc(inline)]
pub use crate::method::flows::perturbed::Perturbation;
#[doc(inline)]
pub use crate::method::flows::pieces::{
    ContactSplitting, PieceComposition, PieceNystrom, PieceSplitting, PlanarDiscreteGradient, PlanarItohAbe,
    PlanarItohAbeAdjoint, PlanarItohAbePair, PlanarSplitting, PoissonSplitting,
};
#[doc(inline)]
pub use crate::method::flows::{
    FiveRotations, Nystrom, PositionVerlet, Splitting, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint,
};
#[doc(inline)]
pub use crate::method::gauss::{Gauss, ImplicitMidpoint};
#[doc(inline)]
pub use crate::method::kahan::Kahan;
#[doc(inline)]
pub use crate::method::tables::*;
#[doc(inline)]
pub use crate::taylor::{Taylor, TaylorFixed, TaylorOrder};
