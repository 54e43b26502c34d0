//! Kernels of H = A + B: the flow of A, kicks by B, and the change to coordinates in which both are simple.

use super::kick_drift::{impulse, increments};
use crate::derive::system::{FlowKernel, Inner, Missing, Perturbed, grown};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};
use crate::messages::{JUMP_IS_NO_KICK, NOT_NYSTROM_EXACT};
use crate::schedule::{Levels, Output, Routine};
use crate::split::{self, Clock, Division, NoExactPart};

/// Derives the kernels of both parts.
pub(in crate::derive) fn kernels(graph: &mut Graph, division: &Division, degrees: u32) -> Result<Perturbed, Missing> {
    let parts = match division {
        Ok(parts) => parts,
        Err(NoExactPart { term, why }) => return Err(Missing::new("Parted", *term, why)),
    };
    let changed: Vec<(Symbol, Id)> =
        parts.flow.changed(graph).into_iter().filter(|(symbol, _)| *symbol != Symbol::Action).collect();
    let changed = split::steady(graph, changed);
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
    let flow = FlowKernel::with_increments(graph, Levels::Prepared, changed);
    let impulse = impulse(graph, parts.kick, degrees);
    let impulse = weighted(graph, parts, impulse);
    let flow_of_b = match &parts.jump {
        Some(jump) if jump.commutes => beside_jump(graph, jump, &impulse),
        Some(jump) => between_jumps(graph, jump, &impulse),
        None => increments(graph, Symbol::Momentum, &impulse),
    };
    Ok(Perturbed {
        a: parts.exact,
        b: rest,
        b_is_kick: parts.jump.is_none(),
        b_is_exact: parts.jump.as_ref().is_none_or(|jump| jump.commutes),
        own_motions: parts.parts.clone(),
        rules: parts.known.clone(),
        flow_of_a: flow,
        time_passes_in_a: parts.clock == Clock::Own,
        flow_of_b,
        kicks_repeat: parts.jump.is_none() && !graph.reads(parts.kick).t,
        gradient_kick,
        inner: parts.inner.as_ref().map(|inner| {
            let shares = Output::array("shares", &[inner.shares.len(), 2], inner.shares.concat());
            Inner {
                name: inner.name,
                enter: FlowKernel::new(Levels::One, inner.enter.clone()),
                leave: FlowKernel::new(Levels::One, inner.leave.clone()),
                shares: inner.shares.clone(),
                check_of_masses: Routine::new("unsuitable", vec![Output::row("masses", inner.masses.clone()), shares]),
            }
        }),
    })
}

/// Creates the flow of a jump and a kick that commute.
fn beside_jump(graph: &mut Graph, jump: &split::Jump, impulse: &[Id]) -> FlowKernel {
    let h = graph.symbol(Symbol::StepLength);
    let shifts: Vec<Id> = jump.velocity.iter().map(|velocity| graph.mul(h, *velocity)).collect();
    let shifts = (0..).map(Symbol::Position).zip(shifts);
    let ends = grown(graph, shifts.chain((0..).map(Symbol::Momentum).zip(impulse.iter().copied())));
    FlowKernel::with_increments(graph, Levels::Prepared, ends)
}

/// Creates a symmetric step: half of a jump, a kick, half of a jump.
fn between_jumps(graph: &mut Graph, jump: &split::Jump, impulse: &[Id]) -> FlowKernel {
    let h = graph.symbol(Symbol::StepLength);
    let half = graph.scale(Number::HALF, h);
    let shifts: Vec<Id> = jump.velocity.iter().map(|velocity| graph.mul(half, *velocity)).collect();
    let shifted = ends(graph, Symbol::Position, &shifts);
    let mut after_jump = Substitution::new(|_, symbol| match symbol {
        Symbol::Position(i) => Some(shifted[i as usize]),
        _ => None,
    });
    let impulse: Vec<Id> = impulse.iter().map(|impulse| after_jump.apply(graph, *impulse)).collect();
    let momenta = ends(graph, Symbol::Momentum, &impulse);
    let mut after_kick = Substitution::new(|_, symbol| match symbol {
        Symbol::Momentum(i) => Some(momenta[i as usize]),
        _ => None,
    });
    let mut both = |shift: &Id| {
        let last = after_kick.apply(graph, *shift);
        graph.add(*shift, last)
    };
    let shifts: Vec<Id> = shifts.iter().map(&mut both).collect();
    let positions = ends(graph, Symbol::Position, &shifts);
    let positions = (0..).map(Symbol::Position).zip(positions);
    let mut ends: Vec<(Symbol, Id)> = positions.chain((0..).map(Symbol::Momentum).zip(momenta)).collect();
    ends.retain(|(symbol, end)| *end != graph.symbol(*symbol));
    FlowKernel::with_increments(graph, Levels::Prepared, ends)
}

/// Returns x + increment for every coordinate x of one kind.
fn ends(graph: &mut Graph, coordinate: fn(u32) -> Symbol, increments: &[Id]) -> Vec<Id> {
    let mut end = |(symbol, increment): (Symbol, &Id)| {
        let start = graph.symbol(symbol);
        graph.add(start, *increment)
    };
    (0..).map(coordinate).zip(increments).map(&mut end).collect()
}

/// Returns the increments of the inner momenta by an impulse.
fn weighted(graph: &mut Graph, parts: &split::Perturbed, impulse: Vec<Id>) -> Vec<Id> {
    match &parts.inner {
        Some(inner) => impulse.into_iter().zip(&inner.weights).map(|(impulse, w)| graph.mul(*w, impulse)).collect(),
        None => impulse,
    }
}
