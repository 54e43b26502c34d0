//! What was found of a flow x' = f(x, t), in words.

use super::super::damping::coefficients;
use super::super::kernel::Context;
use super::counted;
use crate::derive::proof::{Jacobi, Structure};
use crate::derive::{Flow, Implicit, MOST_UNKNOWNS, Named, System};
use crate::ir::{Graph, Symbol, print::Printer};
use crate::schedule::Plan;
use std::fmt::{Result as Written, Write};

/// The report.
pub(crate) fn flow(
    context: &Context<'_>,
    graph: &Graph,
    (flow, structure): (&Flow, Option<&Structure>),
    system: &System<Plan>,
) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    // Writing to a string cannot fail.
    let _ = equations(&mut text, context, &printer, flow)
        .and_then(|()| structure.map_or(Ok(()), |structure| of_structure(&mut text, context, &printer, structure)))
        .and_then(|()| kept(&mut text, &printer, flow))
        .and_then(|()| operations(&mut text, flow, system));
    text
}

fn equations<F: Fn(Symbol) -> String>(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_, F>,
    flow: &Flow,
) -> Written {
    if let Some((energy, _)) = &flow.energy {
        writeln!(text, "H = {}", printer.formula(*energy))?;
    }
    (0..).zip(&flow.field).try_for_each(|(i, f)| {
        let name = context.user_name(Symbol::Q(i));
        writeln!(text, "{name}' = {}", printer.excerpt(*f))
    })
}

fn of_structure<F: Fn(Symbol) -> String>(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_, F>,
    structure: &Structure,
) -> Written {
    writeln!(text, "\nStructure")?;
    let name = |i: usize| context.user_name(Symbol::Q(i as u32));
    writeln!(text, "- x' = S ∇H with skew S")?;
    for (i, row) in structure.matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate().skip(i + 1).filter(|(_, entry)| !printer.graph().is_zero(**entry)) {
            writeln!(text, "- {{{}, {}}} = {}", name(i), name(j), printer.excerpt(*entry))?;
        }
    }
    match &structure.jacobi {
        Jacobi::Holds => writeln!(text, "- a Poisson structure: Jacobi's identity holds"),
        Jacobi::Fails([i, j, k], rest) => {
            let rest = printer.excerpt(*rest);
            writeln!(text, "- not a Poisson structure: in Jacobi's identity indices ({i}, {j}, {k}) leave {rest}; the energy is kept all the same")
        }
        Jacobi::Open => writeln!(text, "- it was not decided whether this is a Poisson structure"),
    }
}

fn kept<F: Fn(Symbol) -> String>(text: &mut String, printer: &Printer<'_, F>, flow: &Flow) -> Written {
    writeln!(text, "\nKept by the flow")?;
    if flow.kept.is_empty() {
        return writeln!(text, "- nothing was listed");
    }
    for Named { name, conserved, assumed } in &flow.kept {
        let value = printer.excerpt(conserved.value);
        let word = if *assumed { "assumed, not proven" } else { "proven by multiplying out" };
        match &conserved.but {
            None => writeln!(text, "- {name} = {value}: {word}")?,
            Some(b) => {
                let change = coefficients(printer, b);
                writeln!(text, "- {name} = {value}, but for b·∇I with b = {change}: {word}")?;
            }
        }
    }
    Ok(())
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
        _ => format!("the fixed point while it attracts, Newton's iteration elsewhere: measured to be faster beyond {MOST_UNKNOWNS}"),
    };
    writeln!(text, "- unknowns {n}: {solver}")?;
    if flow.kept.is_empty() {
        return Ok(());
    }
    let list = |ids: Vec<&str>| ids.join(", ");
    let names = list(flow.kept.iter().map(|named| named.name.as_str()).collect());
    match &flow.energy {
        None => writeln!(text, "- `DiscreteGradient` and `FourthOrder` keep {names}, to rounding"),
        Some(_) if flow.kept.iter().any(|named| named.conserved.but.is_some()) => {
            writeln!(text, "- a step of `DiscreteGradient` takes h ∇̄H·C ∇̄H off the energy, to rounding")
        }
        Some(_) => writeln!(
            text,
            "- `DiscreteGradient` keeps the energy to rounding, and every C of degree 2 at most with S ∇C = 0; `FourthOrder` keeps {names}"
        ),
    }
}
