//! Flows of pieces, one after the other and back.

mod driver;
mod splittings;
mod table;

pub use driver::Splitting;
pub use splittings::{ContactSplitting, PieceSplitting, PlanarSplitting, PoissonSplitting};
pub use table::{PieceComposition, PieceNystrom};
