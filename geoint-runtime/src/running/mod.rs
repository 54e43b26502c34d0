//! Integration of a system: fixed and adaptive steps, Taylor series, dense output, events, and errors.

mod adaptive;
mod constraints;
mod dense;
mod error;
#[cfg(test)]
mod error_tests;
mod fixed;
#[cfg(feature = "alloc")]
mod named;
#[cfg(feature = "alloc")]
mod nearest;
mod number;
mod output;
mod pace;
mod reported;
mod into_integrator;
#[cfg(feature = "alloc")]
mod saved;
mod run;
mod settle;
mod step_size;
mod taylor;
mod tolerance;
mod trajectory;
mod watch;

pub use adaptive::{Adaptive, Controlled};
pub use constraints::state_on_constraint;
pub use dense::{
    Crossing, Crossings, Dense, Direction, SampledAt, SampledEvery, SeriesFunctions, StateFunctions, TaylorCrossings,
};
pub use error::StepError;
pub use fixed::{Fixed, Integrator};
pub use into_integrator::IntoIntegrator;
#[cfg(feature = "alloc")]
pub use named::{DynTrajectory, Named, UnknownMethod};
pub use run::Run;
#[cfg(feature = "alloc")]
use saved::Bits;
#[cfg(feature = "alloc")]
pub use saved::{FORMAT, Resumable, ResumeError, Saved};
pub use taylor::{Series, TaylorIntegrator};
pub use trajectory::{Samples, Scalar, StatesAt, Trajectory, Until};

pub use crate::method::proof::Given;
