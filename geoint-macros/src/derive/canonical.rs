//! What is derived from H(q, p, t).

use super::domain::{Domain, Roots};
use super::exact::{perturbed, pieces};
use super::implicit;
use super::jet::JetKernel;
use super::system::{FlowKernel, GradientKick, Implicit, KickDrift, Missing, Modified, System};
use crate::analyze::{Parts, Split, Structure, reads};
use crate::diff::{self, Gradient, modified};
use crate::ir::{Graph, Id, Number, Partial, Symbol};
use crate::messages::{COUPLED, COUPLED_IN_PIECES, DAMPED, FORCED, NO_CANONICAL_PIECES, NOT_QUADRATIC};
use crate::parse::Form;
use crate::schedule::{Kernel, Levels};
use crate::split::{Division, Pieces};

/// In so few degrees of freedom a kick with a force gradient is made of the kernel of implicit methods, whose derivative is hardly
/// more than the one direction that is needed of it: users do not pay for compiling another one.
const FEW: u32 = 3;

/// Derives everything that some method needs.
pub(crate) fn canonical(
    graph: &mut Graph,
    structure: &Structure,
    (division, pieces): (&Division, Option<&Pieces>),
    partial: &[Partial],
    degrees: u32,
) -> (System, Gradient) {
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let fields = implicit::field(graph, &gradient, structure, degrees);
    let some = |entry: &Id| !graph.is_zero(*entry);
    let drag = structure.damping.as_ref().and_then(|damping| damping.matrix.iter().flatten().copied().find(some));
    let forces = structure.forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]);
    let force = forces.flatten().flatten().copied().find(some);
    let drag = drag.map(|term| (term, DAMPED)).or(force.map(|term| (term, FORCED)));
    let perturbed = match drag {
        Some((term, why)) => Err(Missing { marker: "UndampedParts", term, why, pair: None }),
        None => perturbed::kernels(graph, division, degrees),
    };
    let separable = match (drag, &structure.split) {
        (Some((term, why)), _) => Err(Missing { marker: "Undamped", term, why, pair: None }),
        (None, Split::Coupled(term)) => {
            let why = if matches!(pieces, Some(Ok(_))) { COUPLED_IN_PIECES } else { COUPLED };
            Err(Missing { marker: "Uncoupled", term: *term, why, pair: None })
        }
        (None, Split::Separable(parts)) => Ok(parts),
    };
    let splitting = separable.map(|parts| kick_drift(graph, parts, (&fields.field.f, &gradient), partial));
    let modified = separable.ok().map(|parts| modified_energy(graph, structure, parts, &gradient));
    let rate = (!structure.conservative()).then(|| Kernel::new(Levels::One, fields.field.f.clone()));
    // Damping that depends on the state makes a field of a higher degree.
    let steady = structure.forces.is_none() && structure.damping.as_ref().is_none_or(|damping| !damping.reads.state());
    let proven = [
        (structure.conservative(), "Conservative"),
        (structure.conserves_energy(), "Autonomous"),
        (structure.degree.is_some_and(|degree| degree <= 3) && steady, "QuadraticField"),
        (matches!(pieces, Some(Ok(found)) if found.nystrom), "NystromPieces"),
    ];
    // Of an equation of second order, all there is of f.
    let force = &fields.field.f[fields.field.f.len() - degrees as usize..];
    let jet = JetKernel::canonical(graph, &gradient, force);
    let system = System {
        proven: proven.into_iter().filter(|(holds, _)| *holds).map(|(_, name)| name).collect(),
        value: Some(Kernel::new(Levels::One, vec![structure.energy])),
        slopes: Some(Kernel::new(Levels::One, [&gradient.q[..], &gradient.p].concat())),
        rate,
        splitting: Some(splitting),
        perturbed: Some(perturbed),
        modified,
        pieces: pieces
            .map(|pieces| pieces::kernels(graph, "PieceSplitting", (pieces, NO_CANONICAL_PIECES), false))
            .into_iter()
            .collect(),
        implicit: Implicit::Field(fields.kernels(graph, structure, degrees)),
        integrals: None,
        lagrangian: None,
        jet,
        domain: Domain::of(
            graph,
            Roots::of_energy(&structure.energy),
            Form::Hamiltonian,
            partial,
            structure.damping.as_ref(),
        ),
    };
    (system, gradient)
}

/// The flows of V and T by derivatives of −hV and hT, not −h and h times those of V and T: then h meets the constants of every term and
/// is prepared with them, instead of being multiplied to the sum.
fn kick_drift(
    graph: &mut Graph,
    parts: &Parts,
    (force, gradient): (&[Id], &Gradient),
    partial: &[Partial],
) -> KickDrift<Kernel> {
    let degrees = gradient.q.len() as u32;
    let impulse = scaled_gradient(graph, parts.potential, Number::MINUS_ONE, degrees);
    let shift = scaled_gradient(graph, parts.kinetic, Number::ONE, degrees);
    let kick = increments(graph, Symbol::P, &impulse.q);
    let drift = increments(graph, Symbol::Q, &shift.p);
    let gradient_kick = match parts.not_quadratic {
        None if degrees <= FEW => Ok(GradientKick::Collocation),
        None => {
            let kick = diff::gradient_kick(graph, parts.potential, force, &gradient.p);
            Ok(GradientKick::Flow(increments(graph, Symbol::P, &kick.impulse)))
        }
        Some(term) => Err(Missing { marker: "QuadraticIn", term, why: NOT_QUADRATIC, pair: None }),
    };
    let repeats = ![parts.kinetic, parts.potential].iter().any(|part| reads(graph, *part).t);
    let shows = repeats && super::domain::shows(graph, &impulse.q, partial);
    KickDrift { kick, drift, exact_in_time: false, repeats, shows, gradient_kick, undamped: None }
}

/// What the flow of V adds to the momenta.
pub(super) fn impulse(graph: &mut Graph, potential: Id, degrees: u32) -> Vec<Id> {
    scaled_gradient(graph, potential, Number::MINUS_ONE, degrees).q
}

fn scaled_gradient(graph: &mut Graph, part: Id, sign: Number, degrees: u32) -> Gradient {
    let h = graph.symbol(Symbol::H);
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
fn modified_energy(graph: &mut Graph, structure: &Structure, parts: &Parts, gradient: &Gradient) -> Modified<Kernel> {
    if structure.autonomous && parts.not_quadratic.is_none() {
        return Modified::Implicit;
    }
    let modified = modified::verlet(graph, parts, gradient);
    Modified::Value(Kernel::new(Levels::One, vec![modified]))
}
