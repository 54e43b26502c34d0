//! Kicks and drifts in kernels, and the energy that steps of them keep up to h⁴.

use crate::analyze::{Parts, Structure};
use crate::derive::domain;
use crate::derive::system::{FlowKernel, GradientKick, KickDrift, Missing, Modified};
use crate::diff::{self, Gradient, modified};
use crate::ir::{Graph, Id, Number, Symbol, UndefinedAt};
use crate::messages::NOT_QUADRATIC;
use crate::schedule::{Levels, Routine};

/// In so few degrees of freedom a kick with a force gradient is made of the kernel of implicit methods, whose derivative is hardly
/// more than the one direction that is needed of it: users do not pay for compiling another one.
const FEW: u32 = 3;

/// The flows of V and T by derivatives of −hV and hT, not −h and h times those of V and T: then h meets the constants of every term and
/// is prepared with them, instead of being multiplied to the sum.
pub(in crate::derive) fn kick_drift(
    graph: &mut Graph,
    parts: &Parts,
    force: &[Id],
    gradient: &Gradient,
    partial: &[UndefinedAt],
) -> KickDrift {
    let degrees = gradient.q.len() as u32;
    let impulse = scaled_gradient(graph, parts.potential, Number::MINUS_ONE, degrees);
    let shift = scaled_gradient(graph, parts.kinetic, Number::ONE, degrees);
    let kick = increments(graph, Symbol::Momentum, &impulse.q);
    let drift = increments(graph, Symbol::Position, &shift.p);
    let gradient_kick = match parts.not_quadratic {
        None if degrees <= FEW => Ok(GradientKick::Collocation),
        None => {
            let kick = diff::gradient_kick(graph, parts.potential, force, &gradient.p);
            Ok(GradientKick::Flow(increments(graph, Symbol::Momentum, &kick.impulse)))
        }
        Some(term) => Err(Missing::new("QuadraticIn", term, NOT_QUADRATIC)),
    };
    let repeats = ![parts.kinetic, parts.potential].iter().any(|part| graph.reads(*part).t);
    let shows = repeats && domain::shows(graph, &impulse.q, partial);
    KickDrift { kick, drift, exact_in_time: false, repeats, shows, gradient_kick, undamped: None }
}

/// What the flow of V adds to the momenta.
pub(super) fn impulse(graph: &mut Graph, potential: Id, degrees: u32) -> Vec<Id> {
    scaled_gradient(graph, potential, Number::MINUS_ONE, degrees).q
}

fn scaled_gradient(graph: &mut Graph, part: Id, sign: Number, degrees: u32) -> Gradient {
    let h = graph.symbol(Symbol::StepLength);
    let generator = graph.mul(h, part);
    let generator = graph.scale(sign, generator);
    diff::gradient(graph, generator, degrees)
}

/// x ← x + increment. An increment is summed before it is added: x is rounded once.
pub(super) fn increments(graph: &mut Graph, coordinate: fn(u32) -> Symbol, increments: &[Id]) -> FlowKernel {
    let mut ends = vec![];
    for (coordinate, increment) in (0..).map(coordinate).zip(increments) {
        if !graph.is_zero(*increment) {
            let start = graph.symbol(coordinate);
            ends.push((coordinate, graph.add(start, *increment)));
        }
    }
    FlowKernel::new(Levels::Prepared, ends)
}

/// The energy that steps of Störmer and Verlet keep up to h⁴: in closed form, or where nothing reads time by the kernels of implicit
/// methods, which costs users no time to compile.
pub(in crate::derive) fn modified_energy(
    graph: &mut Graph,
    structure: &Structure,
    parts: &Parts,
    gradient: &Gradient,
) -> Modified {
    if structure.autonomous && parts.not_quadratic.is_none() {
        return Modified::Implicit;
    }
    let modified = modified::verlet(graph, parts, gradient);
    Modified::Value(Routine::number("modified", modified))
}
