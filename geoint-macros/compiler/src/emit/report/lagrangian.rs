//! What was found of a Lagrangian, in words.

use super::super::damping;
use super::super::kernel::Context;
use super::{contact, counted};
use crate::analyze::{Damping, Dissipated, Forces, Spared};
use crate::derive::{Implicit, System};
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::legendre::{Kinetic, Legendre, Part};
use crate::parse::Role;
use crate::schedule::Plan;
use std::fmt::{Result as Written, Write};

/// The report, up to that of the energy; nothing if there is no Lagrangian.
pub(crate) fn lagrangian(context: &Context<'_>, graph: &Graph, legendre: Option<&Legendre>) -> String {
    let mut text = String::new();
    if let Some(legendre) = legendre {
        let printer = Printer::new(graph, context);
        // Writing to a string cannot fail.
        let _ = sections(&mut text, context, &printer, legendre);
    }
    text
}

fn sections(text: &mut String, context: &Context<'_>, printer: &Printer<'_>, legendre: &Legendre) -> Written {
    let graph = printer.graph();
    writeln!(text, "L = {}", printer.formula(legendre.lagrangian))?;
    for (symbol, slopes) in
        [(Symbol::Position as fn(u32) -> Symbol, &legendre.forces), (Symbol::Velocity, &legendre.momenta)]
    {
        for (i, slope) in (0..).zip(slopes) {
            writeln!(text, "∂L/∂{} = {}", printer.named(symbol(i)), printer.excerpt(*slope))?;
        }
    }

    let p = context.name_of(Role::Momentum);
    writeln!(
        text,
        "\nFrom velocities to momenta: {p} = ∂L/∂{}, H = {p}·{1} − L",
        context.name_of(Role::Velocity),
        context.name_of(Role::Velocity)
    )?;
    legendre.parts.iter().try_for_each(|part| self::part(text, printer, part))?;
    if !graph.is_zero(legendre.potential) {
        writeln!(text, "- without velocities, −L = {}", printer.excerpt(legendre.potential))?;
    }
    writeln!(text, "- H is {}", mechanical(graph, legendre))?;
    if let Some(gauge) = legendre.gauge {
        writeln!(
            text,
            "- what is linear in velocities is d/dt f{} with f = {}: it adds ∂f/∂{} to momenta, and {}",
            if graph.reads(gauge).t { " − ∂f/∂t" } else { "" },
            printer.excerpt(gauge),
            context.name_of(Role::Position),
            match graph.reads(gauge).t {
                true => "a potential ∂f/∂t to the energy",
                false => "changes no motion: without it the energy has fewer terms that couple positions and momenta",
            }
        )?;
    }
    if legendre.concave {
        writeln!(text, "- the mass matrix is negative definite: −L has the same equations")?;
    }
    if legendre.momenta.iter().any(|momentum| graph.reads(*momentum).s) {
        let forced = context.energy.options.force.is_some() || context.energy.options.rayleigh.is_some();
        let others = if forced { "" } else { ", contact Gauss methods do" };
        writeln!(text, "- momenta read the action: kick and drift do not exist{others}")?;
    }
    if let Some(rate) = legendre.friction {
        let rate = printer.excerpt(rate);
        writeln!(
            text,
            "- friction is γ ∂²L/∂v² v with γ = {rate}, so that momenta of coordinates that are not read decay by one factor: with `- ({rate}) * s` \
             in L in its place, contact methods keep that to rounding"
        )?;
    }
    writeln!(text)
}

/// What the mass matrix of a part is, entry by entry, or what rule there is.
fn part(text: &mut String, printer: &Printer<'_>, part: &Part) -> Written {
    let Part { velocities, kinetic } = part;
    let graph = printer.graph();
    let names: Vec<String> = velocities.iter().map(|i| printer.named(Symbol::Velocity(*i))).collect();
    let names = names.join(", ");
    match kinetic {
        Kinetic::Conjugate { term, rule } => {
            writeln!(text, "- {names}: a conjugate in closed form of {}: {rule}", printer.excerpt(*term))
        }
        Kinetic::Open(term) => {
            writeln!(
                text,
                "- {names}: neither quadratic nor of a known conjugate, found by Newton's iteration: {}",
                printer.excerpt(*term)
            )
        }
        Kinetic::Quadratic { mass, shift } => {
            let entries = || (0..mass.len()).flat_map(|i| (0..=i).map(move |j| (i, j)));
            let constant = entries().all(|(i, j)| !graph.reads(mass[i][j]).moves());
            let kind = if constant { "constant" } else { "not constant" };
            let how = match mass.len() {
                1 => "",
                _ => ", factored as LDLᵀ",
            };
            writeln!(text, "- {names}: L is quadratic, with a mass matrix that is {kind}{how}")?;
            for (i, j) in entries().filter(|(i, j)| !graph.is_zero(mass[*i][*j])) {
                let [i_name, j_name] = [i, j].map(|i| printer.named(Symbol::Velocity(velocities[i])));
                writeln!(text, "  - ∂²L/∂{i_name}∂{j_name} = {}", printer.excerpt(mass[i][j]))?;
            }
            linear(text, printer, velocities, shift)
        }
    }
}

fn linear(text: &mut String, printer: &Printer<'_>, velocities: &[u32], shift: &[Id]) -> Written {
    for (i, a) in velocities.iter().zip(shift).filter(|(_, a)| !printer.graph().is_zero(**a)) {
        writeln!(text, "  - linear in {}: {}", printer.named(Symbol::Velocity(*i)), printer.excerpt(*a))?;
    }
    Ok(())
}

/// Whether H is the sum of kinetic and potential energy.
fn mechanical(graph: &Graph, legendre: &Legendre) -> &'static str {
    let quadratic = |part: &Part| match &part.kinetic {
        Kinetic::Quadratic { shift, .. } => shift.iter().all(|a| graph.is_zero(*a)),
        Kinetic::Conjugate { .. } | Kinetic::Open(_) => false,
    };
    match legendre.parts.iter().all(quadratic) {
        true => "T₂ − T₀ + V, with −T₀ + V = −L at rest: T + V, unless a frame that moves has put a T₀ into L",
        false if legendre.shift.iter().any(|a| !graph.is_zero(*a)) => {
            "T₂ − T₀ + V; T₁ has the terms that are linear in velocities: where a frame that moves has put them into L, H is not T + V"
        }
        false => "not T + V: L is not T − V with a T that is a quadratic form in the velocities",
    }
}

/// The report of steps with velocities as unknowns.
pub(crate) fn velocities(
    context: &Context<'_>,
    graph: &Graph,
    (legendre, obstacle): (&Legendre, Id),
    (system, friction): (&System<Plan>, (Option<&Damping>, Option<&Forces>)),
) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, context);
    let _ = steps(&mut text, context, &printer, (legendre, obstacle), (system, friction));
    text
}

fn steps(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_>,
    (legendre, obstacle): (&Legendre, Id),
    (system, (damping, others)): (&System<Plan>, (Option<&Damping>, Option<&Forces>)),
) -> Written {
    let Implicit::Velocities(kernels) = &system.implicit else { return Ok(()) };
    let v = context.name_of(Role::Velocity);
    writeln!(text, "Structure")?;
    writeln!(
        text,
        "- steps are solved for {v}: H as a function of momenta would be long, or has no formula, by {}",
        printer.excerpt(obstacle)
    )?;
    writeln!(text, "- kick and drift do not exist")?;
    let autonomous = !printer.graph().reads(legendre.lagrangian).t;
    writeln!(text, "- L {} on time", if autonomous { "does not depend" } else { "depends" })?;
    if let Some(damping) = damping {
        damping::section(text, printer, damping, autonomous)?;
    }
    if let Some(others) = others {
        damping::forces(text, printer, others, autonomous)?;
    }

    writeln!(text, "\nConserved by the flow, at least")?;
    let read = printer.graph().symbols(legendre.lagrangian);
    let spared = Spared { damping, forces: others };
    let is_kept = |i: &u32| !read.contains(&Symbol::Position(*i)) && spared.coordinate(printer.graph(), *i);
    let cyclic: Vec<u32> = (0..context.energy.degrees()).filter(is_kept).collect();
    let energy = autonomous && damping.is_none() && others.is_none();
    if energy {
        writeln!(text, "- the energy")?;
    }
    for i in &cyclic {
        writeln!(
            text,
            "- {}: L does not read {}",
            printer.named(Symbol::Momentum(*i)),
            printer.named(Symbol::Position(*i))
        )?;
    }
    for (momentum, _) in &kernels.momenta {
        writeln!(text, "- {}: {}", momentum.name, printer.excerpt(momentum.value))?;
    }
    if !energy && cyclic.is_empty() && kernels.momenta.is_empty() {
        writeln!(text, "- nothing that was found")?;
    }
    if !cyclic.is_empty() || !kernels.momenta.is_empty() {
        writeln!(text, "`ImplicitMidpoint` and `Gauss` keep all momenta of these, to rounding")?;
    }
    let summed = kernels.momenta.iter().any(|(_, by_gradient)| *by_gradient);
    if kernels.polarised.is_ok() && (energy || summed || !cyclic.is_empty()) {
        let others = kernels.momenta.iter().filter(|(_, by_gradient)| !by_gradient).map(|(momentum, _)| &momentum.name);
        let others: Vec<String> = others.map(|name| format!("the {name}")).collect();
        match &others[..] {
            [] => writeln!(text, "`DiscreteGradient` keeps all of these, to rounding")?,
            _ => writeln!(text, "`DiscreteGradient` keeps all of these but {}, to rounding", others.join(", "))?,
        }
    }

    writeln!(
        text,
        "\nImplicit steps, with {} unknowns a stage (a sine with its cosine counts as two)",
        legendre.momenta.len()
    )?;
    writeln!(text, "- stage of a Newton iteration of collocation: {}", counted(kernels.stage.operations()))?;
    match &kernels.polarised {
        Ok(polarised) => {
            writeln!(
                text,
                "- Newton iteration of the discrete gradient, the polarised one: {}",
                counted(polarised.operations())
            )
        }
        Err(_) => writeln!(text, "- there is no discrete gradient: L is not quadratic in {v}"),
    }
}

/// The report of steps with velocities as unknowns where there is an action; `decay` is −∂L/∂s.
pub(crate) fn herglotz(
    context: &Context<'_>,
    graph: &Graph,
    (obstacle, decay, dissipated): (Id, Id, Option<&Dissipated>),
    system: &System<Plan>,
) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, context);
    let _ = steps_with_action(&mut text, context, &printer, (obstacle, decay, dissipated), system);
    text
}

fn steps_with_action(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_>,
    (obstacle, decay, dissipated): (Id, Id, Option<&Dissipated>),
    system: &System<Plan>,
) -> Written {
    let Implicit::Herglotz(kernels) = &system.implicit else { return Ok(()) };
    let v = context.name_of(Role::Velocity);
    writeln!(text, "Structure")?;
    writeln!(
        text,
        "- steps are solved for {v}: H as a function of momenta would be long, or has no formula, by {}",
        printer.excerpt(obstacle)
    )?;
    writeln!(text, "- kick and drift do not exist, nor do pieces with flows in closed form")?;
    writeln!(text, "- ∂H/∂s = −∂L/∂s = {}, and H' = −H ∂H/∂s − ∂L/∂t", printer.excerpt(decay))?;
    match kernels.stages.varying {
        true => writeln!(text, "- s acts back on positions or momenta")?,
        false => writeln!(text, "- positions and momenta move without s: `without_action` leaves it out")?,
    }
    if let Some(dissipated) = dissipated {
        contact::decaying(text, printer, ("L", decay), dissipated)?;
    }
    let unknowns = context.energy.degrees() + u32::from(kernels.stages.varying);
    writeln!(text, "\nImplicit steps, with {unknowns} unknowns a stage (a sine with its cosine counts as two)")?;
    writeln!(
        text,
        "- `ContactMidpoint` and `ContactGauss`: {} a stage of an iteration",
        counted(kernels.stages.stage.operations())
    )?;
    match &kernels.polarised {
        Ok(step) => {
            let cost = counted(step.kernel.operations());
            writeln!(text, "- `ContactDiscreteGradient`, the polarised one: {cost} an iteration")
        }
        Err(_) => writeln!(text, "- there is no discrete gradient: L is not quadratic in {v}"),
    }
}
