//! Reports H(q, p, t) and H(q, p, s, t) with constraints.

use super::{Report, contact, friction, lagrangian, plural};
use crate::analyze::Binding;
use crate::derive::{ConstrainedFindings, Kernels, System};
use crate::diff::constraint::Row;
use crate::ir::Symbol;
use crate::parse::Role;

/// Reports the equations, conserved functions and steps.
pub(super) fn report(report: &mut Report<'_>, found: &ConstrainedFindings, system: &System) {
    equations(report, found, system);
    let rolls = found.rows.iter().any(|row| row.value.is_none());
    match &found.action {
        Some((action, dissipated)) if dissipated.is_some() => {
            contact::decaying(report, "H", CONTACT_MAPS, action.decay, dissipated);
        }
        Some(_) => {}
        None => conserved(report, found, rolls),
    }
    work(report, found);
    if rolls {
        writeln!(report, "- no symplectic form: volume in phase space is not kept in general");
    }
    steps(report, found, system, rolls);
}

/// The contact maps for systems with constraints.
const CONTACT_MAPS: &str = "`ContactSplitting`, `ContactLeapfrog`";

/// Writes the integrals of a system without an action.
fn conserved(report: &mut Report<'_>, found: &ConstrainedFindings, rolls: bool) {
    let kept = &found.kept;
    writeln!(report, "\nConserved by the flow and by `DiscreteGradient`, at least");
    let energy = kept.conserves_energy().then(|| "the energy".to_string());
    let reads =
        if rolls { "no row binds its velocity, and neither H nor g reads" } else { "neither H nor a constraint reads" };
    let cyclic = kept.cyclic.iter().map(|i| {
        let [q, p] = [Symbol::Position(*i), Symbol::Momentum(*i)].map(|symbol| report.named(symbol));
        format!("{p}: {reads} {q}")
    });
    let momenta = kept.momenta.iter().map(|momentum| report.momentum(momentum));
    let conserved: Vec<String> = energy.into_iter().chain(cyclic).chain(momenta).collect();
    report.conserved(&conserved);
}

/// Writes which constraints do work.
fn work(report: &mut Report<'_>, found: &ConstrainedFindings) {
    for (k, row) in found.rows.iter().enumerate() {
        let graph = &report.compilation.graph;
        if graph.is_zero(row.drift) {
            continue;
        }
        let multiplier = multiplier(&found.rows, k);
        let power = match row.value {
            Some(_) => format!("{multiplier}·∂g[{k}]/∂t"),
            None => format!("−{multiplier}·({})", report.formula(row.drift)),
        };
        let also = if found.action.is_some() { "also " } else { "" };
        writeln!(report, "- the energy {also}changes at the rate {power}: this constraint does work");
    }
}

/// The name of the multiplier of a row: λ[k] for positions, μ[k] for velocities.
fn multiplier(rows: &[Row], k: usize) -> String {
    let positions = rows.iter().filter(|row| row.value.is_some()).count();
    if k < positions { format!("λ[{k}]") } else { format!("μ[{}]", k - positions) }
}

/// Writes the energy, its gradient, the constraints, and damping.
fn equations(report: &mut Report<'_>, found: &ConstrainedFindings, system: &System) {
    let (rows, gradient, structure) = (&found.rows, &found.gradient, &found.structure);
    let (q, p) = (report.name_of(Role::Position), report.name_of(Role::Momentum));
    writeln!(report, "H = {}", report.formula(found.energy));
    report.derivatives("H", Symbol::Position, &gradient.q, Report::excerpt);
    report.derivatives("H", Symbol::Momentum, &gradient.p, Report::excerpt);
    let mut friction = String::new();
    if let Some((action, _)) = &found.action {
        let s = report.named(Symbol::Action);
        writeln!(report, "∂H/∂{s} = {}", report.excerpt(action.decay));
        friction = format!(" − {p} ∂H/∂{s}");
    }
    lagrangian::of_energy(report, system);
    let (positions, velocities): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.value.is_some());
    if !positions.is_empty() {
        let others = if velocities.is_empty() { "" } else { " + Aᵀμ" };
        writeln!(report, "\nConstraints: {p}' = −∂H/∂{q}{friction} − Gᵀλ{others} with G = ∂g/∂{q}");
        for row in &positions {
            writeln!(report, "- 0 = {}", report.excerpt(row.written));
        }
    }
    if !velocities.is_empty() {
        let others = if positions.is_empty() { "" } else { " − Gᵀλ" };
        let v = report.name_of(Role::Velocity);
        writeln!(report, "\nRolling: {p}' = −∂H/∂{q}{others} + Aᵀμ with A{v} + b = 0");
        for row in &velocities {
            writeln!(report, "- 0 = {}", report.excerpt(row.written));
        }
        for binding in &found.bindings {
            let text = bound(report, binding);
            writeln!(report, "- {text}");
        }
    }
    let (n, m) = (gradient.q.len(), rows.len());
    let (constraints, free) = (plural(m), plural(n - m));
    writeln!(report, "- {n} coordinates and {m} constraint{constraints}: {} degree{free} of freedom", n - m);
    let start = match (positions.is_empty(), velocities.is_empty()) {
        (true, _) => "A∂H/∂p + b = 0",
        (_, true) => "g = 0, dg/dt = 0",
        _ => "g = 0, dg/dt = 0, A∂H/∂p + b = 0",
    };
    writeln!(report, "- a state starts with {start}; `state_on_constraint` gives the nearest one");
    if let Some(found) = &structure.damping {
        friction::damping(report, found, structure.autonomous);
    }
}

/// Says whether constraints of velocities bind positions.
fn bound(report: &Report<'_>, binding: &Binding) -> String {
    match binding {
        Binding::Pair { rows: [i, j], factor, function } => {
            let function = match function {
                Some(function) => format!(": {} stays constant", report.excerpt(*function)),
                None => String::new(),
            };
            let factor = report.excerpt(*factor);
            format!("row {i} − {factor}·row {j} is the rate of a function of positions{function}")
        }
        Binding::Nonholonomic => {
            "velocities are bound, positions are not: no function of positions has this rate".into()
        }
        Binding::Unknown => {
            "whether it binds positions is not known: it is not the rate of a function, but a product with it may be"
                .into()
        }
        Binding::NoPair => {
            "no combination of two rows with constant factors was found to be the rate of a function of positions"
                .into()
        }
    }
}

/// Writes the costs of steps and the omitted methods.
fn steps(report: &mut Report<'_>, found: &ConstrainedFindings, system: &System, rolls: bool) {
    let Kernels::Constrained(kernels) = &system.kernels else { return };
    writeln!(report, "\nSteps");
    for (method, step) in &kernels.steps {
        let (unknowns, operations) = (step.unknowns.len(), step.kernel.operations());
        writeln!(report, "- `{method}`, {unknowns} unknown{}, an iteration: {operations}", plural(unknowns));
    }
    match (&found.action, rolls) {
        (Some(_), _) => writeln!(report, "- all may be composed: `Suzuki4.of(ContactSplitting)`"),
        (None, true) => writeln!(report, "- it may be composed: `Suzuki4.of(DiscreteGradient)`"),
        (None, false) => writeln!(report, "- both may be composed: `Suzuki4.of(Rattle)`"),
    }
    if kernels.quadratic {
        writeln!(report, "- momenta are tangent to the constraints at the ends of steps");
    } else {
        writeln!(
            report,
            "- momenta of `{}` leave the constraints by O(h²), and come back: read `state_on_constraint()`",
            if found.action.is_some() { "ContactDiscreteGradient" } else { "DiscreteGradient" }
        );
    }
    if system.rate.is_some() {
        writeln!(
            report,
            "- `RK4`, `DOP853`, `adaptive`: multipliers are eliminated, constraints hold to the error of the method, and dependent rows are not noticed"
        );
    }

    writeln!(report, "\nSkipped");
    if found.structure.reduced().is_some() {
        let undamped = if found.action.is_none() { ", and nothing is damped" } else { "" };
        writeln!(report, "- momenta as unknowns: T is quadratic{undamped}");
    }
    writeln!(report, "- other methods: they know no constraints")
}
