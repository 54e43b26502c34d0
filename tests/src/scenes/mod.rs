//! Scenes beside those of the canonical problems: contact systems, constraints, flows, and energies of which q and p are coupled.

mod bodies;
mod constrained;
mod contact;
mod coupled;
mod flow;
mod integrals;

pub use bodies::*;
pub use constrained::*;
pub use contact::*;
pub use coupled::*;
pub use flow::*;
pub use integrals::*;
