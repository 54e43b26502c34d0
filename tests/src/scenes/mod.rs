//! Scenes beside those of the canonical problems: contact systems, constraints, flows, and energies of which q and p are coupled.

mod constrained;
mod contact;
mod coupled;
mod flow;

pub use constrained::*;
pub use contact::*;
pub use coupled::*;
pub use flow::*;
