//! Flows of pieces, one after the other and back.

mod contact;
mod driver;
mod flow;
mod increments;
mod methods;
mod planar_step;
mod splittings;
mod table;

pub use contact::ComposedContact;
pub use increments::{PlanarItohAbe, PlanarItohAbeAdjoint, PlanarItohAbePair};
pub use planar_step::planar_step;
pub use splittings::{
    ContactSplitting, ExactFlows, PieceSplitting, PlanarDiscreteGradient, PlanarSplitting, PoissonSplitting,
};
pub use table::{PieceComposition, PieceNystrom};
