//! The splittings, by what their pieces are.

use super::driver::{self, Splitting, splitting};
use crate::method::composition::substeps;
use crate::method::{Claims, Clock, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::Pieces;

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H, with a kick or else the most
/// expensive flow in the middle. Order 2, symmetric, a contact map; the flow of every piece but the last is applied twice a step.
///
/// Where the flow of a piece ends within a step, as that of H = s² does, the step is refused with the name of the piece.
/// A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactSplitting;

/// POISSON
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PoissonSplitting;

/// PLANAR
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarSplitting;

splitting!(ContactSplitting PoissonSplitting PlanarSplitting);
