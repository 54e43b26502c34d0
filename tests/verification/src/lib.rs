//! Checks of the project that run no code of it: names of tests in pages, and imports between files.

mod expansion;
pub mod imports;
mod programs;
pub mod project;
pub mod sources;
pub mod statements;
