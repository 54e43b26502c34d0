//! What is derived from H(q, p, s, t).

use super::implicit;
use super::system::{FlowKernel, GradientKick, Implicit, KickDrift, Missing, Modified, PieceKernel, System, Undamped};
use crate::analyze;
use crate::diff::{self, Gradient};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};
use crate::messages::{NO_PIECES, NOT_MECHANICAL, NOT_NYSTROM};
use crate::schedule::{Kernel, Levels};
use crate::split::{self, Clock, Flow, Mechanics, Pieces};

/// Derives everything that some method needs. The momenta of a lift are not followed.
pub(crate) fn contact(
    graph: &mut Graph,
    energy: Id,
    (found, mechanics): (&Pieces, &Result<Mechanics, Id>),
    (degrees, lift): (u32, bool),
) -> System {
    let gradient = diff::gradient(graph, energy, degrees);
    let rates = rates(graph, energy, &gradient, lift);
    let pieces = match found {
        Ok(found) => Ok(found.iter().map(|piece| kernel(graph, piece, lift)).collect()),
        Err(term) => Err(Missing { marker: "Splits", term: *term, why: NO_PIECES }),
    };
    let modified = found.as_ref().ok().filter(|_| !lift).map(|pieces| {
        let modified = split::modified_energy(graph, pieces, degrees);
        Modified::Value(Kernel::new(Levels::One, vec![modified]))
    });
    let splitting = match mechanics {
        Ok(mechanics) => Ok(kick_drift(graph, mechanics)),
        Err(term) => Err(Missing { marker: "MechanicalIn", term: *term, why: NOT_MECHANICAL }),
    };
    // Positions and momenta move without s.
    let conformal = !analyze::reads(graph, gradient.s).state();
    System {
        energy,
        proven: if conformal { vec!["ConformalContact"] } else { vec![] },
        value: (!lift).then(|| Kernel::new(Levels::One, vec![energy])),
        slopes: Kernel::new(Levels::One, [&gradient.q[..], &gradient.p, &[gradient.s]].concat()),
        gradient,
        rate: Some(Kernel::new(Levels::One, rates)),
        splitting,
        modified,
        pieces: Some(pieces),
        implicit: Implicit::Contact(if lift { vec![] } else { implicit::steps(graph, energy, degrees) }),
    }
}

/// q', p' and s'. The momenta of a lift stand still, and are zero in s' = p·∂H/∂p − H, which has none.
fn rates(graph: &mut Graph, energy: Id, gradient: &Gradient, lift: bool) -> Vec<Id> {
    let zero = graph.zero();
    let momenta: Vec<Id> = (0..gradient.p.len() as u32).map(|i| graph.symbol(Symbol::P(i))).collect();
    let mut rates = gradient.p.clone();
    if lift {
        rates.extend(momenta.iter().map(|_| zero));
        let mut without =
            Substitution::new(|graph: &mut Graph, symbol| matches!(symbol, Symbol::P(_)).then(|| graph.zero()));
        let energy = without.apply(graph, energy);
        rates.push(graph.neg(energy));
        return rates;
    }
    let mut power = zero;
    for (p, (by_q, by_p)) in momenta.iter().zip(gradient.q.iter().zip(&gradient.p)) {
        let drag = graph.mul(*p, gradient.s);
        let loss = graph.add(*by_q, drag);
        rates.push(graph.neg(loss));
        let own = graph.mul(*p, *by_p);
        power = graph.add(power, own);
    }
    rates.push(graph.sub(power, energy));
    rates
}

fn kernel(graph: &mut Graph, piece: &split::Piece, lift: bool) -> PieceKernel<Kernel> {
    let mut changed = piece.flow.changed(graph);
    changed.retain(|(symbol, _)| !(lift && matches!(symbol, Symbol::P(_))));
    let flow = FlowKernel::with_increments(graph, piece.levels(), changed);
    PieceKernel { energy: piece.energy, family: piece.family, clock: piece.clock, flow }
}

fn kick_drift(graph: &mut Graph, mechanics: &Mechanics) -> KickDrift<Kernel> {
    let (drift, clock) = &mechanics.drift;
    let [kick, damped_drift] = [&mechanics.kick, drift].map(|flow| {
        let changed = flow.changed(graph);
        FlowKernel::with_increments(graph, Levels::Prepared, changed)
    });
    // Without damping flows add.
    let mut kernel = |flow: &Flow| FlowKernel::new(Levels::Prepared, flow.changed(graph));
    KickDrift {
        kick,
        drift: damped_drift,
        exact_in_time: *clock == Clock::Own,
        repeats: false,
        undamped: Some(Undamped {
            kick: (mechanics.free_kick != mechanics.kick).then(|| kernel(&mechanics.free_kick)),
            drift: (mechanics.free_drift != *drift).then(|| kernel(&mechanics.free_drift)),
            damping: Kernel::new(Levels::One, vec![mechanics.damping]),
        }),
        gradient_kick: match &mechanics.gradient_kick {
            Ok(flow) => Ok(GradientKick::Flow(kernel(flow))),
            Err(term) => Err(Missing { marker: "NystromIn", term: *term, why: NOT_NYSTROM }),
        },
    }
}
