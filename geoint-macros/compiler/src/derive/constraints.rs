//! What is derived from H(q, p, t) with constraints g(q) = 0.

use super::domain::{Domain, Roots};
use super::system::{ConstraintKernels, Implicit, Missing, StepKernel, System};
use crate::analyze::{self, Structure};
use crate::diff::constraint::{self, Constrained, Equation};
use crate::diff::{self, Gradient, field, jacobian};
use crate::ir::{Function, Graph, Id, Partial, Symbol};
use crate::messages::CONSTRAINED;
use crate::parse::Form;
use crate::schedule::{Kernel, Levels};

/// Derives everything that both methods need.
pub(crate) fn constrained(
    graph: &mut Graph,
    structure: &Structure,
    constraints: &[Id],
    partial: &[Partial],
    degrees: u32,
) -> (System, Gradient) {
    let n = degrees as usize;
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let (at_point, between) =
        (field::field(graph, &gradient, structure, degrees), field::discrete(graph, structure, degrees));
    // Where T is quadratic and nothing is damped, the field is the force alone.
    let reduced = structure.reduced().is_some();
    let first = if reduced { 0 } else { n };
    let (force, mean_force) = (&at_point.f[first..], &between.f[first..]);
    let mean_velocity = (!reduced).then(|| &between.f[..n]);
    let given = Constrained::new(graph, constraints, &gradient.p, force, mean_force, mean_velocity);
    let rates = given.rates(graph);
    let steps =
        [("Rattle", constraint::rattle(graph, &given)), ("DiscreteGradient", constraint::gradient(graph, &given))];
    let steps = steps.into_iter().map(|(method, equation)| (method, step(graph, equation))).collect();
    let (own, bound) = (sizes(graph, constraints), given.sizes(graph));
    let reaches: Vec<Id> = own.iter().zip(&bound).map(|(own, bound)| graph.add(*own, *bound)).collect();
    let departure = [constraints.to_vec(), reaches, rates.clone(), sizes(graph, &rates)].concat();
    let one = |roots: Vec<Id>| Kernel::new(Levels::One, roots);
    let velocity = [gradient.p.clone(), given.inverse_mass.concat()].concat();
    let kernels = ConstraintKernels {
        quadratic: analyze::is_polynomial_in(graph, &gradient.p, 1, |symbol| matches!(symbol, Symbol::Momentum(_))),
        values: one([constraints.to_vec(), given.gradients.concat()].concat()),
        velocity: one(velocity),
        departure: one(departure),
        steps,
        constraints: constraints.to_vec(),
    };
    let roots = [&[structure.energy], constraints].concat();
    let system = System {
        facts: vec![],
        value: Some(one(vec![structure.energy])),
        slopes: None,
        rate: None,
        splitting: Some(Err(Missing { marker: "Unconstrained", term: constraints[0], why: CONSTRAINED, pair: None })),
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
            (structure.damping.as_ref(), &[]),
        ),
    };
    (system, gradient)
}

/// Residual and derivative, what a solution adds, and the origin of unknowns.
fn step(graph: &mut Graph, Equation { unknowns, residual, end, origin }: Equation) -> StepKernel<Kernel> {
    let matrix = jacobian(graph, &residual, &unknowns).concat();
    let kernel = Kernel { levels: Levels::Iterated, routines: vec![[residual, matrix].concat(), end, origin] };
    StepKernel { unknowns, kernel }
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
