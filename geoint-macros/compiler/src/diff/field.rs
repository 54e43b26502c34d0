//! The differential equation as implicit methods solve it: y' = f(y) and its derivative, with derivatives of H and with
//! divided differences.
//!
//! f = (J − R)∇H with R = diag(0, C) for damping C, and with other forces. If nothing is damped and T is quadratic, it is one of second order in q,
//! with the force f = −∂V/∂q: T is then the same for every method.

use super::forward::jacobian;
use super::gradient::{Gradient, discrete_gradient};
use super::slope::coordinate_increment;
use crate::analyze::Structure;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// f and its derivative.
#[derive(Debug)]
pub(crate) struct Field {
    /// y; or its increment, between whose ends divided differences are taken.
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) f: Vec<Id>,
    /// ∂fᵢ/∂unknownⱼ, a row an entry of f.
    pub(crate) jacobian: Vec<Vec<Id>>,
}

/// What T adds to an equation of second order, as functions of the momenta.
#[derive(Debug)]
pub(crate) struct SecondOrder {
    /// ∂T/∂p.
    pub(crate) velocity: Vec<Id>,
    /// M⁻¹.
    pub(crate) inverse_mass: Vec<Vec<Id>>,
    /// M⁻¹p.
    pub(crate) acceleration: Vec<Id>,
}

/// f at a point.
pub(crate) fn field(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Field {
    let f = rates(graph, gradient, structure);
    let unknowns = unknowns(structure, degrees, Symbol::Position, Symbol::Momentum);
    let mut jacobian = jacobian(graph, &f, &unknowns);
    if structure.conservative() {
        share(graph, &mut jacobian, structure.reduced().is_some());
    }
    Field { unknowns, f, jacobian }
}

/// The right-hand side alone: of an equation of second order the force.
pub(crate) fn rates(graph: &mut Graph, gradient: &Gradient, structure: &Structure) -> Vec<Id> {
    right_side(graph, gradient, structure, |_, entry| entry)
}

/// ∇²H is symmetric: of two equal derivatives, which may be written differently, one is computed.
fn share(graph: &mut Graph, jacobian: &mut [Vec<Id>], second_order: bool) {
    let n = if second_order { jacobian.len() } else { jacobian.len() / 2 };
    for i in 0..n {
        for j in 0..n {
            if second_order {
                if i < j {
                    jacobian[i][j] = jacobian[j][i];
                }
                continue;
            }
            jacobian[i][j] = graph.neg(jacobian[n + j][n + i]);
            if i < j {
                jacobian[i][n + j] = jacobian[j][n + i];
                jacobian[n + i][j] = jacobian[n + j][i];
            }
        }
    }
}

/// f between two points, with the tree discrete gradient, and damping at their mean (time is that of the mean already).
pub(crate) fn discrete(graph: &mut Graph, structure: &Structure, degrees: u32) -> Field {
    let root = structure.reduced().map_or(structure.energy, |parts| parts.potential);
    let gradient = discrete_gradient(graph, root, degrees);
    let mut mean = Substitution::new(middle);
    let f = right_side(graph, &gradient, structure, |graph, entry| mean.apply(graph, entry));
    let unknowns = unknowns(structure, degrees, Symbol::PositionIncrement, Symbol::MomentumIncrement);
    let jacobian = jacobian(graph, &f, &unknowns);
    Field { unknowns, f, jacobian }
}

/// A coordinate in the middle of a step.
pub(crate) fn middle(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    let increment = coordinate_increment(graph, symbol)?;
    let (start, half) = (graph.symbol(symbol), graph.scale(Number::HALF, increment));
    Some(graph.add(start, half))
}

/// A coordinate at the end of a step.
pub(crate) fn end(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    let increment = coordinate_increment(graph, symbol)?;
    let start = graph.symbol(symbol);
    Some(graph.add(start, increment))
}

/// −∇_qH if that is enough; or (J − R)∇H, with entries of C where `at` puts them.
fn right_side(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    mut at: impl FnMut(&mut Graph, Id) -> Id,
) -> Vec<Id> {
    let mut force: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    if structure.reduced().is_some() {
        return force;
    }
    if let Some(damping) = &structure.damping {
        let matrix: Vec<Vec<Id>> =
            damping.matrix.iter().map(|row| row.iter().map(|entry| at(graph, *entry)).collect()).collect();
        for (i, force) in force.iter_mut().enumerate() {
            for (j, velocity) in gradient.p.iter().enumerate() {
                let coefficient = taking(graph, &matrix, i, j);
                let drag = graph.mul(coefficient, *velocity);
                *force = graph.sub(*force, drag);
            }
        }
    }
    if let Some(forces) = &structure.forces {
        for (force, other) in force.iter_mut().zip(forces.at(graph, &gradient.p, at)) {
            *force = graph.add(*force, other);
        }
    }
    [gradient.p.clone(), force].concat()
}

/// Cᵢⱼ where it takes energy, as far as that is seen in two coordinates: not a number where it feeds some.
pub(crate) fn taking(graph: &mut Graph, matrix: &[Vec<Id>], i: usize, j: usize) -> Id {
    let [entry, first, second] = [matrix[i][j], matrix[i][i], matrix[j][j]];
    // Numbers have been checked.
    if graph.is_zero(entry) || [entry, first, second].iter().all(|id| graph.as_number(*id).is_some()) {
        return entry;
    }
    if i == j {
        return graph.call(Function::NotNegative, &[entry]);
    }
    let bound = graph.mul(first, second);
    graph.call(Function::Bounded, &[entry, bound])
}

fn unknowns(structure: &Structure, degrees: u32, q: fn(u32) -> Symbol, p: fn(u32) -> Symbol) -> Vec<Symbol> {
    let momenta = if structure.reduced().is_some() { 0 } else { degrees };
    (0..degrees).map(q).chain((0..momenta).map(p)).collect()
}

/// What T adds, if it is quadratic.
pub(crate) fn second_order(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    degrees: u32,
) -> Option<SecondOrder> {
    structure.reduced()?;
    let momenta: Vec<Symbol> = (0..degrees).map(Symbol::Momentum).collect();
    let inverse_mass = jacobian(graph, &gradient.p, &momenta);
    let row = |row: &Vec<Id>| {
        let mut terms = vec![];
        for (entry, momentum) in row.iter().zip(&momenta) {
            let momentum = graph.symbol(*momentum);
            terms.push(graph.mul(*entry, momentum));
        }
        graph.sum(&terms)
    };
    let acceleration = inverse_mass.iter().map(row).collect();
    Some(SecondOrder { velocity: gradient.p.clone(), inverse_mass, acceleration })
}
