//! H = A + B in kernels: the flow of A, kicks by B, and the way into the coordinates in which both move, and out of them.

use super::kick_drift::{impulse, increments};
use crate::analyze::is_polynomial_in;
use crate::derive::system::{FlowKernel, Inner, Missing, Perturbed};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};
use crate::messages::{JUMP_IS_NO_KICK, NOT_NYSTROM_EXACT};
use crate::schedule::{Levels, Output, Routine};
use crate::split::{self, Clock, Division, NoExactPart};

/// Kernels of both parts.
pub(in crate::derive) fn kernels(graph: &mut Graph, division: &Division, degrees: u32) -> Result<Perturbed, Missing> {
    let parts = match division {
        Ok(parts) => parts,
        Err(NoExactPart { term, why }) => return Err(Missing::new("Parted", *term, why)),
    };
    let changed: Vec<(Symbol, Id)> =
        parts.flow.changed(graph).into_iter().filter(|(symbol, _)| *symbol != Symbol::Action).collect();
    let changed = split::steady(graph, changed);
    let after = after_kick(graph, &changed, degrees).filter(|_| parts.jump.is_none() && parts.inner.is_none());
    let gradient_kick = match &parts.velocity {
        Ok(velocity) => {
            let force: Vec<Id> =
                diff::gradient(graph, parts.kick, degrees).q.into_iter().map(|slope| graph.neg(slope)).collect();
            let kick = diff::gradient_kick(graph, parts.kick, &force, velocity);
            let impulse = weighted(graph, parts, kick.impulse);
            Ok(increments(graph, Symbol::Momentum, &impulse))
        }
        Err(term) => {
            let why = if parts.jump.is_some() { JUMP_IS_NO_KICK } else { NOT_NYSTROM_EXACT };
            Err(Missing::new("Gentle", *term, why))
        }
    };
    let rest = match &parts.jump {
        Some(jump) => graph.add(parts.kick, jump.energy),
        None => parts.kick,
    };
    Ok(Perturbed {
        exact: parts.exact,
        rest,
        is_kick: parts.jump.is_none(),
        is_exact: parts.jump.as_ref().is_none_or(|jump| jump.commutes),
        parts: parts.parts.clone(),
        known: parts.known.clone(),
        flow: FlowKernel::with_increments(graph, Levels::Prepared, changed),
        flow_after_kick: after,
        exact_in_time: parts.clock == Clock::Own,
        kick: {
            let impulse = impulse(graph, parts.kick, degrees);
            let impulse = weighted(graph, parts, impulse);
            match &parts.jump {
                Some(jump) if jump.commutes => beside_jump(graph, jump, &impulse),
                Some(jump) => between_jumps(graph, jump, &impulse),
                None => increments(graph, Symbol::Momentum, &impulse),
            }
        },
        repeats: parts.jump.is_none() && !graph.reads(parts.kick).t,
        gradient_kick,
        inner: parts.inner.as_ref().map(|inner| Inner {
            name: inner.name,
            enter: FlowKernel::new(Levels::One, inner.enter.clone()),
            leave: FlowKernel::new(Levels::One, inner.leave.clone()),
            shares: inner.shares.clone(),
            weighed: Routine::new(
                "unsuitable",
                vec![
                    Output::row("masses", inner.masses.clone()),
                    Output::array("shares", &[inner.shares.len(), 2], inner.shares.concat()),
                ],
            ),
        }),
    })
}

/// Where a linear flow ends after momenta have grown by Dp; nothing if its coefficients are not constant.
fn after_kick(graph: &mut Graph, changed: &[(Symbol, Id)], degrees: u32) -> Option<FlowKernel> {
    let momenta: Vec<Symbol> = (0..degrees).map(Symbol::Momentum).collect();
    let ends: Vec<(Symbol, Id)> = [Symbol::Position as fn(u32) -> Symbol, Symbol::Momentum]
        .into_iter()
        .flat_map(|of| (0..degrees).map(of))
        .map(|symbol| {
            let found = changed.iter().find(|(other, _)| *other == symbol);
            (symbol, found.map_or_else(|| graph.symbol(symbol), |(_, end)| *end))
        })
        .collect();
    let all: Vec<Id> = ends.iter().map(|(_, end)| *end).collect();
    if !is_polynomial_in(graph, &all, 1, Symbol::is_coordinate) {
        return None;
    }
    let weights = diff::jacobian(graph, &all, &momenta);
    let moves = |id: &Id| graph.reads(*id).moves();
    // With more than one momentum in an end the additional products cost what is not waited for.
    let coupled = weights.iter().any(|row| row.iter().filter(|weight| !graph.is_zero(**weight)).count() > 1);
    if coupled || weights.iter().flatten().any(moves) {
        return None;
    }
    let mut after = vec![];
    for ((symbol, end), weights) in ends.into_iter().zip(weights) {
        let mut terms = vec![end];
        for (i, weight) in (0..).zip(weights) {
            let grown = graph.symbol(Symbol::MomentumIncrement(i));
            terms.push(graph.mul(weight, grown));
        }
        after.push((symbol, graph.sum(&terms)));
    }
    Some(FlowKernel::new(Levels::Prepared, after))
}

/// A jump and a kick that leave each other as they are.
fn beside_jump(graph: &mut Graph, jump: &split::Jump, impulse: &[Id]) -> FlowKernel {
    let h = graph.symbol(Symbol::StepLength);
    let shifts: Vec<Id> = jump.velocity.iter().map(|velocity| graph.mul(h, *velocity)).collect();
    let indices = 0..shifts.len() as u32;
    let moved = indices
        .clone()
        .map(Symbol::Position)
        .zip(shifts)
        .chain(indices.map(Symbol::Momentum).zip(impulse.iter().copied()));
    let mut ends = vec![];
    for (symbol, increment) in moved.filter(|(_, increment)| !graph.is_zero(*increment)).collect::<Vec<_>>() {
        let start = graph.symbol(symbol);
        ends.push((symbol, graph.add(start, increment)));
    }
    FlowKernel::with_increments(graph, Levels::Prepared, ends)
}

/// Half of a jump, a kick, half of a jump.
fn between_jumps(graph: &mut Graph, jump: &split::Jump, impulse: &[Id]) -> FlowKernel {
    let indices = 0..impulse.len() as u32;
    let h = graph.symbol(Symbol::StepLength);
    let half = graph.scale(Number::HALF, h);
    let shifts: Vec<Id> = jump.velocity.iter().map(|velocity| graph.mul(half, *velocity)).collect();
    let start = |graph: &mut Graph, of: fn(u32) -> Symbol, i: u32| graph.symbol(of(i));
    let mut shifted = vec![];
    for (i, shift) in indices.clone().zip(&shifts) {
        let q = start(graph, Symbol::Position, i);
        shifted.push(graph.add(q, *shift));
    }
    let mut after_jump = Substitution::new(|_, symbol| match symbol {
        Symbol::Position(i) => Some(shifted[i as usize]),
        _ => None,
    });
    let impulse: Vec<Id> = impulse.iter().map(|impulse| after_jump.apply(graph, *impulse)).collect();
    let mut momenta = vec![];
    for (i, impulse) in indices.clone().zip(&impulse) {
        let p = start(graph, Symbol::Momentum, i);
        momenta.push(graph.add(p, *impulse));
    }
    let mut after_kick = Substitution::new(|_, symbol| match symbol {
        Symbol::Momentum(i) => Some(momenta[i as usize]),
        _ => None,
    });
    let mut ends = vec![];
    for (i, shift) in indices.clone().zip(&shifts) {
        let (q, last) = (start(graph, Symbol::Position, i), after_kick.apply(graph, *shift));
        let both = graph.add(*shift, last);
        ends.push((Symbol::Position(i), graph.add(q, both)));
    }
    ends.extend(indices.map(Symbol::Momentum).zip(momenta));
    ends.retain(|(symbol, end)| *end != graph.symbol(*symbol));
    FlowKernel::with_increments(graph, Levels::Prepared, ends)
}

/// What an impulse adds to what is in the place of momenta.
fn weighted(graph: &mut Graph, parts: &split::Perturbed, impulse: Vec<Id>) -> Vec<Id> {
    match &parts.inner {
        Some(inner) => impulse.into_iter().zip(&inner.weights).map(|(impulse, w)| graph.mul(*w, impulse)).collect(),
        None => impulse,
    }
}
