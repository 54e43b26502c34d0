//! Rayleigh's dissipation function R(q, v, t): the force −∂R/∂v, which is damping −Cv with C = ∂²R/∂v² where R is a quadratic form.

use super::{at_rest, is_velocity, masses};
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id, Symbol};

/// Why a function is no quadratic form in the velocities.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NoFriction {
    /// It is not of degree 2 in them.
    Degree,
    /// At rest ∂R/∂v is this, not zero.
    AtRest(Id),
}

/// The matrix of damping.
pub(crate) fn friction(
    graph: &mut Graph,
    rayleigh: Option<Id>,
    degrees: u32,
) -> Result<Option<Vec<Vec<Id>>>, NoFriction> {
    let Some(rayleigh) = rayleigh else { return Ok(None) };
    if !analyze::is_polynomial_in(graph, &[rayleigh], 2, is_velocity) {
        return Err(NoFriction::Degree);
    }
    let slopes = diff::gradient(graph, rayleigh, degrees).v;
    for slope in &slopes {
        let rest = at_rest(graph, *slope, |_| true);
        if !graph.is_zero(rest) && !analyze::identity(graph, rest).is_zero() {
            return Err(NoFriction::AtRest(rest));
        }
    }
    let symbols: Vec<Symbol> = (0..degrees).map(Symbol::V).collect();
    Ok(Some(masses(graph, &slopes, &symbols)))
}
