//! Checks of the project that run none of it: names of tests in pages.

mod expansion;
mod programs;
pub mod project;
pub mod sources;
pub mod statements;
