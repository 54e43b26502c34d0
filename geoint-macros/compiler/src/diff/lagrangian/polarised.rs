//! The polarised discrete gradient: a step of a Lagrangian quadratic in v, with d = v₁ − v₀ as unknown, or d = (v₁ − v₀, s₁ − s₀) with an action.

use super::super::equations;
use super::super::forward::jacobian;
use super::super::gradient::{Gradient, discrete_gradient, with_values};
use super::super::slope::coordinate_in_middle;
use super::{EulerLagrange, collect_terms, ends};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// The equation of a step, residual(d) = 0. It has one row for each momentum, and with an action one more for s.
pub(crate) struct Polarised {
    pub(crate) unknowns: Vec<Symbol>,
    /// M(q₁)v₁ + a(q₁) − p₀ − impulse. The row of the action is d − impulse.
    pub(crate) residual: Vec<Id>,
    /// The increments of the momenta, and of the action.
    pub(crate) impulse: Vec<Id>,
    /// ∂residual/∂d.
    pub(crate) matrix: Vec<Vec<Id>>,
    /// ∂impulse/∂d.
    pub(crate) impulse_by_increment: Vec<Vec<Id>>,
}

/// Builds the equation, and collects terms that differ in parameters alone.
///
/// Forces read the time of the middle of the step. With an action, the whole step does: see `PolarisedForm` of the runtime.
pub(crate) fn polarised(graph: &mut Graph, equation: EulerLagrange<'_>) -> Polarised {
    let EulerLagrange { damping, applied, has_action, .. } = equation;
    let degrees = equation.degrees();
    let mut unknowns: Vec<Symbol> = (0..degrees).map(Symbol::VelocityIncrement).collect();
    let h = graph.symbol(Symbol::StepLength);
    // t₁ = t + h/2 without an action.
    let end_time = (!has_action).then(|| {
        let t = graph.symbol(Symbol::Time);
        graph.build(t + Number::HALF * h)
    });
    let (ends, means) = (ends(graph, degrees), means(graph, degrees));
    let increments: Vec<Id> = means.iter().map(|mean| graph.mul(h, *mean)).collect();
    let polarised = polarisation(graph, equation);
    let Gradient { q, s, .. } = discrete_gradient(graph, polarised, degrees);
    let mut at_middle = Substitution::new(coordinate_in_middle);
    let forces = equations::euler_lagrange(graph, &q, &means, damping, applied, |graph, id| at_middle.apply(graph, id));
    let forces = with_values(graph, &forces, Symbol::PositionIncrement, &increments);
    let mut impulse: Vec<Id> = forces.iter().map(|force| graph.mul(h, *force)).collect();
    // h Λ_s, with the discrete derivative Λ_s of the polarisation by s.
    let growth = has_action.then(|| {
        let slope = with_values(graph, &[s], Symbol::PositionIncrement, &increments)[0];
        graph.mul(h, slope)
    });

    let momenta = momenta_at_end(graph, equation, &ends, &increments, end_time);
    let (mut residual, mut power) = (vec![], vec![]);
    for (i, (momentum, impulse)) in (0..).zip(momenta.iter().zip(&mut impulse)) {
        let p = graph.symbol(Symbol::Momentum(i));
        if let Some(growth) = growth {
            let mean = graph.build(Number::HALF * (p + *momentum));
            power.push(graph.mul(mean, means[i as usize]));
            *impulse = equations::herglotz(graph, *impulse, mean, growth);
        }
        let [p, impulse] = [p, *impulse].map(|id| graph.neg(id));
        residual.push(graph.sum(&[*momentum, p, impulse]));
    }
    if let Some(growth) = growth {
        let step = action_step(graph, equation, power, growth);
        let ds = graph.symbol(Symbol::ActionIncrement);
        residual.push(graph.sub(ds, step));
        impulse.push(step);
        unknowns.push(Symbol::ActionIncrement);
    }
    let [momenta_by_increment, impulse_by_increment] =
        [&momenta, &impulse].map(|values| jacobian(graph, values, &unknowns));
    // Both branches have the same value, but they write and round its sums differently.
    let matrix = if has_action {
        jacobian(graph, &residual, &unknowns)
    } else {
        let mut difference = |(end, impulse): (&Vec<Id>, &Vec<Id>)| {
            end.iter().zip(impulse).map(|(end, impulse)| graph.sub(*end, *impulse)).collect()
        };
        momenta_by_increment.iter().zip(&impulse_by_increment).map(&mut difference).collect()
    };
    let mut result = Polarised { unknowns, residual, impulse, matrix, impulse_by_increment };
    let Polarised { residual, impulse, matrix, impulse_by_increment, .. } = &mut result;
    let mut nodes: Vec<&mut Id> = residual.iter_mut().chain(impulse).collect();
    nodes.extend(matrix.iter_mut().chain(impulse_by_increment).flatten());
    let ends = ends::by_slopes(graph, equation, &increments);
    collect_terms(graph, nodes, &ends);
    result
}

/// The increment of the action, h (p̄·v̄ − H₀ φ₁(hΛ_s)) with H₀ = p₀·v₀ − L, from the terms of the power p̄·v̄ and from the growth hΛ_s.
fn action_step(graph: &mut Graph, equation: EulerLagrange<'_>, mut power: Vec<Id>, growth: Id) -> Id {
    let mean_growth = graph.call(Function::Phi1, &[growth]);
    let mut energy = vec![graph.neg(equation.lagrangian)];
    for i in 0..equation.degrees() {
        let [p, v] = [Symbol::Momentum(i), Symbol::Velocity(i)].map(|symbol| graph.symbol(symbol));
        energy.push(graph.mul(p, v));
    }
    let energy = graph.sum(&energy);
    power.push(graph.build(-(energy * mean_growth)));
    let power = graph.sum(&power);
    let h = graph.symbol(Symbol::StepLength);
    graph.mul(h, power)
}

/// M(q₁)v₁ + a(q₁), where M and a may read the action and time as well.
fn momenta_at_end(
    graph: &mut Graph,
    equation: EulerLagrange<'_>,
    velocities: &[Id],
    increments: &[Id],
    end_time: Option<Id>,
) -> Vec<Id> {
    let mut end = Substitution::new(|graph: &mut Graph, symbol| {
        let increment = match symbol {
            Symbol::Position(i) => increments[i as usize],
            Symbol::Action => graph.symbol(Symbol::ActionIncrement),
            Symbol::Time => return end_time,
            _ => return None,
        };
        let start = graph.symbol(symbol);
        Some(graph.add(start, increment))
    });
    let mut momentum = |(shift, row): (&Id, &Vec<Id>)| {
        let mut terms = vec![end.apply(graph, *shift)];
        for (entry, v) in row.iter().zip(velocities) {
            let entry = end.apply(graph, *entry);
            terms.push(graph.mul(entry, *v));
        }
        graph.sum(&terms)
    };
    equation.shift.iter().zip(equation.mass).map(&mut momentum).collect()
}

/// The velocities v₁ = v₀ + d at the end.
fn ends(graph: &mut Graph, degrees: u32) -> Vec<Id> {
    velocities(graph, degrees, Number::ONE)
}

/// The mean velocities v̄ = v₀ + d/2.
fn means(graph: &mut Graph, degrees: u32) -> Vec<Id> {
    velocities(graph, degrees, Number::HALF)
}

/// v₀ + part·d.
fn velocities(graph: &mut Graph, degrees: u32, part: Number) -> Vec<Id> {
    let mut velocity = |i| {
        let [start, d] = [Symbol::Velocity(i), Symbol::VelocityIncrement(i)].map(|symbol| graph.symbol(symbol));
        graph.build(start + part * d)
    };
    (0..degrees).map(&mut velocity).collect()
}

/// The polarisation Λ(q) = ½ v₀ᵀM(q)v₁ + a(q)·v̄ − V(q) of L, symmetric in v₀ and v₁.
pub(crate) fn polarisation(graph: &mut Graph, equation: EulerLagrange<'_>) -> Id {
    let EulerLagrange { mass, shift, potential, .. } = equation;
    let degrees = equation.degrees();
    let starts: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let (ends, means) = (ends(graph, degrees), means(graph, degrees));
    let mut terms = vec![graph.neg(potential)];
    for i in 0..starts.len() {
        terms.push(graph.mul(shift[i], means[i]));
        for j in 0..=i {
            let mut pair = graph.mul(starts[i], ends[j]);
            if i != j {
                pair = graph.build(pair + starts[j] * ends[i]);
            }
            terms.push(graph.build(mass[i][j] * (Number::HALF * pair)));
        }
    }
    graph.sum(&terms)
}
