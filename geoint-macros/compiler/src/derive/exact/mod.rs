//! Kernels of the parts of an energy with exact flows.

pub(super) mod kick_drift;
pub(super) mod parts;
pub(super) mod perturbed;
pub(super) mod pieces;
