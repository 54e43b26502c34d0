//! What the flow of an energy keeps, or lets decay by one factor.

mod dissipated;
mod generators;
mod momenta;
mod weights;

pub(crate) use dissipated::{Dissipated, dissipated};
pub(crate) use momenta::Momentum;
pub(super) use momenta::momenta;
