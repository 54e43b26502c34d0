//! Rayleigh's dissipation function R(q, v, t): the force −∂R/∂v, which is damping −Cv with C = ∂²R/∂v² where R is a quadratic form.

use super::mass::{is_velocity, masses};
use super::{Legendre, at_rest, kinks};
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id, Node, Symbol};

/// What a function is.
#[derive(Debug)]
pub(crate) enum Friction {
    /// vᵀCv/2.
    Damping(Vec<Vec<Id>>),
    /// No quadratic form: ∂R/∂v.
    Slopes(Vec<Id>),
}

/// Why a function is no friction.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NoFriction {
    /// It is a polynomial of an odd degree in them: it feeds one direction where it brakes the other.
    Odd,
    /// At rest ∂R/∂v is this, not zero.
    AtRest(Id),
    /// This ∂R/∂v has no value at rest.
    Kink(Id),
}

/// The force −∂R/∂v. Whether it takes energy at each velocity is found out at run time.
pub(crate) fn friction(graph: &mut Graph, rayleigh: Option<Id>, degrees: u32) -> Result<Option<Friction>, NoFriction> {
    let Some(rayleigh) = rayleigh else { return Ok(None) };
    let slopes = diff::gradient(graph, rayleigh, degrees).v;
    for slope in &slopes {
        if kinks::jumps(graph, *slope) || is_divided_at_rest(graph, *slope) {
            return Err(NoFriction::Kink(*slope));
        }
        let rest = at_rest(graph, *slope, |_| true);
        if !graph.is_zero(rest) && !analyze::identity(graph, rest).is_zero() {
            return Err(NoFriction::AtRest(rest));
        }
    }
    if analyze::is_polynomial_in(graph, &[rayleigh], 2, is_velocity) {
        let symbols: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
        return Ok(Some(Friction::Damping(masses(graph, &slopes, &symbols))));
    }
    match analyze::degree_in(graph, rayleigh, is_velocity) {
        Some(degree) if degree % 2 == 1 => Err(NoFriction::Odd),
        _ => Ok(Some(Friction::Slopes(slopes))),
    }
}

/// Whether a node is divided by what vanishes at rest, as v/|v| is.
fn is_divided_at_rest(graph: &mut Graph, slope: Id) -> bool {
    graph.reachable(&[slope]).into_iter().any(|id| {
        let Node::Power(base, exponent) = *graph.node(id) else { return false };
        exponent.numerator < 0 && graph.reads(base).v && {
            let rest = at_rest(graph, base, |_| true);
            graph.is_zero(rest)
        }
    })
}

/// γ with C = γM, where it reads no state and L has no terms that are linear in v: the force is −γp.
pub(crate) fn rate(graph: &mut Graph, damping: &[Vec<Id>], Legendre { mass, shift, .. }: &Legendre) -> Option<Id> {
    let n = mass.len();
    if !shift.iter().all(|a| graph.is_zero(*a)) {
        return None;
    }
    let (i, j) = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).find(|(i, j)| !graph.is_zero(mass[*i][*j]))?;
    let rate = graph.div(damping[i][j], mass[i][j]);
    let rate = super::invariant::simplified(graph, rate);
    if graph.is_zero(rate) || graph.reads(rate).state() {
        return None;
    }
    let entries = || (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let same = entries().all(|(i, j)| {
        let expected = graph.mul(rate, mass[i][j]);
        let rest = graph.sub(damping[i][j], expected);
        graph.is_zero(rest) || analyze::identity(graph, rest).is_zero()
    });
    same.then_some(rate)
}
