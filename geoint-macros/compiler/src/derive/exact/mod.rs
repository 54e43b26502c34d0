//! Parts of an energy with exact flows, in kernels.

pub(super) mod kick_drift;
pub(super) mod parts;
pub(super) mod perturbed;
pub(super) mod pieces;
