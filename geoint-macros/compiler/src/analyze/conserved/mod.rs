//! Functions that the flow of an energy conserves, or lets decay by one common factor.

mod dissipated;
mod generators;
mod momenta;
mod noether;
mod weights;

pub(crate) use dissipated::{Dissipated, decay, dissipated, dissipated_by_velocities, dissipated_on_constraints};
pub(crate) use momenta::Conserved;
pub(super) use momenta::momenta;
pub(crate) use noether::{noether, translations};
