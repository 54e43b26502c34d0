//! Kernels of splittings: the parts of H, or of x' = S ∇H, and their flows.
//!
//! - `kick_drift`: H = T + V.
//! - `perturbed`: H = A + B with a small B.
//! - `pieces`: any number of pieces of H(q, p) or H(q, p, s).
//! - `parts`: pieces of a field x' = S(x) ∇H, by terms of H, or by planes, in which two coordinates move. A plane without a known flow gets an
//!   implicit equation; all other flows are exact.

pub(super) mod kick_drift;
pub(super) mod parts;
pub(super) mod perturbed;
pub(super) mod pieces;
