//! Steps of any method, put right: projected to invariants, or lengthened until the energy is what it was.

pub mod invariants;
pub mod projection;
pub mod relaxation;

pub use invariants::{Energy, Invariants};
pub use projection::Projection;
pub use relaxation::Relaxation;
