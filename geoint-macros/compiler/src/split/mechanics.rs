//! Damped mechanical systems H = T(p, t) + g(t)·s + V(q, t), with flows for kick and drift.

use super::Clock;
use super::families::{damped, kinetic, prolongation};
use super::flow::{Flow, Group};
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id, Symbol};

/// The flows of T and V. One of them contains the damping g·s.
#[derive(Clone, Debug)]
pub(crate) struct Mechanics {
    /// g, or zero without damping.
    pub(crate) damping: Id,
    /// The flow of T or of T + g·s.
    pub(crate) drift: Flow,
    /// The clock of `drift`.
    pub(crate) clock: Clock,
    /// The flow of V or of V + g·s at frozen time.
    pub(crate) kick: Flow,
    /// The flow of V at frozen time.
    pub(crate) free_kick: Flow,
    /// The flow of T at frozen time.
    pub(crate) free_drift: Flow,
    /// The flow of hV − g F·M⁻¹F, or the term because of which tables of Runge–Kutta–Nyström type lose their order.
    pub(crate) gradient_kick: Result<Flow, Id>,
}

/// Returns the flows of a mechanical system, or a term that is neither in T, nor in V, nor a damping.
pub(crate) fn mechanics(graph: &mut Graph, energy: Id, degrees: u32) -> Result<Mechanics, Id> {
    let (mut kinetic, mut damping, mut potential) = (graph.zero(), graph.zero(), graph.zero());
    for term in analyze::terms_where(graph, energy, |reads| reads.kinds() > 1 || reads.s) {
        let reads = graph.reads(term);
        let part = match (reads.q, reads.p, reads.s) {
            (_, false, false) => &mut potential,
            (false, true, false) => &mut kinetic,
            (false, false, true) => {
                let g = analyze::decay_of(graph, term).ok_or(term)?;
                damping = graph.add(damping, g);
                continue;
            }
            _ => return Err(term),
        };
        *part = graph.add(*part, term);
    }
    let group = |energy, clock| Group { energy, degrees, clock };
    let free = |graph: &mut Graph, clock| kinetic::free(graph, &group(kinetic, clock));
    let free_kick = prolongation::solve(graph, &group(potential, Clock::Stage)).ok_or(potential)?;
    let free_drift = free(graph, Clock::Stage).ok_or(kinetic)?;
    let s = graph.symbol(Symbol::Action);
    let with_damping = graph.build(kinetic + damping * s);
    let undamped = graph.is_zero(damping);
    let drift = [Clock::Own, Clock::Stage].into_iter().find_map(|clock| {
        let flow = if undamped { free(graph, clock) } else { damped::drift(graph, &group(with_damping, clock)) };
        Some((flow?, clock))
    });
    // A drift with damping has a quadratic T. A kick with damping leaves T arbitrary, but tables of Nyström type lose their order.
    let Some((drift, clock)) = drift else {
        let exact = free(graph, Clock::Own).map(|drift| (drift, Clock::Own));
        let (drift, clock) = exact.unwrap_or_else(|| (free_drift.clone(), Clock::Stage));
        let kick = damped::kick(graph, potential, damping, degrees);
        let gradient_kick = Err(with_damping);
        return Ok(Mechanics { damping, drift, clock, kick, free_kick, free_drift, gradient_kick });
    };
    let frozen = (clock == Clock::Stage).then_some(with_damping);
    let gradient_kick = match analyze::not_quadratic(graph, kinetic).or(frozen) {
        Some(term) => Err(term),
        None => Ok(gradient_kick(graph, kinetic, potential, degrees)),
    };
    Ok(Mechanics { damping, drift, clock, kick: free_kick.clone(), free_kick, free_drift, gradient_kick })
}

/// Returns the flow of hV − g F·M⁻¹F at frozen time.
fn gradient_kick(graph: &mut Graph, kinetic: Id, potential: Id, degrees: u32) -> Flow {
    let velocity = diff::gradient(graph, kinetic, degrees).p;
    let slopes = diff::gradient(graph, potential, degrees).q;
    let force: Vec<Id> = slopes.iter().map(|slope| graph.neg(*slope)).collect();
    let kick = diff::gradient_kick(graph, potential, &force, &velocity);
    let mut flow = Flow::rest(graph, degrees);
    for (p, impulse) in flow.p.iter_mut().zip(kick.impulse) {
        *p = graph.add(*p, impulse);
    }
    flow.s = graph.sub(flow.s, kick.energy);
    flow
}
