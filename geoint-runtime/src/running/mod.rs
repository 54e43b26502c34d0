//! A system under a method: fixed steps, steps that adapt, what they return, and why they stop.

mod adaptive;
mod error;
mod integrator;
mod run;
mod step_size;
mod watch;

pub use adaptive::{Adaptive, Until};
pub use error::{Reason, StepError};
pub use integrator::{Integrator, Samples};
pub use run::Run;
