//! Flows of pieces, one after the other and back.

mod driver;
mod increments;
mod splittings;
mod table;

pub use driver::Splitting;
pub use increments::{PlanarItohAbe, PlanarItohAbeAdjoint, PlanarItohAbePair};
pub use splittings::{ContactSplitting, PieceSplitting, PlanarDiscreteGradient, PlanarSplitting, PoissonSplitting};
pub use table::{PieceComposition, PieceNystrom};
