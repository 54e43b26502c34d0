//! Rayleigh's dissipation function R(q, v, t). Its force −∂R/∂v is damping −Cv with C = ∂²R/∂v² if R is a quadratic form.

use super::idle_coordinates::without_idle_coordinates;
use super::mass::masses;
use super::{Legendre, at_rest, is_velocity, kinks};
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id, Node, Symbol};

/// Friction force derived from a Rayleigh function.
#[derive(Debug)]
pub(crate) enum Friction {
    /// The matrix C of R = vᵀCv/2.
    Damping(Vec<Vec<Id>>),
    /// ∂R/∂v of an R that is not a quadratic form.
    Slopes(Vec<Id>),
}

/// The reason why a function is not a Rayleigh function.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NoFriction {
    /// R is odd in the velocities, so it accelerates motion in one of the two directions.
    Odd,
    /// This component of ∂R/∂v is not zero at rest.
    AtRest(Id),
    /// This component of ∂R/∂v has no value at rest.
    Kink(Id),
}

/// Derives the force −∂R/∂v. Generated code checks at run time that the force takes energy.
pub(crate) fn friction(graph: &mut Graph, rayleigh: Option<Id>, degrees: u32) -> Result<Option<Friction>, NoFriction> {
    let Some(rayleigh) = rayleigh else { return Ok(None) };
    let slopes = diff::gradient(graph, rayleigh, degrees).v;
    for slope in &slopes {
        if kinks::jumps(graph, *slope) || is_divided_at_rest(graph, *slope) {
            return Err(NoFriction::Kink(*slope));
        }
        let rest = at_rest(graph, *slope);
        if !analyze::identity(graph, rest).is_zero() {
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

/// Returns whether a node has a divisor that vanishes at rest, such as v/|v|.
fn is_divided_at_rest(graph: &mut Graph, slope: Id) -> bool {
    graph.reachable(&[slope]).into_iter().any(|id| {
        let Node::Power(base, exponent) = *graph.node(id) else { return false };
        exponent.numerator < 0 && graph.reads(base).v && {
            let rest = at_rest(graph, base);
            graph.is_zero(rest)
        }
    })
}

/// Returns γ with C = γM, if γ reads no state and L has no terms that are linear in v. The force is then −γp.
pub(crate) fn rate(graph: &mut Graph, damping: &[Vec<Id>], Legendre { mass, shift, .. }: &Legendre) -> Option<Id> {
    if !shift.iter().all(|a| graph.is_zero(*a)) {
        return None;
    }
    let entries: Vec<(Id, Id)> = damping.concat().into_iter().zip(mass.concat()).collect();
    let (c, m) = entries.iter().find(|(_, m)| !graph.is_zero(*m))?;
    let rate = graph.div(*c, *m);
    let rate = without_idle_coordinates(graph, rate);
    if graph.is_zero(rate) || graph.reads(rate).state() {
        return None;
    }
    let same = entries.iter().all(|(c, m)| {
        let expected = graph.mul(rate, *m);
        let rest = graph.sub(*c, expected);
        analyze::identity(graph, rest).is_zero()
    });
    same.then_some(rate)
}
