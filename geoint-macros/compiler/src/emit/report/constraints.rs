//! Facts about H(q, p, t) with constraints, in words.

use super::{Report, counted, friction, plural};
use crate::analyze::Structure;
use crate::derive::{Kernels, System};
use crate::diff::Gradient;
use crate::ir::{Id, Symbol};
use crate::parse::Role;

/// The energy, its gradient, the constraints, and damping.
pub(super) fn equations(report: &mut Report<'_>, structure: &Structure, constraints: &[Id], gradient: &Gradient) {
    let (q, p) = (report.name_of(Role::Position), report.name_of(Role::Momentum));
    writeln!(report, "H = {}", report.formula(structure.energy));
    for (symbol, slopes) in [(Symbol::Position as fn(u32) -> Symbol, &gradient.q), (Symbol::Momentum, &gradient.p)] {
        for (i, slope) in (0..).zip(slopes) {
            writeln!(report, "∂H/∂{} = {}", report.named(symbol(i)), report.excerpt(*slope));
        }
    }
    writeln!(report, "\nConstraints: {p}' = −∂H/∂{q} − Gᵀλ with G = ∂g/∂{q}");
    for constraint in constraints {
        writeln!(report, "- 0 = {}", report.excerpt(*constraint));
    }
    let (n, m) = (gradient.q.len(), constraints.len());
    writeln!(report, "- {n} coordinates and {m} constraint{}: {} of freedom", plural(m), degrees(n - m));
    writeln!(report, "- a state starts with g = 0 and G ∂H/∂{p} = 0; `state_on_constraint` gives the nearest one");
    if let Some(found) = &structure.damping {
        friction::damping(report, found, structure.autonomous);
    }
}

fn degrees(count: usize) -> String {
    format!("{count} degree{}", plural(count))
}

/// What the flow keeps, and the discrete gradient with it: it commutes with H and with every constraint.
pub(super) fn conserved(report: &mut Report<'_>, kept: &Structure) {
    writeln!(report, "\nConserved by the flow and by `DiscreteGradient`, at least");
    let mut lines: Vec<String> = vec![];
    if kept.conserves_energy() {
        lines.push("the energy".into());
    }
    lines.extend(kept.cyclic.iter().map(|i| {
        let [q, p] = [Symbol::Position(*i), Symbol::Momentum(*i)].map(|symbol| report.named(symbol));
        format!("{p}: neither H nor a constraint reads {q}")
    }));
    lines.extend(kept.momenta.iter().map(|momentum| format!("{}: {}", momentum.name, report.excerpt(momentum.value))));
    if lines.is_empty() {
        lines.push("nothing that was found".into());
    }
    for line in &lines {
        writeln!(report, "- {line}");
    }
}

pub(super) fn steps(report: &mut Report<'_>, structure: &Structure, system: &System) {
    let Kernels::Constrained(kernels) = &system.kernels else { return };
    writeln!(report, "\nSteps");
    for (method, step) in &kernels.steps {
        let (unknowns, operations) = (step.unknowns.len(), counted(step.kernel.operations()));
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
