//! What was found of H(q, p, s, t) with forces beside it, in words.

use super::super::damping::coefficients;
use super::super::kernel::Context;
use crate::analyze::Forces;
use crate::ir::{Graph, Id, print::Printer};
use std::fmt::{Result as Written, Write};

/// The report; `drag` is ∂R/∂v where R is a quadratic form.
pub(crate) fn forced(context: &Context<'_>, graph: &Graph, found: (Id, Option<&Forces>, Option<&[Id]>)) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = sections(&mut text, context, graph, found);
    text
}

fn sections(
    text: &mut String,
    context: &Context<'_>,
    graph: &Graph,
    (energy, forces, drag): (Id, Option<&Forces>, Option<&[Id]>),
) -> Written {
    let printer = Printer::new(graph, context);
    let applied = forces.and_then(|forces| forces.applied.as_deref());
    let friction = drag.or(forces.and_then(|forces| forces.friction.as_deref()));
    let (plus, minus) = (applied.map(|_| " + F"), friction.map(|_| " − ∂R/∂v"));
    let (work, taken) = (applied.map(|_| " + v·F"), friction.map(|_| " − v·∂R/∂v"));
    let explicit = graph.reads(energy).t.then_some(" + ∂H/∂t");
    let all = |parts: &[Option<&str>]| parts.iter().flatten().copied().collect::<String>();
    writeln!(text, "H = {}", printer.formula(energy))?;
    writeln!(text, "\nForces beside the energy, with v = ∂H/∂p")?;
    if let Some(applied) = applied {
        writeln!(text, "- F = {}", coefficients(&printer, applied))?;
    }
    if let Some(friction) = friction {
        writeln!(
            text,
            "- ∂R/∂v = {}; a step in which friction would feed energy is refused",
            coefficients(&printer, friction)
        )?;
    }
    writeln!(text, "- p' = −∂H/∂q − p ∂H/∂s{}", all(&[plus, minus]))?;
    writeln!(text, "- H' = −H ∂H/∂s{}", all(&[explicit, work, taken]))?;
    if let Some(potential) = forces.and_then(|forces| forces.potential) {
        let potential = printer.excerpt(potential);
        writeln!(text, "- F has a potential: add {potential} to L, and every contact method is there")?;
    }
    writeln!(
        text,
        "- no step is a contact map, and kick and drift do not exist: methods are `DOP853`, `RK4` and Taylor series"
    )
}
