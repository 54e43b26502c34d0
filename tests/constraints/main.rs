//! Systems with constraints. The tests compare steps with another program and with coordinates without constraints, and check laws and refusals.

#![allow(clippy::excessive_precision, reason = "digits as they are published")]

mod systems;
mod figures;
mod laws;
mod runs;
mod moving;
mod both;
mod action;
mod refusals;
mod rolling;
