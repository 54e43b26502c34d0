//! Facts about H(q, p, t), in words.

use super::{Report, counted, friction, pieces};
use crate::analyze::{MeanValue, Split, Structure};
use crate::derive::{Fact, FieldKernels, Kernels, MOST_UNKNOWNS, Perturbed, System};
use crate::diff::Gradient;
use crate::ir::{Id, Symbol, print::Printer};
use crate::parse::Role;

/// Lines are short enough for a terminal unless a formula is not.
pub(super) fn report(report: &mut Report<'_>, structure: &Structure, gradient: &Gradient, system: &System) {
    let (q, p) = (report.name_of(Role::Position), report.name_of(Role::Momentum));
    writeln!(report, "H = {}", report.formula(structure.energy));
    for (symbol, slopes) in [(Symbol::Position as fn(u32) -> Symbol, &gradient.q), (Symbol::Momentum, &gradient.p)] {
        for (i, slope) in (0..).zip(slopes) {
            writeln!(report, "∂H/∂{} = {}", report.named(symbol(i)), formula(report, *slope));
        }
    }

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
    let reads_time = if structure.autonomous { "does not depend" } else { "depends" };
    writeln!(report, "- H {reads_time} on time");

    if let Some(damping) = &structure.damping {
        friction::damping(report, damping, structure.autonomous);
    }
    if let Some(forces) = &structure.forces {
        friction::forces(report, forces, structure.autonomous);
    }

    conserved(report, structure);

    for found in &system.pieces {
        writeln!(report, "\nPieces with flows in closed form, in the order of half a step of `PieceSplitting`");
        pieces::of_energy(report, found, pieces::Alphabet::Canonical);
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
        writeln!(report, "- gradient of H: {}", counted(slopes.operations()));
    }
    if let Some(Ok(flows)) = &system.splitting {
        writeln!(report, "- kick: {}", counted(flows.kick.kernel.operations()));
        writeln!(report, "- drift: {}", counted(flows.drift.kernel.operations()));
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
    if structure.timeless() {
        writeln!(report, "- the clock: H does not depend on time");
    }
    if !structure.cyclic.is_empty() {
        writeln!(report, "- the force on {}: it is zero", listed(report, Symbol::Momentum, &structure.cyclic));
    }
    writeln!(report, "- recomputing what depends on parameters and the step size: prepared once");
    match structure.split {
        _ if !structure.conservative() => {}
        Split::Coupled(_) => writeln!(report, "- kick and drift: they do not exist for this H"),
        _ if structure.quadratic_parts().is_none() => {
            writeln!(report, "- Runge–Kutta–Nyström tables: they need a quadratic T");
        }
        _ => {}
    }
}

/// The part with an exact flow, and the rest.
fn perturbed(report: &mut Report<'_>, parts: &Perturbed) {
    writeln!(report, "\nA + B, an exact flow and a kick (`Perturbation`, `WisdomHolman`, `Aba10_6_4` …)");
    if let Some(inner) = &parts.inner {
        writeln!(report, "- in {}", inner.name);
    }
    writeln!(report, "- A = {}", report.excerpt(parts.exact));
    for known in &parts.known {
        writeln!(report, "  {known}");
    }
    writeln!(report, "  {}", counted(parts.flow.kernel.operations()));
    writeln!(report, "- B = {}", report.excerpt(parts.rest));
    writeln!(report, "  {}", counted(parts.kick.kernel.operations()));
    match (parts.is_kick, parts.is_exact) {
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

/// What implicit steps cost, and how they are solved.
fn implicit(report: &mut Report<'_>, field: &FieldKernels) {
    writeln!(
        report,
        "- stage of a Newton iteration of collocation: {}",
        counted(field.collocation.kernel.operations())
    );
    if let Some(discrete) = &field.discrete {
        writeln!(report, "- Newton iteration of the discrete gradient: {}", counted(discrete.operations()));
    }

    writeln!(report, "\nImplicit steps");
    let unknowns = field.coordinates.len();
    let solver = match unknowns {
        _ if field.linear => "the equation is linear, its matrix inverted once".into(),
        1 => "Newton's iteration for one number".into(),
        2..=MOST_UNKNOWNS => "Newton's iteration with elimination".into(),
        _ => format!(
            "the fixed point while it attracts, Newton's iteration elsewhere: measured to be faster beyond {MOST_UNKNOWNS}"
        ),
    };
    writeln!(report, "- `DiscreteGradient`, unknowns {unknowns}: {solver}")
}

/// Names of coordinates, separated by commas.
fn listed(report: &Report<'_>, symbol: fn(u32) -> Symbol, indices: &[u32]) -> String {
    indices.iter().map(|i| report.named(symbol(*i))).collect::<Vec<_>>().join(", ")
}

/// Integrals of the flow, and those that discrete gradients keep.
fn conserved(report: &mut Report<'_>, structure: &Structure) {
    let mut lines = vec![];
    if structure.conserves_energy() {
        lines.push("the energy".into());
    }
    let unread = [
        (Symbol::Momentum as fn(u32) -> Symbol, Symbol::Position as fn(u32) -> Symbol, &structure.cyclic),
        (Symbol::Position, Symbol::Momentum, &structure.resting),
    ];
    for (kept, unread, indices) in unread.into_iter().filter(|(.., indices)| !indices.is_empty()) {
        lines.push(format!("{}: H does not read {}", listed(report, kept, indices), listed(report, unread, indices)));
    }
    let momenta = structure.momenta.iter();
    lines.extend(momenta.map(|momentum| format!("{}: {}", momentum.name, report.excerpt(momentum.value))));
    writeln!(report, "\nConserved by the flow, at least");
    for line in &lines {
        writeln!(report, "- {line}");
    }
    if lines.is_empty() {
        writeln!(report, "- nothing that was found");
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
                let term = report.excerpt(term);
                format!("`MeanValue::<N>` is a quadrature with N Gauss points: no closed form was found for {term}")
            }
        });
    }
    if !discrete.is_empty() {
        writeln!(report, "\nDiscrete gradients");
    }
    for line in &discrete {
        writeln!(report, "- {line}");
    }
}

/// A derivative, written out unless it fills the screen.
fn formula(report: &Report<'_>, id: Id) -> String {
    let formula = report.formula(id);
    if formula.chars().count() > 400 { Printer::cut(formula) } else { formula }
}
