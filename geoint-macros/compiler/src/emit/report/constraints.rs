//! Reports H(q, p, t) with constraints.

use super::{Report, friction, lagrangian, plural};
use crate::analyze::Structure;
use crate::derive::{Kernels, System};
use crate::diff::Gradient;
use crate::ir::{Id, Symbol};
use crate::parse::Role;

/// Reports the equations, conserved functions and steps. `kept` holds the functions that commute with H and with every constraint.
pub(super) fn report(
    report: &mut Report<'_>,
    structure: &Structure,
    kept: &Structure,
    constraints: &[Id],
    gradient: &Gradient,
    system: &System,
) {
    equations(report, structure, constraints, gradient, system);
    writeln!(report, "\nConserved by the flow and by `DiscreteGradient`, at least");
    let energy = kept.conserves_energy().then(|| "the energy".to_string());
    let cyclic = kept.cyclic.iter().map(|i| {
        let [q, p] = [Symbol::Position(*i), Symbol::Momentum(*i)].map(|symbol| report.named(symbol));
        format!("{p}: neither H nor a constraint reads {q}")
    });
    let momenta = kept.momenta.iter().map(|momentum| report.momentum(momentum));
    let conserved: Vec<String> = energy.into_iter().chain(cyclic).chain(momenta).collect();
    report.conserved(&conserved);
    steps(report, structure, system);
}

/// Writes the energy, its gradient, the constraints, and damping.
fn equations(report: &mut Report<'_>, structure: &Structure, constraints: &[Id], gradient: &Gradient, system: &System) {
    let (q, p) = (report.name_of(Role::Position), report.name_of(Role::Momentum));
    writeln!(report, "H = {}", report.formula(structure.energy));
    report.derivatives("H", Symbol::Position, &gradient.q, Report::excerpt);
    report.derivatives("H", Symbol::Momentum, &gradient.p, Report::excerpt);
    lagrangian::of_energy(report, system);
    writeln!(report, "\nConstraints: {p}' = −∂H/∂{q} − Gᵀλ with G = ∂g/∂{q}");
    for constraint in constraints {
        writeln!(report, "- 0 = {}", report.excerpt(*constraint));
    }
    let (n, m) = (gradient.q.len(), constraints.len());
    let (constraints, free) = (plural(m), plural(n - m));
    writeln!(report, "- {n} coordinates and {m} constraint{constraints}: {} degree{free} of freedom", n - m);
    writeln!(report, "- a state starts with g = 0 and G ∂H/∂{p} = 0; `state_on_constraint` gives the nearest one");
    if let Some(found) = &structure.damping {
        friction::damping(report, found, structure.autonomous);
    }
}

/// Writes the costs of steps and the omitted methods.
fn steps(report: &mut Report<'_>, structure: &Structure, system: &System) {
    let Kernels::Constrained(kernels) = &system.kernels else { return };
    writeln!(report, "\nSteps");
    for (method, step) in &kernels.steps {
        let (unknowns, operations) = (step.unknowns.len(), step.kernel.operations());
        writeln!(report, "- `{method}`, {unknowns} unknown{}, an iteration: {operations}", plural(unknowns));
    }
    writeln!(report, "- both may be composed: `Suzuki4.of(Rattle)`");
    writeln!(
        report,
        "- momenta of `DiscreteGradient` leave the constraints by O(h²), and come back: read `state_on_constraint()`"
    );

    writeln!(report, "\nSkipped");
    if structure.reduced().is_some() {
        writeln!(report, "- momenta as unknowns: T is quadratic, and nothing is damped");
    }
    writeln!(report, "- other methods: they know no constraints")
}
