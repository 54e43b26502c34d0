//! Reports a Lagrangian and its energy.

use super::Report;
use crate::derive::{OfEnergy, System};
use crate::ir::{Graph, Symbol};
use crate::legendre::{Kinetic, Legendre, Part};
use crate::parse::{Form, Role};

/// Reports L, its derivatives, and the relation between momenta and velocities.
pub(super) fn report(report: &mut Report<'_>, legendre: &Legendre) {
    let graph = report.graph();
    writeln!(report, "L = {}", report.formula(legendre.lagrangian));
    report.derivatives("L", Symbol::Position, &legendre.forces, Report::excerpt);
    report.derivatives("L", Symbol::Velocity, &legendre.momenta, Report::excerpt);

    let (p, v) = (report.name_of(Role::Momentum), report.name_of(Role::Velocity));
    writeln!(report, "\nFrom velocities to momenta: {p} = ∂L/∂{v}, H = {p}·{v} − L");
    legendre.parts.iter().for_each(|part| self::part(report, part));
    if !graph.is_zero(legendre.potential) {
        writeln!(report, "- without velocities, −L = {}", report.excerpt(legendre.potential));
    }
    writeln!(report, "- H is {}", mechanical(graph, legendre));
    if let Some(gauge) = legendre.gauge {
        let (rate, effect) = match graph.reads(gauge).t {
            true => (" − ∂f/∂t", "a potential ∂f/∂t to the energy"),
            false => ("", "changes no motion: without it the energy has fewer terms that couple positions and momenta"),
        };
        let (f, q) = (report.excerpt(gauge), report.name_of(Role::Position));
        writeln!(
            report,
            "- what is linear in velocities is d/dt f{rate} with f = {f}: it adds ∂f/∂{q} to momenta, and {effect}"
        );
    }
    if legendre.concave {
        writeln!(report, "- the mass matrix is negative definite: −L has the same equations");
    }
    if legendre.momenta.iter().any(|momentum| graph.reads(*momentum).s) {
        let options = &report.compilation.energy.options;
        let forced = options.force.is_some() || options.rayleigh.is_some();
        let others = if forced { "" } else { ", contact Gauss methods do" };
        writeln!(report, "- momenta read the action: kick and drift do not exist{others}");
    }
    if let Some(rate) = legendre.friction {
        let rate = report.excerpt(rate);
        writeln!(
            report,
            "- friction is γ ∂²L/∂v² v with γ = {rate}, so that momenta of coordinates that are not read decay by one factor: with `- ({rate}) * s` \
             in L in its place, contact methods keep that to rounding"
        );
    }
    writeln!(report)
}

/// Reports the Lagrangian of a system that is given by its energy.
pub(super) fn of_energy(report: &mut Report<'_>, system: &System) {
    if report.compilation.form != Form::Hamiltonian {
        return;
    }
    let (p, v) = (report.name_of(Role::Momentum), report.name_of(Role::Velocity));
    match &system.of_energy {
        Some(OfEnergy { lagrangian, .. }) => {
            writeln!(report, "L = {}, with {v} = ∂H/∂{p}", report.excerpt(*lagrangian));
        }
        None => writeln!(report, "∂H/∂{p} = {v} has no formula for {p}: L by values only"),
    }
}

/// Reports the mass matrix of a part, or the rule for its conjugate.
fn part(report: &mut Report<'_>, Part { velocities, kinetic }: &Part) {
    let graph = report.graph();
    let names = report.names(Symbol::Velocity, velocities);
    match kinetic {
        Kinetic::Conjugate { term, rule } => {
            writeln!(report, "- {names}: a conjugate in closed form of {}: {rule}", report.excerpt(*term))
        }
        Kinetic::Open(term) => {
            let term = report.excerpt(*term);
            writeln!(
                report,
                "- {names}: neither quadratic nor of a known conjugate, found by Newton's iteration: {term}"
            )
        }
        Kinetic::Quadratic { mass, shift } => {
            let entries = || (0..mass.len()).flat_map(|i| (0..=i).map(move |j| (i, j)));
            let constant = entries().all(|(i, j)| !graph.reads(mass[i][j]).moves());
            let kind = if constant { "constant" } else { "not constant" };
            let how = if mass.len() == 1 { "" } else { ", factored as LDLᵀ" };
            writeln!(report, "- {names}: L is quadratic, with a mass matrix that is {kind}{how}");
            for (i, j) in entries().filter(|(i, j)| !graph.is_zero(mass[*i][*j])) {
                let [row, column] = [i, j].map(|i| report.named(Symbol::Velocity(velocities[i])));
                writeln!(report, "  - ∂²L/∂{row}∂{column} = {}", report.excerpt(mass[i][j]));
            }
            for (i, a) in velocities.iter().zip(shift).filter(|(_, a)| !graph.is_zero(**a)) {
                writeln!(report, "  - linear in {}: {}", report.named(Symbol::Velocity(*i)), report.excerpt(*a));
            }
        }
    }
}

/// Returns the form of H, and whether H is the sum of kinetic and potential energy.
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
