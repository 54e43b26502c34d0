//! What was found of a flow x' = f(x, t), in words.

use super::super::damping::coefficients;
use super::super::kernel::Context;
use super::counted;
use super::field::{OfField, of_field};
use super::structure::{brackets, entries};
use crate::analyze::{self, Identity};
use crate::check::wording::proven;
use crate::derive::proof::Structure;
use crate::derive::{Flow, Implicit, MOST_UNKNOWNS, Named, Origin, System};
use crate::ir::{
    Graph, Id, Symbol,
    print::{Naming, Printer},
};
use crate::legendre::FirstOrder;
use crate::parse::Form;
use crate::schedule::Plan;
use std::fmt::{Result as Written, Write};

/// Why a flow keeps what it keeps.
#[derive(Clone, Copy)]
pub(crate) enum Source<'a> {
    /// S is skew.
    Structure(&'a Structure),
    /// It was proven of each function, or found.
    Field(OfField<'a>),
    /// S is the inverse of a skew matrix.
    Lagrangian(&'a FirstOrder),
}

/// The report.
pub(crate) fn flow(
    context: &Context<'_>,
    graph: &Graph,
    (flow, source): (&Flow, Source<'_>),
    system: &System<Plan>,
) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, context);
    // Writing to a string cannot fail.
    let _ = match source {
        Source::Lagrangian(found) => of_lagrangian(&mut text, &printer, found),
        Source::Structure(_) | Source::Field(_) => Ok(()),
    }
    .and_then(|()| equations(&mut text, context, &printer, flow))
    .and_then(|()| match source {
        Source::Structure(structure) => of_structure(&mut text, context, &printer, structure),
        Source::Field(field) => of_field(&mut text, context, &printer, field),
        Source::Lagrangian(found) => of_first_order(&mut text, context, &printer, found),
    })
    .and_then(|()| kept(&mut text, &printer, flow, source))
    .and_then(|()| operations(&mut text, flow, system))
    .and_then(|()| super::pieces::of_flow(&mut text, &printer, (system, split_by(flow, source))));
    text
}

/// What the function is called by whose gradient a flow is split.
fn split_by<'a>(flow: &'a Flow, source: Source<'_>) -> &'a str {
    match flow.first() {
        Some(Named { name, origin, .. }) if matches!(source, Source::Field(_)) && *origin != Origin::Energy => name,
        _ => "the energy",
    }
}

fn equations(text: &mut String, context: &Context<'_>, printer: &Printer<'_>, flow: &Flow) -> Written {
    if let Some((energy, _)) = flow.energy.as_ref().filter(|_| flow.form == Form::Structured) {
        writeln!(text, "H = {}", printer.formula(*energy))?;
    }
    (0..).zip(&flow.field).try_for_each(|(i, f)| {
        let name = context.name(Symbol::Position(i));
        writeln!(text, "{name}' = {}", printer.excerpt(*f))
    })
}

fn of_structure(text: &mut String, context: &Context<'_>, printer: &Printer<'_>, structure: &Structure) -> Written {
    writeln!(text, "\nStructure")?;
    writeln!(text, "- x' = S ∇H with skew S")?;
    brackets(text, context, printer, &structure.matrix)?;
    match &structure.poisson {
        Ok(()) => writeln!(text, "- a Poisson structure: Jacobi's identity holds"),
        Err(([i, j, k], verdict)) => {
            let rest = verdict.rest().map_or_else(String::new, |rest| format!(" leave {}", printer.excerpt(rest.rest)));
            let word = if matches!(verdict, Identity::Wrong(_)) { "not" } else { "not proven to be" };
            writeln!(text, "- {word} a Poisson structure: in Jacobi's identity indices ({i}, {j}, {k}){rest}")
        }
    }
}

/// L as it is understood.
fn of_lagrangian(text: &mut String, printer: &Printer<'_>, found: &FirstOrder) -> Written {
    writeln!(text, "L = {}", printer.formula(found.lagrangian))?;
    (0..).zip(&found.momenta).try_for_each(|(i, momentum)| {
        writeln!(text, "∂L/∂{} = {}", printer.named(Symbol::Velocity(i)), printer.excerpt(*momentum))
    })?;
    writeln!(text, "\nL is linear in the velocities, ϑ·v − H: the equations are Ω x' = ∇H, of first order")
}

fn of_first_order(text: &mut String, context: &Context<'_>, printer: &Printer<'_>, found: &FirstOrder) -> Written {
    writeln!(text, "\nStructure")?;
    for [i, j] in entries(printer.graph(), &found.form) {
        writeln!(text, "- Ω[{i}][{j}] = {}", printer.excerpt(found.form[i][j]))?;
    }
    writeln!(text, "- x' = S ∇H with S = Ω⁻¹, a Poisson structure because Ω = dϑ")?;
    brackets(text, context, printer, &found.structure)?;
    let Some(canonical) = &found.canonical else {
        return writeln!(
            text,
            "- no canonical coordinates: Ω vanishes on no half of the coordinates, or a change of gauge for it is not elementary; \
             `Gauss` and `ImplicitMidpoint` are those of x' = S ∇H, which are not symplectic"
        );
    };
    if !printer.graph().is_zero(canonical.gauge) {
        writeln!(text, "- gauge: ϑ + ∇f with f = {}", printer.excerpt(canonical.gauge))?;
    }
    for (place, position) in &canonical.replaced {
        let [place, position] = [place, position].map(|i| *i);
        writeln!(
            text,
            "- canonical coordinates: {} and, in the place of {}, {}",
            context.name(Symbol::Position(position)),
            context.name(Symbol::Position(place)),
            printer.excerpt(canonical.values[place as usize])
        )?;
    }
    writeln!(text, "- `Gauss` and `ImplicitMidpoint` are those of canonical coordinates: symplectic")
}

fn kept(text: &mut String, printer: &Printer<'_>, flow: &Flow, source: Source<'_>) -> Written {
    writeln!(text, "\nIntegrals")?;
    for (i, Named { name, conserved, origin }) in flow.kept.iter().enumerate() {
        let (graph, value) = (printer.graph(), printer.excerpt(conserved.value));
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
                let reads_time = printer.graph().reads(conserved.value).t;
                let but = if reads_time { "; by no projection, since it reads time" } else { "" };
                writeln!(text, "- {name}{value}: {word}{but}")?;
            }
            Some(b) => {
                let change = coefficients(printer, b);
                writeln!(text, "- {name}{value}, but for b·∇I with b = {change}: {word}")?;
            }
        }
    }
    for (value, is_casimir) in &flow.also {
        let word = if *is_casimir {
            "a Casimir; `FourthOrder` does not take it, because it is not defined wherever the field is"
        } else {
            "constant as well, not listed"
        };
        writeln!(text, "- {}: {word}", printer.excerpt(*value))?;
    }
    if flow.kept.is_empty() && flow.also.is_empty() {
        writeln!(text, "- none was listed, and none was found")?;
    }
    Ok(())
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

fn operations(text: &mut String, flow: &Flow, system: &System<Plan>) -> Written {
    writeln!(text, "\nOperations (a sine with its cosine counts as two)")?;
    if let Some(rate) = &system.rate {
        writeln!(text, "- x': {}", counted(rate.operations()))?;
    }
    let Implicit::Field(field) = &system.implicit else { return Ok(()) };
    writeln!(text, "- stage of a Newton iteration of collocation: {}", counted(field.collocation.operations()))?;
    if let Some(discrete) = &field.discrete {
        writeln!(text, "- Newton iteration of `DiscreteGradient`: {}", counted(discrete.operations()))?;
    }
    if let Some(fourth) = &field.fourth {
        writeln!(text, "- Newton iteration of `FourthOrder`: {}", counted(fourth.operations()))?;
    }
    writeln!(text, "\nImplicit steps")?;
    let n = flow.field.len();
    let solver = match n {
        1 => "Newton's iteration for one number".into(),
        2..=MOST_UNKNOWNS => "Newton's iteration with elimination".to_string(),
        _ => format!(
            "the fixed point while it attracts, Newton's iteration elsewhere: measured to be faster beyond {MOST_UNKNOWNS}"
        ),
    };
    writeln!(text, "- unknowns {n}: {solver}")?;
    if flow.kept.is_empty() {
        return Ok(());
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
            lines.iter().filter(|(names, _)| !names.is_empty()).try_for_each(|(_, line)| writeln!(text, "- {line}"))
        }
        _ if flow.kept.iter().any(|named| named.conserved.but.is_some()) => {
            writeln!(text, "- a step of `DiscreteGradient` takes h ∇̄H·C ∇̄H off the energy, to rounding")
        }
        _ if flow.kept.iter().any(|named| named.origin == Origin::Energy) => writeln!(
            text,
            "- `DiscreteGradient` keeps the energy to rounding, and every C(x) of degree 2 at most with S ∇C = 0; `FourthOrder` keeps {names}"
        ),
        // An energy that reads time is not among what is kept.
        _ => writeln!(
            text,
            "- `DiscreteGradient` keeps every C(x) of degree 2 at most with S ∇C = 0, to rounding; `FourthOrder` keeps {names}"
        ),
    }
}
