//! Reports a flow x' = f(x, t).

use super::{Report, entropy, field, pieces, solver, structure};
use crate::analyze::{self, Identity};
use crate::check::wording::{commas, proven};
use crate::derive::{Constant, Flow, Kernels, Named, Origin, Source, System};
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::FirstOrder;
use crate::parse::Form;

/// Reports the equations, the structure, integrals, costs and pieces.
pub(super) fn report(report: &mut Report<'_>, flow: &Flow, source: &Source, system: &System) {
    if let Source::Lagrangian(found) = source {
        of_lagrangian(report, found);
    }
    equations(report, flow);
    match source {
        Source::Structure(given) => structure::given(report, given, flow.entropy.as_ref()),
        Source::Field(findings) => field::report(report, findings),
        Source::Lagrangian(found) => structure::of_lagrangian(report, found),
    }
    kept(report, flow, source);
    operations(report, flow, system);
    pieces::of_flow(report, system, split_by(flow, source));
}

/// Returns the name of the function I in the splitting of x' = S ∇I.
fn split_by<'a>(flow: &'a Flow, source: &Source) -> &'a str {
    match flow.first() {
        Some(Named { name, origin, .. }) if matches!(source, Source::Field(_)) && *origin != Origin::Energy => name,
        _ => "the energy",
    }
}

/// Writes H, if the user gave an energy, and x' = f(x, t).
fn equations(report: &mut Report<'_>, flow: &Flow) {
    if let Some((energy, _)) = flow.energy.as_ref().filter(|_| flow.form == Form::Structured) {
        match &flow.entropy {
            Some(step) => writeln!(report, "E = {}\nS = {}", report.formula(*energy), report.formula(step.entropy)),
            None => writeln!(report, "H = {}", report.formula(*energy)),
        }
    }
    for (i, f) in (0..).zip(&flow.field) {
        writeln!(report, "{}' = {}", report.named(Symbol::Position(i)), report.excerpt(*f));
    }
}

/// Writes L and its momenta ϑ.
fn of_lagrangian(report: &mut Report<'_>, found: &FirstOrder) {
    writeln!(report, "L = {}", report.formula(found.lagrangian));
    report.derivatives("L", Symbol::Velocity, &found.momenta, Report::excerpt);
    writeln!(report, "\nL is linear in the velocities, ϑ·v − H: the equations are Ω x' = ∇H, of first order")
}

/// Reports the integrals, each with its proof or origin.
fn kept(report: &mut Report<'_>, flow: &Flow, source: &Source) {
    writeln!(report, "\nIntegrals");
    for (i, Named { name, conserved, origin }) in flow.kept.iter().enumerate() {
        let (graph, value) = (report.graph(), report.excerpt(conserved.value));
        let word = match (origin, source) {
            (Origin::Listed, Source::Field(field)) => {
                format!("{}{}", how(&field.proofs.kept[i]), turns(graph, conserved.value))
            }
            (Origin::Found, Source::Structure(_)) => "kept, a Casimir: S times its gradient is 0".into(),
            (Origin::Found, _) => "kept, found: a projection onto others alone would lose it".into(),
            (Origin::Energy, Source::Field(_)) => {
                format!("kept, the energy of the field{}", turns(graph, conserved.value))
            }
            (Origin::Energy, _) if flow.entropy.is_some() => "kept, because L is skew and M ∇E = 0".into(),
            (Origin::Energy, _) => "kept, because S is skew".into(),
            (Origin::Entropy, _) => "rises by ∇S·M ∇S ≥ 0, because L ∇S = 0".into(),
            (Origin::Assumed, _) | (Origin::Listed, _) => "assumed".into(),
        };
        let name = if *origin == Origin::Found { String::new() } else { format!("{name} = ") };
        match &conserved.but {
            None => {
                let but = if graph.reads(conserved.value).t { "; by no projection, since it reads time" } else { "" };
                writeln!(report, "- {name}{value}: {word}{but}");
            }
            Some(_) if *origin == Origin::Entropy => writeln!(report, "- {name}{value}: {word}"),
            Some(b) => {
                let change = report.vector(b);
                writeln!(report, "- {name}{value}, but for b·∇I with b = {change}: {word}");
            }
        }
    }
    for Constant { value, is_casimir } in &flow.also {
        let word = if *is_casimir {
            "a Casimir; `FourthOrder` does not take it, because it is not defined wherever the field is"
        } else {
            "constant as well, not listed"
        };
        writeln!(report, "- {}: {word}", report.excerpt(*value));
    }
    if flow.kept.is_empty() && flow.also.is_empty() {
        writeln!(report, "- none was listed, and none was found");
    }
}

/// Returns an exception for functions that jump by full turns of an angle.
fn turns(graph: &Graph, function: Id) -> &'static str {
    if !analyze::turning_terms(graph, function).is_empty() { ", but for turns of `atan2` by 2π" } else { "" }
}

/// Returns the proof that a field keeps a function, or states that the user answers for it.
fn how(verdict: &Identity) -> String {
    match verdict {
        Identity::Zero(proof) => format!("kept, {}", proven(*proof, "kept")),
        _ => "assumed".into(),
    }
}

/// Reports the costs of rates and implicit steps, the solver, and the integrals that discrete gradients keep.
fn operations(report: &mut Report<'_>, flow: &Flow, system: &System) {
    writeln!(report, "\nOperations (a sine with its cosine counts as two)");
    if let Some(rate) = &system.rate {
        writeln!(report, "- x': {}", rate.operations());
    }
    let Kernels::Field(field) = &system.kernels else { return };
    writeln!(report, "- stage of a Newton iteration of collocation: {}", field.collocation.kernel.operations());
    if let Some(discrete) = &field.discrete {
        writeln!(report, "- Newton iteration of `DiscreteGradient`: {}", discrete.operations());
    }
    if let Some(fourth) = &field.fourth {
        writeln!(report, "- Newton iteration of `FourthOrder`: {}", fourth.operations());
    }
    let n = flow.field.len();
    writeln!(report, "\nImplicit steps\n- unknowns {n}: {}", solver(n));
    if !flow.kept.is_empty() {
        kept_by_steps(report, flow);
    }
}

/// Reports the integrals that discrete gradients keep. Precondition: the flow has one.
fn kept_by_steps(report: &mut Report<'_>, flow: &Flow) {
    let names = |belongs: fn(&Named) -> bool| {
        commas(flow.kept.iter().filter(|named| belongs(named)).map(|named| named.name.clone()))
    };
    let kept = names(|named| named.conserved.but.is_none() && named.origin != Origin::Assumed);
    let assumed = names(|named| named.conserved.but.is_none() && named.origin == Origin::Assumed);
    let changed = names(|named| named.conserved.but.is_some());
    let methods = "`DiscreteGradient` and `FourthOrder`";
    if let Some(step) = &flow.entropy {
        entropy::step(report, step);
    } else if flow.form == Form::Field {
        if !kept.is_empty() {
            writeln!(report, "- {methods} keep {kept}, to rounding");
        }
        if !assumed.is_empty() {
            writeln!(
                report,
                "- {methods} stay where they start on levels of {assumed}, which the flow is assumed to do"
            );
        }
        if !changed.is_empty() {
            writeln!(report, "- steps of {methods} change {changed} by h times the mean of b·∇I, to rounding");
        }
    } else if !changed.is_empty() {
        writeln!(report, "- a step of `DiscreteGradient` takes h ∇̄H·C ∇̄H off the energy, to rounding")
    } else if flow.kept.iter().any(|named| named.origin == Origin::Energy) {
        writeln!(
            report,
            "- `DiscreteGradient` keeps the energy to rounding, and every C(x) of degree 2 at most with S ∇C = 0; `FourthOrder` keeps {kept}"
        )
    } else {
        // The flow does not keep an energy that reads time.
        writeln!(
            report,
            "- `DiscreteGradient` keeps every C(x) of degree 2 at most with S ∇C = 0, to rounding; `FourthOrder` keeps {kept}"
        )
    }
}
