//! Writes the report of a canonical system H(q, p, t), which may have damping and forces.

use super::{Report, friction, lagrangian, pieces, solver};
use crate::analyze::{MeanValue, Split, Structure};
use crate::derive::{Fact, FieldKernels, Kernels, Perturbed, System};
use crate::diff::Gradient;
use crate::ir::{Id, Symbol, print::Printer};
use crate::parse::Role;

/// Reports the equations, structure, conserved functions, splittings and costs. Lines are not wrapped. Long derivatives and terms are cut.
pub(super) fn report(report: &mut Report<'_>, structure: &Structure, gradient: &Gradient, system: &System) {
    let (q, p) = (report.name_of(Role::Position), report.name_of(Role::Momentum));
    writeln!(report, "H = {}", report.formula(structure.energy));
    report.derivatives("H", Symbol::Position, &gradient.q, formula);
    report.derivatives("H", Symbol::Momentum, &gradient.p, formula);
    lagrangian::of_energy(report, system);

    writeln!(report, "\nStructure");
    match &structure.split {
        Split::Separable(parts) => {
            let flows = if structure.flows().is_some() { ": kick and drift are exact flows" } else { "" };
            writeln!(report, "- H = T({p}) + V({q}){flows}");
            writeln!(report, "- T = {}", report.excerpt(parts.kinetic));
            writeln!(report, "- V = {}", report.excerpt(parts.potential));
            match parts.not_quadratic {
                None => writeln!(report, "- T is quadratic in {p} with a constant mass matrix"),
                Some(term) => writeln!(report, "- T is not quadratic in {p}: {}", report.excerpt(term)),
            }
        }
        Split::Coupled(term) => {
            writeln!(report, "- not separable, {q} and {p} are coupled by: {}", report.excerpt(*term))
        }
    }
    let velocities = &gradient.p;
    let moves = structure.resting.len() < velocities.len();
    if moves && !velocities.iter().any(|velocity| report.graph().reads(*velocity).p) {
        writeln!(report, "- H is linear in {p}: {q} follows the field ∂H/∂{p} by itself, whatever {p} is");
    }
    match structure.degree {
        Some(degree) => writeln!(report, "- H is a polynomial of degree {degree} in {q} and {p}"),
        None => writeln!(report, "- H is not a polynomial in {q} and {p}"),
    }
    report.time("H", structure.autonomous);

    if let Some(damping) = &structure.damping {
        friction::damping(report, damping, structure.autonomous);
    }
    if let Some(forces) = &structure.forces {
        friction::forces(report, forces, structure.autonomous);
    }

    conserved(report, structure);

    // At most one splitting: `PieceSplitting`, if positions and momenta are coupled or the user gave groups of terms. A step applies the pieces in this order
    // with h/2, and then in reverse order, so that the two flows of the last piece are one flow of length h.
    for found in &system.pieces {
        writeln!(report, "\nPieces with flows in closed form, in the order of half a step of `PieceSplitting`");
        pieces::of_energy(report, found);
        if system.has(Fact::NystromPieces) {
            writeln!(
                report,
                "- tables of Runge–Kutta–Nyström type keep their order, `BlanesMoanSrkn14a.of(PieceSplitting)`"
            );
        }
    }
    if let Some(Ok(parts)) = &system.perturbed {
        perturbed(report, parts);
    }

    writeln!(report, "\nOperations (a sine with its cosine counts as two)");
    if let Some(slopes) = &system.gradient {
        writeln!(report, "- gradient of H: {}", slopes.operations());
    }
    if let Some(Ok(flows)) = &system.splitting {
        writeln!(report, "- kick: {}", flows.kick.kernel.operations());
        writeln!(report, "- drift: {}", flows.drift.kernel.operations());
    }
    if let Kernels::Field(field) = &system.kernels {
        implicit(report, field);
    }

    writeln!(report, "\nSkipped");
    if structure.flows().is_some() {
        writeln!(report, "- Newton's iteration in explicit methods: T and V have exact flows");
    }
    if structure.reduced().is_some() {
        writeln!(report, "- half of the unknowns of implicit methods: T is quadratic");
    }
    // Stronger than `autonomous`: damping and forces do not read time either.
    if structure.timeless() {
        writeln!(report, "- the clock: H does not depend on time");
    }
    if !structure.cyclic.is_empty() {
        writeln!(report, "- the force on {}: it is zero", report.names(Symbol::Momentum, &structure.cyclic));
    }
    writeln!(report, "- recomputing what depends on parameters and the step size: prepared once");
    match structure.split {
        // The sections on damping and forces have stated that kick and drift do not exist.
        _ if !structure.conservative() => {}
        Split::Coupled(_) => writeln!(report, "- kick and drift: they do not exist for this H"),
        _ if structure.quadratic_parts().is_none() => {
            writeln!(report, "- Runge–Kutta–Nyström tables: they need a quadratic T");
        }
        _ => {}
    }
}

/// Reports A with an exact flow and the rest B.
fn perturbed(report: &mut Report<'_>, parts: &Perturbed) {
    writeln!(report, "\nA + B, an exact flow and a kick (`Perturbation`, `WisdomHolman`, `Aba10_6_4` …)");
    if let Some(inner) = &parts.inner {
        writeln!(report, "- in {}", inner.name);
    }
    writeln!(report, "- A = {}", report.excerpt(parts.a));
    for known in &parts.rules {
        writeln!(report, "  {known}");
    }
    writeln!(report, "  {}", parts.flow_of_a.kernel.operations());
    writeln!(report, "- B = {}", report.excerpt(parts.b));
    writeln!(report, "  {}", parts.flow_of_b.kernel.operations());
    match (parts.b_is_kick, parts.b_is_exact) {
        (true, _) => {}
        (false, true) => {
            writeln!(report, "  a motion of all bodies alike and a kick, which leave each other as they are")
        }
        (false, false) => writeln!(report, "  half of the motion, the kick, half of the motion: a step of order 2"),
    }
    match &parts.gradient_kick {
        Ok(_) => writeln!(report, "- tables of Runge–Kutta–Nyström type and with force gradients keep their order"),
        Err(missing) => {
            let term = report.excerpt(missing.term);
            writeln!(report, "- no tables of Runge–Kutta–Nyström type and with force gradients, because of {term}")
        }
    }
}

/// Reports the costs of implicit steps, and their solver.
fn implicit(report: &mut Report<'_>, field: &FieldKernels) {
    writeln!(report, "- stage of a Newton iteration of collocation: {}", field.collocation.kernel.operations());
    // Invariant: every canonical system has a discrete gradient. The condition is for fields, which may keep nothing, and share this struct.
    if let Some(discrete) = &field.discrete {
        writeln!(report, "- Newton iteration of the discrete gradient: {}", discrete.operations());
    }
    let unknowns = field.coordinates.len();
    let solver =
        if field.linear { "the equation is linear, its matrix inverted once".into() } else { solver(unknowns) };
    writeln!(report, "\nImplicit steps\n- `DiscreteGradient`, unknowns {unknowns}: {solver}")
}

/// Reports integrals of the flow, and the integrals that discrete gradients keep.
fn conserved(report: &mut Report<'_>, structure: &Structure) {
    let Structure { cyclic, resting, momenta, .. } = structure;
    let mut lines = vec![];
    if structure.conserves_energy() {
        lines.push("the energy".into());
    }
    let [q, p]: [fn(u32) -> Symbol; 2] = [Symbol::Position, Symbol::Momentum];
    for (kept, unread, indices) in [(p, q, cyclic), (q, p, resting)] {
        if !indices.is_empty() {
            lines.push(format!("{}: H does not read {}", report.names(kept, indices), report.names(unread, indices)));
        }
    }
    lines.extend(momenta.iter().map(|momentum| report.momentum(momentum)));
    writeln!(report, "\nConserved by the flow, at least");
    report.conserved(&lines);

    let conservative = structure.conservative();
    // The heading needs at least one of the lines below: each term of this condition is the condition of one of them.
    if !lines.is_empty() || structure.switches || conservative {
        writeln!(report, "\nDiscrete gradients");
    }
    if !lines.is_empty() {
        let methods = if conservative { " and `FourthOrder(DiscreteGradient)` keep" } else { " keeps" };
        writeln!(report, "- `DiscreteGradient`{methods} all of that, to rounding");
        if conservative && structure.autonomous && !momenta.is_empty() {
            writeln!(
                report,
                "- on an orbit on which the gradient of a momentum depends on that of H all along, as on a circle, \
                 `FourthOrder(DiscreteGradient)` keeps H alone"
            );
        }
    }
    if structure.switches {
        writeln!(
            report,
            "- across an `if` that is on different sides at both ends of a step they take the secant of the whole `if`"
        );
    }
    // `MeanValue` needs a conservative system.
    if conservative {
        mean_value(report, structure.mean_value);
    }
}

/// Reports how `MeanValue` computes the mean of the gradient over a step.
fn mean_value(report: &mut Report<'_>, mean_value: MeanValue) {
    match mean_value {
        MeanValue::Parts(1) => writeln!(report, "- `MeanValue` has a closed form: it is `DiscreteGradient`"),
        MeanValue::Parts(parts) => {
            writeln!(report, "- `MeanValue::<{parts}>` is exact: `DiscreteGradient` over parts of a step, extrapolated")
        }
        MeanValue::Gauss(points) => {
            writeln!(report, "- `MeanValue::<{points}>` is exact: Gauss points for a polynomial");
        }
        MeanValue::NotClosed(term) => {
            let term = report.excerpt(term);
            writeln!(
                report,
                "- `MeanValue::<N>` is a quadrature with N Gauss points: no closed form was found for {term}"
            );
        }
    }
}

/// The largest number of characters of a derivative that is printed whole. A longer formula would fill the screen.
const MOST_CHARACTERS: usize = 400;

/// Returns the formula of a derivative. Cuts it to the length of a message if it has more than [`MOST_CHARACTERS`].
fn formula(report: &Report<'_>, id: Id) -> String {
    let formula = report.formula(id);
    if formula.chars().count() > MOST_CHARACTERS { Printer::cut(formula) } else { formula }
}
