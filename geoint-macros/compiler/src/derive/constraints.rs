//! What is derived from H(q, p, t) with constraints g(q) = 0.

use super::domain::{Domain, Friction, Roots};
use super::system::{ConstraintKernels, Implicit, Missing, StepKernel, System};
use crate::analyze::{self, Structure};
use crate::diff::constraint::{self, Constrained, Equation};
use crate::diff::{Gradient, field, jacobian};
use crate::ir::{Function, Graph, Id, Symbol, UndefinedAt};
use crate::messages::CONSTRAINED;
use crate::parse::Form;
use crate::schedule::{Kernel, Levels, Output, Routine, Space, phase};

/// Derives everything that both methods need.
pub(crate) fn constrained(
    graph: &mut Graph,
    structure: &Structure,
    constraints: &[Id],
    gradient: &Gradient,
    partial: &[UndefinedAt],
    positions: &[usize],
) -> System {
    let n = gradient.q.len();
    let degrees = n as u32;
    let (at_point, between) =
        (field::field(graph, gradient, structure, degrees), field::discrete(graph, structure, degrees));
    // Where T is quadratic and nothing is damped, the field is the force alone.
    let reduced = structure.reduced().is_some();
    let first = if reduced { 0 } else { n };
    let (force, mean_force) = (&at_point.f[first..], &between.f[first..]);
    let mean_velocity = (!reduced).then(|| &between.f[..n]);
    let given = Constrained::new(graph, constraints, &gradient.p, force, mean_force, mean_velocity);
    let rates = given.rates(graph);
    let steps =
        [("Rattle", constraint::rattle(graph, &given)), ("DiscreteGradient", constraint::gradient(graph, &given))];
    let steps = steps.into_iter().map(|(method, equation)| (method, step(graph, equation, positions))).collect();
    let (own, bound) = (sizes(graph, constraints), given.sizes(graph));
    let reaches: Vec<Id> = own.iter().zip(&bound).map(|(own, bound)| graph.add(*own, *bound)).collect();
    let departure = [constraints.to_vec(), reaches, rates.clone(), sizes(graph, &rates)].concat();
    let m = constraints.len();
    let values = vec![
        Output::row("values", constraints.to_vec()),
        Output::array("gradients", &[&[m], positions].concat(), given.gradients.concat()),
    ];
    let velocity = vec![
        Output::array("velocity", positions, gradient.p.clone()),
        Output::square("inverse_mass", positions, &given.inverse_mass),
    ];
    let kernels = ConstraintKernels {
        quadratic: analyze::is_polynomial_in(graph, &gradient.p, 1, |symbol| matches!(symbol, Symbol::Momentum(_))),
        values: Routine::new("constraints", values),
        velocity: Routine::new("velocity", velocity),
        departure: Routine::new("departure", vec![Output::array("departure", &[2, 2, m], departure)]),
        steps,
        constraints: constraints.to_vec(),
    };
    let roots = [&[structure.energy], constraints].concat();
    System {
        facts: vec![],
        value: Some(Routine::number("hamiltonian", structure.energy)),
        gradient: None,
        rate: None,
        splitting: Some(Err(Missing::new("Unconstrained", constraints[0], CONSTRAINED))),
        perturbed: None,
        modified: None,
        pieces: vec![],
        implicit: Implicit::Constrained(kernels),
        integrals: None,
        lagrangian: None,
        jet: None,
        domain: Domain::of(
            graph,
            Roots { all: &roots, divided: &roots },
            Form::Hamiltonian,
            partial,
            Friction { damping: structure.damping.as_ref(), rates: &[] },
        ),
    }
}

/// Residual and derivative, what a solution adds, and the origin of unknowns.
fn step(graph: &mut Graph, equation: Equation, positions: &[usize]) -> StepKernel {
    let Equation { unknowns, residual, end, origin } = equation;
    let matrix = jacobian(graph, &residual, &unknowns);
    let unknowns = Space::of_unknowns(unknowns, positions);
    let residual = Output::array("residual", &unknowns.extents, residual);
    let matrix = Output::square("matrix", &unknowns.extents, &matrix);
    let routines = [
        Routine::new("residual", vec![residual, matrix]),
        Routine::new("end", vec![Output::array("end", &phase(positions), end)]),
        Routine::new("origin", vec![Output::array("origin", &unknowns.extents, origin)]),
    ];
    let routines = routines.map(|routine| routine.reading("x", &unknowns)).to_vec();
    StepKernel { kernel: Kernel::new(Levels::Iterated, routines), unknowns }
}

/// Σ |x ∂f/∂x| over coordinates and parameters x: what rounding of these changes f by, in units of ε.
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
