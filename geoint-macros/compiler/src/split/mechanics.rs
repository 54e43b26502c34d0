//! H = T(p, t) + g(t)·s + V(q, t)? A kick and a drift, as mechanical systems have them.

use super::Clock;
use super::families::{damped, kinetic, prolongation};
use super::flow::{Flow, Group};
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id, Symbol};

/// A damped mechanical system: the flows of T and of V, one of which has the damping g·s.
#[derive(Clone, Debug)]
pub(crate) struct Mechanics {
    /// g; zero if nothing is damped.
    pub(crate) damping: Id,
    /// The flow of T, or of T + g·s, and its clock.
    pub(crate) drift: (Flow, Clock),
    /// The flow of V, or of V + g·s, at frozen time.
    pub(crate) kick: Flow,
    /// The flow of V alone at frozen time.
    pub(crate) free_kick: Flow,
    /// The flow of T alone at frozen time.
    pub(crate) free_drift: Flow,
    /// The flow of hV − g F·M⁻¹F; or why tables of Runge–Kutta–Nyström type have not their order: a term.
    pub(crate) gradient_kick: Result<Flow, Id>,
}

/// The parts; or a term that is in none of them.
pub(crate) fn mechanics(graph: &mut Graph, energy: Id, degrees: u32) -> Result<Mechanics, Id> {
    let (mut kinetic, mut damping, mut potential) = (graph.zero(), graph.zero(), graph.zero());
    for term in analyze::terms_where(graph, energy, |reads| reads.kinds() > 1 || reads.s) {
        let reads = graph.reads(term);
        let part = match (reads.q, reads.p, reads.s) {
            (_, false, false) => &mut potential,
            (false, true, false) => &mut kinetic,
            (false, false, true) => {
                let s = graph.symbol(Symbol::Action);
                let g = graph.div(term, s);
                if graph.reads(g).state() {
                    return Err(term);
                }
                damping = graph.add(damping, g);
                continue;
            }
            _ => return Err(term),
        };
        *part = graph.add(*part, term);
    }
    let group = |energy, clock| Group { energy, degrees, clock };
    let clocks = [Clock::Own, Clock::Stage];
    let free = |graph: &mut Graph, clock| Some((kinetic::free(graph, &group(kinetic, clock))?, clock));
    let free_kick = prolongation::solve(graph, &group(potential, Clock::Stage)).ok_or(potential)?;
    let (free_drift, _) = free(graph, Clock::Stage).ok_or(kinetic)?;
    let s = graph.symbol(Symbol::Action);
    let loss = graph.mul(damping, s);
    let with_damping = graph.add(kinetic, loss);
    let damped = |graph: &mut Graph, clock| Some((damped::drift(graph, &group(with_damping, clock))?, clock));
    // With a quadratic T: tables of Runge–Kutta–Nyström type keep their order. A damping that is zero is none.
    let drift = match graph.is_zero(damping) {
        true => clocks.into_iter().find_map(|clock| free(graph, clock)),
        false => clocks.into_iter().find_map(|clock| damped(graph, clock)),
    };
    let Some(drift) = drift else {
        // V + g·s has a flow for every V, and T may be any function of p.
        let drift = clocks.into_iter().find_map(|clock| free(graph, clock)).ok_or(kinetic)?;
        return Ok(Mechanics {
            damping,
            drift,
            kick: damped::kick(graph, potential, damping, degrees),
            free_kick,
            free_drift,
            gradient_kick: Err(with_damping),
        });
    };
    let frozen = (drift.1 == Clock::Stage).then_some(with_damping);
    let gradient_kick = match analyze::not_quadratic(graph, kinetic).or(frozen) {
        Some(term) => Err(term),
        None => Ok(gradient_kick(graph, kinetic, potential, degrees)),
    };
    Ok(Mechanics { damping, drift, kick: free_kick.clone(), free_kick, free_drift, gradient_kick })
}

/// The flow of hV − g F·M⁻¹F at frozen time.
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
