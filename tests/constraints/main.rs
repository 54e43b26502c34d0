//! Systems with constraints: against numbers of another program, against coordinates in which there are none, laws, and refusals.

#![allow(clippy::excessive_precision, reason = "digits as they are published")]

mod systems;
mod figures;
mod laws;
mod runs;
mod refusals;
