//! What was found of H(q, p, t) with constraints, in words.

use super::super::damping;
use super::super::kernel::Context;
use super::counted;
use crate::analyze::Structure;
use crate::derive::{Implicit, System};
use crate::diff::Gradient;
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::parse::Role;
use crate::schedule::Plan;
use std::fmt::{Result as Written, Write};

/// The report; `kept` are facts of H and the constraints together.
pub(crate) fn constraints(
    context: &Context<'_>,
    graph: &Graph,
    (structure, kept): (&Structure, &Structure),
    constraints: &[Id],
    (system, gradient): (&System<Plan>, &Gradient),
) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, context);
    // Writing to a string cannot fail.
    let _ = sections(&mut text, context, &printer, structure, constraints, gradient)
        .and_then(|()| conserved(&mut text, &printer, kept))
        .and_then(|()| steps(&mut text, structure, system));
    text
}

fn sections(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_>,
    structure: &Structure,
    constraints: &[Id],
    gradient: &Gradient,
) -> Written {
    let (q, p) = (context.name_of(Role::Position), context.name_of(Role::Momentum));
    writeln!(text, "H = {}", printer.formula(structure.energy))?;
    for (symbol, slopes) in [(Symbol::Position as fn(u32) -> Symbol, &gradient.q), (Symbol::Momentum, &gradient.p)] {
        for (i, slope) in (0..).zip(slopes) {
            writeln!(text, "∂H/∂{} = {}", printer.named(symbol(i)), printer.excerpt(*slope))?;
        }
    }
    writeln!(text, "\nConstraints: {p}' = −∂H/∂{q} − Gᵀλ with G = ∂g/∂{q}")?;
    for constraint in constraints {
        writeln!(text, "- 0 = {}", printer.excerpt(*constraint))?;
    }
    let (n, m) = (gradient.q.len(), constraints.len());
    writeln!(text, "- {n} coordinates and {m} constraint{}: {} of freedom", plural(m), degrees(n - m))?;
    writeln!(text, "- a state starts with g = 0 and G ∂H/∂{p} = 0; `state_on_constraint` gives the nearest one")?;
    match &structure.damping {
        Some(found) => damping::section(text, printer, found, structure.autonomous),
        None => Ok(()),
    }
}

fn degrees(count: usize) -> String {
    format!("{count} degree{}", plural(count))
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// What the flow keeps, and the discrete gradient with it: it commutes with H and with every constraint.
fn conserved(text: &mut String, printer: &Printer<'_>, kept: &Structure) -> Written {
    writeln!(text, "\nConserved by the flow and by `DiscreteGradient`, at least")?;
    let mut lines: Vec<String> = vec![];
    if kept.conserves_energy() {
        lines.push("the energy".into());
    }
    lines.extend(kept.cyclic.iter().map(|i| {
        let [q, p] = [Symbol::Position(*i), Symbol::Momentum(*i)].map(|symbol| printer.named(symbol));
        format!("{p}: neither H nor a constraint reads {q}")
    }));
    lines.extend(kept.momenta.iter().map(|momentum| format!("{}: {}", momentum.name, printer.excerpt(momentum.value))));
    if lines.is_empty() {
        lines.push("nothing that was found".into());
    }
    lines.iter().try_for_each(|line| writeln!(text, "- {line}"))
}

fn steps(text: &mut String, structure: &Structure, system: &System<Plan>) -> Written {
    let Implicit::Constrained(kernels) = &system.implicit else { return Ok(()) };
    writeln!(text, "\nSteps")?;
    for (method, step) in &kernels.steps {
        let (unknowns, operations) = (step.unknowns.len(), counted(step.kernel.operations()));
        writeln!(text, "- `{method}`, {unknowns} unknown{}, an iteration: {operations}", plural(unknowns))?;
    }
    writeln!(text, "- both may be composed: `Suzuki4.of(Rattle)`")?;
    writeln!(
        text,
        "- momenta of `DiscreteGradient` leave the constraints by O(h²), and come back: read `state_on_constraint()`"
    )?;

    writeln!(text, "\nSkipped")?;
    if structure.reduced().is_some() {
        writeln!(text, "- momenta as unknowns: T is quadratic, and nothing is damped")?;
    }
    writeln!(text, "- other methods: they know no constraints")
}
