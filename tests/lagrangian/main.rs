//! Systems that are written as Lagrangians: against solutions to twenty digits, against the energies that one derives by hand, and laws.

#![allow(clippy::excessive_precision, reason = "digits as they are published")]

mod systems;
mod references;
mod orders;
mod energies;
mod explicit;
mod laws;
mod noether;
mod velocities;
mod thesis;
mod degenerate;
mod forces;
mod herglotz;
mod decaying;
mod space;
mod statements;
mod singular;
