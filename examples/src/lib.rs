//! What the example programs share: what a run costs, a place for output, tables for the terminal, figures.
//!
//! Everything that teaches how to use the library is in the programs themselves.

mod cost;
pub mod outer_planets;
mod output;
pub mod plot;
mod run;
mod table;

pub use cost::{evaluations, shortest};
pub use output::{claim, output, shown};
pub use run::{Sample, changes, largest, orbit, order};
pub use table::table;
