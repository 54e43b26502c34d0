//! Shared code of the example programs: cost of a run, output files, tables for the terminal, figures.
//!
//! The programs themselves contain all code that shows how to use the library.

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
