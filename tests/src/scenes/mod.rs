//! Scenes beside the canonical problems: contact systems, constraints, flows, and energies that couple q and p.

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
