//! Kernels of kick and drift, and the energy that their steps keep up to h⁴.

use crate::analyze::{Parts, Structure};
use crate::derive::domain;
use crate::derive::system::{FlowKernel, GradientKick, KickDrift, Missing, Modified, grown};
use crate::diff::{self, Gradient, modified};
use crate::ir::{Graph, Id, Number, Symbol, UndefinedAt};
use crate::messages::NOT_QUADRATIC;
use crate::schedule::{Levels, Routine};

/// The largest number of degrees of freedom in which a kick with a force gradient uses the derivative from the kernel of implicit methods. In so few
/// degrees of freedom, a kernel of the directional derivative alone would hardly be shorter, and users would have to compile it.
const FEW: u32 = 3;

/// Derives the flows of V and T from the derivatives of −hV and hT. The factor h thus meets the constants of every term, and is prepared with them.
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
    let kicks_repeat = ![parts.kinetic, parts.potential].iter().any(|part| graph.reads(*part).t);
    let kicks_show = kicks_repeat && domain::shows(graph, &impulse.q, partial);
    KickDrift { kick, drift, time_passes_in_drift: false, kicks_repeat, kicks_show, gradient_kick, undamped: None }
}

/// Returns the increments of momenta in the flow of V.
pub(super) fn impulse(graph: &mut Graph, potential: Id, degrees: u32) -> Vec<Id> {
    scaled_gradient(graph, potential, Number::MINUS_ONE, degrees).q
}

/// Returns the gradient of ±h times a part of the energy.
fn scaled_gradient(graph: &mut Graph, part: Id, sign: Number, degrees: u32) -> Gradient {
    let h = graph.symbol(Symbol::StepLength);
    let generator = graph.mul(h, part);
    let generator = graph.scale(sign, generator);
    diff::gradient(graph, generator, degrees)
}

/// Creates the flow x ← x + increment.
pub(super) fn increments(graph: &mut Graph, coordinate: fn(u32) -> Symbol, increments: &[Id]) -> FlowKernel {
    let increments = (0..).map(coordinate).zip(increments.iter().copied());
    FlowKernel::new(Levels::Prepared, grown(graph, increments))
}

/// Derives the energy that steps of Störmer and Verlet keep up to h⁴. If T is quadratic and no part reads time, the kernels of implicit methods can
/// compute it, and no other code has to be compiled.
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
