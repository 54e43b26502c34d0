//! Systems written as Lagrangians. The tests check solutions to twenty digits, energies derived by hand, and laws.

#![allow(clippy::excessive_precision, reason = "digits as they are published")]

mod systems;
mod references;
mod orders;
mod energies;
mod explicit;
mod laws;
mod poles;
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
