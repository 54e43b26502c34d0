//! What was found of H(q, p, t), in words.

use super::super::damping;
use super::super::kernel::Context;
use super::{counted, pieces};
use crate::analyze::{MeanValue, Split, Structure};
use crate::derive::{Fact, FieldKernels, Implicit, MOST_UNKNOWNS, Perturbed, System};
use crate::diff::Gradient;
use crate::ir::{Graph, Id, print::Printer};
use crate::parse::Role;
use crate::schedule::Plan;
use std::fmt::Write;

/// The report. Lines are short enough for a terminal unless a formula is not.
pub(crate) fn canonical(
    context: &Context<'_>,
    graph: &Graph,
    structure: &Structure,
    (system, gradient): (&System<Plan>, &Gradient),
) -> String {
    let printer = Printer::new(graph, context);
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = sections(&mut text, context, &printer, structure, (system, gradient));
    text
}

fn sections(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_>,
    structure: &Structure,
    (system, gradient): (&System<Plan>, &Gradient),
) -> std::fmt::Result {
    let energy = context.energy;
    let (q, p) = (context.name_of(Role::Position), context.name_of(Role::Momentum));
    writeln!(text, "H = {}", printer.formula(structure.energy))?;
    for (symbols, slopes) in [(&q, &gradient.q), (&p, &gradient.p)] {
        for (i, slope) in slopes.iter().enumerate() {
            let indices: String = energy.coordinates.shape.indices(i).iter().map(|i| format!("[{i}]")).collect();
            writeln!(text, "∂H/∂{symbols}{indices} = {}", formula(printer, *slope))?;
        }
    }

    writeln!(text, "\nStructure")?;
    match &structure.split {
        Split::Separable(parts) => {
            let flows = if structure.flows().is_some() { ": kick and drift are exact flows" } else { "" };
            writeln!(text, "- H = T({p}) + V({q}){flows}")?;
            writeln!(text, "- T = {}", printer.excerpt(parts.kinetic))?;
            writeln!(text, "- V = {}", printer.excerpt(parts.potential))?;
            match parts.not_quadratic {
                None => writeln!(text, "- T is quadratic in {p} with a constant mass matrix")?,
                Some(term) => writeln!(text, "- T is not quadratic in {p}: {}", printer.excerpt(term))?,
            }
        }
        Split::Coupled(term) => {
            writeln!(text, "- not separable, {q} and {p} are coupled by: {}", printer.excerpt(*term))?
        }
    }
    let velocities = &gradient.p;
    let moves = structure.resting.len() < velocities.len();
    if moves && !velocities.iter().any(|velocity| printer.graph().reads(*velocity).p) {
        writeln!(text, "- H is linear in {p}: {q} follows the field ∂H/∂{p} by itself, whatever {p} is")?;
    }
    match structure.degree {
        Some(degree) => writeln!(text, "- H is a polynomial of degree {degree} in {q} and {p}")?,
        None => writeln!(text, "- H is not a polynomial in {q} and {p}")?,
    }
    let reads_time = if structure.autonomous { "does not depend" } else { "depends" };
    writeln!(text, "- H {reads_time} on time")?;

    if let Some(damping) = &structure.damping {
        damping::section(text, printer, damping, structure.autonomous)?;
    }
    if let Some(forces) = &structure.forces {
        damping::forces(text, printer, forces, structure.autonomous)?;
    }

    let listed = |name: &str, indices: &[u32]| {
        let one = |i: &u32| {
            let indices: String =
                energy.coordinates.shape.indices(*i as usize).iter().map(|i| format!("[{i}]")).collect();
            format!("{name}{indices}")
        };
        indices.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let unread = [(&p, &q, &structure.cyclic), (&q, &p, &structure.resting)]
        .map(|(kept, unread, indices)| (listed(kept, indices), listed(unread, indices)));
    conserved(text, printer, structure, &unread)?;

    for found in &system.pieces {
        writeln!(text, "\nPieces with flows in closed form, in the order of half a step of `PieceSplitting`")?;
        pieces::of_energy(text, printer, (found, false))?;
        if system.has(Fact::NystromPieces) {
            writeln!(
                text,
                "- tables of Runge–Kutta–Nyström type keep their order, `BlanesMoanSrkn14a.of(PieceSplitting)`"
            )?;
        }
    }
    if let Some(Ok(parts)) = &system.perturbed {
        perturbed(text, printer, parts)?;
    }

    writeln!(text, "\nOperations (a sine with its cosine counts as two)")?;
    if let Some(slopes) = &system.slopes {
        writeln!(text, "- gradient of H: {}", counted(slopes.operations()))?;
    }
    if let Some(Ok(flows)) = &system.splitting {
        writeln!(text, "- kick: {}", counted(flows.kick.kernel.operations()))?;
        writeln!(text, "- drift: {}", counted(flows.drift.kernel.operations()))?;
    }
    if let Implicit::Field(field) = &system.implicit {
        implicit(text, field)?;
    }

    writeln!(text, "\nSkipped")?;
    if structure.flows().is_some() {
        writeln!(text, "- Newton's iteration in explicit methods: T and V have exact flows")?;
    }
    if structure.reduced().is_some() {
        writeln!(text, "- half of the unknowns of implicit methods: T is quadratic")?;
    }
    if structure.timeless() {
        writeln!(text, "- the clock: H does not depend on time")?;
    }
    if !structure.cyclic.is_empty() {
        writeln!(text, "- the force on {}: it is zero", listed(&p, &structure.cyclic))?;
    }
    writeln!(text, "- recomputing what depends on parameters and the step size: prepared once")?;
    match structure.split {
        _ if !structure.conservative() => {}
        Split::Coupled(_) => writeln!(text, "- kick and drift: they do not exist for this H")?,
        _ if structure.quadratic_parts().is_none() => {
            writeln!(text, "- Runge–Kutta–Nyström tables: they need a quadratic T")?;
        }
        _ => {}
    }
    Ok(())
}

/// The part with an exact flow, and the rest.
fn perturbed(text: &mut String, printer: &Printer<'_>, parts: &Perturbed<Plan>) -> std::fmt::Result {
    writeln!(text, "\nA + B, an exact flow and a kick (`Perturbation`, `WisdomHolman`, `Aba10_6_4` …)")?;
    if let Some(inner) = &parts.inner {
        writeln!(text, "- in {}", inner.name)?;
    }
    writeln!(text, "- A = {}", printer.excerpt(parts.exact))?;
    parts.known.iter().try_for_each(|known| writeln!(text, "  {known}"))?;
    writeln!(text, "  {}", counted(parts.flow.kernel.operations()))?;
    writeln!(text, "- B = {}", printer.excerpt(parts.rest))?;
    writeln!(text, "  {}", counted(parts.kick.kernel.operations()))?;
    match (parts.is_kick, parts.is_exact) {
        (true, _) => {}
        (false, true) => {
            writeln!(text, "  a motion of all bodies alike and a kick, which leave each other as they are")?
        }
        (false, false) => writeln!(text, "  half of the motion, the kick, half of the motion: a step of order 2")?,
    }
    match &parts.gradient_kick {
        Ok(_) => writeln!(text, "- tables of Runge–Kutta–Nyström type and with force gradients keep their order"),
        Err(missing) => {
            let term = printer.excerpt(missing.term);
            writeln!(text, "- no tables of Runge–Kutta–Nyström type and with force gradients, because of {term}")
        }
    }
}

/// What implicit steps cost, and how they are solved.
fn implicit(text: &mut String, field: &FieldKernels<Plan>) -> std::fmt::Result {
    writeln!(text, "- stage of a Newton iteration of collocation: {}", counted(field.collocation.operations()))?;
    if let Some(discrete) = &field.discrete {
        writeln!(text, "- Newton iteration of the discrete gradient: {}", counted(discrete.operations()))?;
    }

    writeln!(text, "\nImplicit steps")?;
    let unknowns = field.coordinates.len();
    let solver = match unknowns {
        _ if field.linear => "the equation is linear, its matrix inverted once".into(),
        1 => "Newton's iteration for one number".into(),
        2..=MOST_UNKNOWNS => "Newton's iteration with elimination".into(),
        _ => format!(
            "the fixed point while it attracts, Newton's iteration elsewhere: measured to be faster beyond {MOST_UNKNOWNS}"
        ),
    };
    writeln!(text, "- `DiscreteGradient`, unknowns {unknowns}: {solver}")
}

/// What the flow conserves and discrete gradients keep; `unread` are coordinates with their conjugates, which H does not
/// read.
fn conserved(
    text: &mut String,
    printer: &Printer<'_>,
    structure: &Structure,
    unread: &[(String, String)],
) -> std::fmt::Result {
    let mut lines = vec![];
    if structure.conserves_energy() {
        lines.push("the energy".into());
    }
    let unread = unread.iter().filter(|(kept, _)| !kept.is_empty());
    lines.extend(unread.map(|(kept, unread)| format!("{kept}: H does not read {unread}")));
    let momenta = structure.momenta.iter();
    lines.extend(momenta.map(|momentum| format!("{}: {}", momentum.name, printer.excerpt(momentum.value))));
    writeln!(text, "\nConserved by the flow, at least")?;
    for line in &lines {
        writeln!(text, "- {line}")?;
    }
    if lines.is_empty() {
        writeln!(text, "- nothing that was found")?;
    }

    let mut discrete: Vec<String> = vec![];
    if !lines.is_empty() {
        let fourth = if structure.conservative() { " and `FourthOrder(DiscreteGradient)` keep" } else { " keeps" };
        discrete.push(format!("`DiscreteGradient`{fourth} all of that, to rounding"));
        if structure.conservative() && structure.autonomous && !structure.momenta.is_empty() {
            discrete.push(
                "on an orbit on which the gradient of a momentum depends on that of H all along, as on a circle, \
                 `FourthOrder(DiscreteGradient)` keeps H alone"
                    .into(),
            );
        }
    }
    if structure.switches {
        discrete.push(
            "across an `if` that is on different sides at both ends of a step they take the secant of the whole `if`"
                .into(),
        );
    }
    // It is for systems that keep their energy.
    if structure.conservative() {
        discrete.push(match structure.mean_value {
            MeanValue::Parts(1) => "`MeanValue` has a closed form: it is `DiscreteGradient`".into(),
            MeanValue::Parts(parts) => {
                format!("`MeanValue::<{parts}>` is exact: `DiscreteGradient` over parts of a step, extrapolated")
            }
            MeanValue::Gauss(points) => format!("`MeanValue::<{points}>` is exact: Gauss points for a polynomial"),
            MeanValue::NotClosed(term) => {
                let term = printer.excerpt(term);
                format!("`MeanValue::<N>` is a quadrature with N Gauss points: no closed form was found for {term}")
            }
        });
    }
    if !discrete.is_empty() {
        writeln!(text, "\nDiscrete gradients")?;
    }
    discrete.iter().try_for_each(|line| writeln!(text, "- {line}"))
}

/// A derivative, written out unless it fills the screen.
fn formula(printer: &Printer<'_>, id: Id) -> String {
    let formula = printer.formula(id);
    if formula.chars().count() > 400 { Printer::cut(formula) } else { formula }
}
