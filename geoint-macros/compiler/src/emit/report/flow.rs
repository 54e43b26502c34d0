//! Facts about a flow x' = f(x, t), in words.

use super::field::of_field;
use super::structure::{brackets, entries};
use super::{Report, counted, pieces};
use crate::analyze::{self, Identity};
use crate::check::wording::proven;
use crate::derive::proof::Structure;
use crate::derive::{Constant, Flow, Kernels, MOST_UNKNOWNS, Named, Origin, Source, System};
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::FirstOrder;
use crate::parse::Form;

pub(super) fn report(report: &mut Report<'_>, flow: &Flow, source: &Source, system: &System) {
    if let Source::Lagrangian(found) = source {
        of_lagrangian(report, found);
    }
    equations(report, flow);
    match source {
        Source::Structure(structure) => of_structure(report, structure),
        Source::Field(field) => of_field(report, field),
        Source::Lagrangian(found) => of_first_order(report, found),
    }
    kept(report, flow, source);
    operations(report, flow, system);
    pieces::of_flow(report, system, split_by(flow, source));
}

/// What the function is called by whose gradient a flow is split.
fn split_by<'a>(flow: &'a Flow, source: &Source) -> &'a str {
    match flow.first() {
        Some(Named { name, origin, .. }) if matches!(source, Source::Field(_)) && *origin != Origin::Energy => name,
        _ => "the energy",
    }
}

fn equations(report: &mut Report<'_>, flow: &Flow) {
    if let Some((energy, _)) = flow.energy.as_ref().filter(|_| flow.form == Form::Structured) {
        writeln!(report, "H = {}", report.formula(*energy));
    }
    for (i, f) in (0..).zip(&flow.field) {
        writeln!(report, "{}' = {}", report.named(Symbol::Position(i)), report.excerpt(*f));
    }
}

fn of_structure(report: &mut Report<'_>, structure: &Structure) {
    writeln!(report, "\nStructure");
    writeln!(report, "- x' = S ∇H with skew S");
    brackets(report, &structure.matrix);
    match &structure.poisson {
        Ok(()) => writeln!(report, "- a Poisson structure: Jacobi's identity holds"),
        Err(([i, j, k], verdict)) => {
            let rest = verdict.rest().map_or_else(String::new, |rest| format!(" leave {}", report.excerpt(rest.rest)));
            let word = if matches!(verdict, Identity::Wrong(_)) { "not" } else { "not proven to be" };
            writeln!(report, "- {word} a Poisson structure: in Jacobi's identity indices ({i}, {j}, {k}){rest}")
        }
    }
}

/// L as it is understood.
fn of_lagrangian(report: &mut Report<'_>, found: &FirstOrder) {
    writeln!(report, "L = {}", report.formula(found.lagrangian));
    for (i, momentum) in (0..).zip(&found.momenta) {
        writeln!(report, "∂L/∂{} = {}", report.named(Symbol::Velocity(i)), report.excerpt(*momentum));
    }
    writeln!(report, "\nL is linear in the velocities, ϑ·v − H: the equations are Ω x' = ∇H, of first order")
}

fn of_first_order(report: &mut Report<'_>, found: &FirstOrder) {
    writeln!(report, "\nStructure");
    for [i, j] in entries(report.graph(), &found.form) {
        writeln!(report, "- Ω[{i}][{j}] = {}", report.excerpt(found.form[i][j]));
    }
    writeln!(report, "- x' = S ∇H with S = Ω⁻¹, a Poisson structure because Ω = dϑ");
    brackets(report, &found.structure);
    let Some(canonical) = &found.canonical else {
        return writeln!(
            report,
            "- no canonical coordinates: Ω vanishes on no half of the coordinates, or a change of gauge for it is not elementary; \
             `Gauss` and `ImplicitMidpoint` are those of x' = S ∇H, which are not symplectic"
        );
    };
    if !report.graph().is_zero(canonical.gauge) {
        writeln!(report, "- gauge: ϑ + ∇f with f = {}", report.excerpt(canonical.gauge));
    }
    for (place, position) in &canonical.replaced {
        let [place, position] = [place, position].map(|i| *i);
        writeln!(
            report,
            "- canonical coordinates: {} and, in the place of {}, {}",
            report.named(Symbol::Position(position)),
            report.named(Symbol::Position(place)),
            report.excerpt(canonical.values[place as usize])
        );
    }
    writeln!(report, "- `Gauss` and `ImplicitMidpoint` are those of canonical coordinates: symplectic")
}

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
            (Origin::Energy, _) => "kept, because S is skew".into(),
            (Origin::Assumed, _) | (Origin::Listed, _) => "assumed".into(),
        };
        let name = if *origin == Origin::Found { String::new() } else { format!("{name} = ") };
        match &conserved.but {
            None => {
                let reads_time = report.graph().reads(conserved.value).t;
                let but = if reads_time { "; by no projection, since it reads time" } else { "" };
                writeln!(report, "- {name}{value}: {word}{but}");
            }
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

/// What an angle does where it comes round.
fn turns(graph: &Graph, function: Id) -> &'static str {
    if !analyze::turning_terms(graph, function).is_empty() { ", but for turns of `atan2` by 2π" } else { "" }
}

/// How it was proven that a function is kept.
fn how(verdict: &Identity) -> String {
    match verdict {
        Identity::Zero(proof) => format!("kept, {}", proven(*proof, "kept")),
        _ => "assumed".into(),
    }
}

fn operations(report: &mut Report<'_>, flow: &Flow, system: &System) {
    writeln!(report, "\nOperations (a sine with its cosine counts as two)");
    if let Some(rate) = &system.rate {
        writeln!(report, "- x': {}", counted(rate.operations()));
    }
    let Kernels::Field(field) = &system.kernels else { return };
    writeln!(
        report,
        "- stage of a Newton iteration of collocation: {}",
        counted(field.collocation.kernel.operations())
    );
    if let Some(discrete) = &field.discrete {
        writeln!(report, "- Newton iteration of `DiscreteGradient`: {}", counted(discrete.operations()));
    }
    if let Some(fourth) = &field.fourth {
        writeln!(report, "- Newton iteration of `FourthOrder`: {}", counted(fourth.operations()));
    }
    writeln!(report, "\nImplicit steps");
    let n = flow.field.len();
    let solver = match n {
        1 => "Newton's iteration for one number".into(),
        2..=MOST_UNKNOWNS => "Newton's iteration with elimination".to_string(),
        _ => format!(
            "the fixed point while it attracts, Newton's iteration elsewhere: measured to be faster beyond {MOST_UNKNOWNS}"
        ),
    };
    writeln!(report, "- unknowns {n}: {solver}");
    if flow.kept.is_empty() {
        return;
    }
    let list = |origin: fn(Origin) -> bool, changes: bool| {
        let belongs = |named: &&Named| origin(named.origin) && named.conserved.but.is_some() == changes;
        flow.kept.iter().filter(belongs).map(|named| named.name.as_str()).collect::<Vec<&str>>().join(", ")
    };
    let names = list(|origin| origin != Origin::Assumed, false);
    match flow.form {
        Form::Field => {
            let of = "`DiscreteGradient` and `FourthOrder`";
            let (assumed, changed) = (list(|origin| origin == Origin::Assumed, false), list(|_| true, true));
            let lines = [
                (&names, format!("{of} keep {names}, to rounding")),
                (
                    &assumed,
                    format!("{of} stay where they start on levels of {assumed}, which the flow is assumed to do"),
                ),
                (&changed, format!("steps of {of} change {changed} by h times the mean of b·∇I, to rounding")),
            ];
            for (_, line) in lines.iter().filter(|(names, _)| !names.is_empty()) {
                writeln!(report, "- {line}");
            }
        }
        _ if flow.kept.iter().any(|named| named.conserved.but.is_some()) => {
            writeln!(report, "- a step of `DiscreteGradient` takes h ∇̄H·C ∇̄H off the energy, to rounding")
        }
        _ if flow.kept.iter().any(|named| named.origin == Origin::Energy) => writeln!(
            report,
            "- `DiscreteGradient` keeps the energy to rounding, and every C(x) of degree 2 at most with S ∇C = 0; `FourthOrder` keeps {names}"
        ),
        // An energy that reads time is not among what is kept.
        _ => writeln!(
            report,
            "- `DiscreteGradient` keeps every C(x) of degree 2 at most with S ∇C = 0, to rounding; `FourthOrder` keeps {names}"
        ),
    }
}
