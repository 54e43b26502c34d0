//! The essential tests: one claim and one control of every method family and every attribute, refusals, saved runs, and messages.
//!
//! `cargo test` runs this program and the unit and documentation tests of both crates. The other packages in `tests` take every method, every
//! edge and every scalar type.

mod claim;
mod systems;

mod attributes;
mod contact;
mod energy;
mod orders;
mod structured;

mod messages;
mod refusals;
mod saved;
