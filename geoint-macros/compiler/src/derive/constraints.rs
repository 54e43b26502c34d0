//! Routines of H(q, p, t) with constraints, and of H₀(q, p, t) + γ(t)·s with constraints of positions.

use super::domain::{Domain, Formulas};
use super::system::{ConstraintKernels, Kernels, Missing, StepKernel, System};
use crate::analyze::{self, Structure};
use crate::compilation::Compilation;
use crate::diff::constraint::{self, Action, Constrained, Damping, Equation, Momenta, Row};
use crate::diff::{Gradient, field, jacobian};
use crate::ir::{Function, Graph, Id, Symbol, UndefinedAt};
use crate::messages::CONSTRAINED;
use crate::schedule::{Kernel, Levels, Output, Routine, Space, phase};

/// Derives the routines of every method. `structure` is that of H₀ beside an action.
pub(crate) fn constrained(
    compilation: &mut Compilation<'_>,
    structure: &Structure,
    rows: &[Row],
    gradient: &Gradient,
    action: Option<Action>,
    partial: &[UndefinedAt],
) -> System {
    let (degrees, positions, graph) = (compilation.degrees(), compilation.positions(), &mut compilation.graph);
    let at_point = field::field(graph, gradient, structure, degrees);
    let between = field::discrete(graph, structure, degrees);
    let n = degrees as usize;
    let (force, mean_force, mean_velocity) = (at_point.force(n), between.force(n), between.velocity(n));
    let given = Constrained { action, ..Constrained::new(graph, rows, &gradient.p, force, mean_force, mean_velocity) };
    let rates = given.rates(graph);
    let quadratic = analyze::is_polynomial_in(graph, &gradient.p, 1, |symbol| matches!(symbol, Symbol::Momentum(_)));
    let momenta = if quadratic { Momenta::Tangent } else { Momenta::Carried };
    let discrete = constraint::discrete_gradient_step(graph, &given, momenta);
    let mut steps = vec![];
    // RATTLE is for constraints of positions.
    if rows.iter().all(|row| row.value.is_some()) {
        let rattle = constraint::rattle(graph, &given);
        match action {
            None => steps.push(("Rattle", rattle)),
            Some(Action { decay, .. }) => {
                steps.push(("ContactSplitting", rattle.clone().damped(graph, Damping::Exponential, decay)));
                steps.push(("ContactLeapfrog", rattle.damped(graph, Damping::Trapezoidal, decay)));
            }
        }
    }
    steps.push((if action.is_none() { "DiscreteGradient" } else { "ContactDiscreteGradient" }, discrete));
    let steps = steps.into_iter().map(|(method, equation)| (method, step(graph, equation, &positions))).collect();
    let zero = graph.zero();
    // Only velocities are bound by a row without a function of positions: its value is always 0.
    let values: Vec<Id> = rows.iter().map(|row| row.value.unwrap_or(zero)).collect();
    let (own, bound) = (sizes(graph, &values), given.sizes(graph));
    let reaches: Vec<Id> = own.iter().zip(&bound).map(|(own, bound)| graph.add(*own, *bound)).collect();
    let departure = [values.clone(), reaches, rates.clone(), sizes(graph, &rates)].concat();
    let m = rows.len();
    let multipliers = given.multipliers(graph);
    let drifts = rows.iter().map(|row| row.drift).collect();
    // Positions of other rows would leave their constraints, which these rates keep to the error of a method only.
    let rate = rows.iter().all(|row| row.value.is_none()).then(|| {
        let rates = [gradient.p.clone(), given.bound_force(graph, &multipliers)].concat();
        Routine::array("rate", "slopes", &phase(&positions), rates)
    });
    let values = vec![
        Output::row("values", values),
        Output::array("gradients", &[&[m], &positions[..]].concat(), given.gradients().concat()),
        Output::row("drifts", drifts),
    ];
    let velocity = vec![
        Output::array("velocity", &positions, gradient.p.clone()),
        Output::square("inverse_mass", &positions, &given.inverse_mass),
    ];
    let kernels = ConstraintKernels {
        quadratic,
        values: Routine::new("constraints", values),
        velocity: Routine::new("velocity", velocity),
        departure: Routine::array("departure", "departure", &[2, 2, m], departure),
        multipliers: Routine::row("multipliers", given.shown(graph, &multipliers)),
        steps,
        rows: rows.to_vec(),
    };
    let energy = match action {
        Some(Action { energy, decay }) => {
            let s = graph.symbol(Symbol::Action);
            graph.build(energy + decay * s)
        }
        None => structure.energy,
    };
    let formulas: Vec<Id> = [energy].into_iter().chain(rows.iter().map(|row| row.written)).collect();
    let formulas = Formulas { damping: structure.damping.as_ref(), ..Formulas::new(&formulas, partial) };
    System {
        value: Some(Routine::number("hamiltonian", energy)),
        rate,
        // No trait of contact systems can be absent with a reason: the methods of these names exist.
        splitting: action.is_none().then(|| Err(Missing::new("Unconstrained", rows[0].written, CONSTRAINED))),
        ..System::new(Kernels::Constrained(kernels), Domain::of(graph, compilation.form, formulas))
    }
}

/// Derives the residual and its derivative, the increments of a solution, and numbers with the rounding errors of the unknowns.
fn step(graph: &mut Graph, equation: Equation, positions: &[usize]) -> StepKernel {
    let Equation { unknowns, residual, end, action, origin } = equation;
    let matrix = jacobian(graph, &residual, &unknowns);
    let unknowns = Space::of_unknowns(unknowns, positions);
    let residual = Output::array("residual", &unknowns.extents, residual);
    let matrix = Output::square("matrix", &unknowns.extents, &matrix);
    let end = [Output::array("end", &phase(positions), end)];
    let end = end.into_iter().chain(action.map(|action| Output::number("action", action))).collect();
    let routines = [
        Routine::new("residual", vec![residual, matrix]),
        Routine::new("end", end),
        Routine::array("origin", "origin", &unknowns.extents, origin),
    ];
    let routines = routines.map(|routine| routine.reading("x", &unknowns)).to_vec();
    StepKernel { kernel: Kernel::new(Levels::Iterated, routines), unknowns }
}

/// Returns Σ |x ∂f/∂x| over coordinates and parameters x: the change of f by their rounding, in units of ε.
fn sizes(graph: &mut Graph, nodes: &[Id]) -> Vec<Id> {
    let mut size = |node: &Id| {
        let symbols = graph.symbols(*node);
        let slopes = jacobian(graph, &[*node], &symbols).concat();
        let mut terms = vec![];
        for (symbol, slope) in symbols.into_iter().zip(slopes) {
            let x = graph.symbol(symbol);
            let term = graph.mul(x, slope);
            terms.push(graph.call(Function::Abs, &[term]));
        }
        graph.sum(&terms)
    };
    nodes.iter().map(&mut size).collect()
}
