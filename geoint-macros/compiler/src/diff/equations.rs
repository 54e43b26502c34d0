//! The equations of motion of every form of mechanics, as code.
//!
//! The derivatives in them may be taken at a point, or be divided differences between two points.

use super::gradient::Gradient;
use crate::analyze::{Damping, Forces, Structure};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Symbol};

/// Time derivatives of the coordinates.
pub(crate) struct Rates {
    pub(crate) q: Vec<Id>,
    pub(crate) p: Vec<Id>,
    /// Present if the system has an action.
    pub(crate) s: Option<Id>,
}

impl Rates {
    /// All rates in the order q, p, s.
    pub(crate) fn concat(self) -> Vec<Id> {
        self.q.into_iter().chain(self.p).chain(self.s).collect()
    }
}

/// Hamilton's equations with damping C and forces F:
///
/// q' = ∂H/∂p,
/// p' = −∂H/∂q − C ∂H/∂p + F.
///
/// `place` moves entries of C and F to the point of evaluation.
pub(crate) fn hamilton(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    mut place: impl FnMut(&mut Graph, Id) -> Id,
) -> Rates {
    let mut force: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    if let Some(damping) = &structure.damping {
        for (force, drag) in force.iter_mut().zip(drag(graph, &damping.matrix, &gradient.p, &mut place)) {
            *force = drag.into_iter().fold(*force, |force, term| graph.sub(force, term));
        }
    }
    if let Some(forces) = &structure.forces {
        let forces = forces.at(graph, &gradient.p, place);
        add(graph, &mut force, &forces);
    }
    Rates { q: gradient.p.clone(), p: force, s: None }
}

/// The equations of a contact Hamiltonian H(q, p, s, t):
///
/// q' = ∂H/∂p,
/// p' = −∂H/∂q − p ∂H/∂s,
/// s' = p̄·∂H/∂p − H.
///
/// Steps of an integrator may take the momenta p and p̄ at different points.
pub(crate) fn contact(graph: &mut Graph, energy: Id, gradient: &Gradient, p: &[Id], mean_p: &[Id]) -> Rates {
    let force = gradient.q.iter().zip(p).map(|(by_q, p)| contact_force(graph, *by_q, *p, gradient.s)).collect();
    let power = graph.dot(mean_p, &gradient.p);
    Rates { q: gradient.p.clone(), p: force, s: Some(graph.sub(power, energy)) }
}

/// One entry of p' = −∂H/∂q − p ∂H/∂s.
pub(crate) fn contact_force(graph: &mut Graph, by_q: Id, p: Id, by_s: Id) -> Id {
    graph.build(-(by_q + p * by_s))
}

/// The equations of a contact Hamiltonian with damping C and forces F: p' = −∂H/∂q − p ∂H/∂s + F − C ∂H/∂p.
pub(crate) fn forced_contact(
    graph: &mut Graph,
    energy: Id,
    gradient: &Gradient,
    damping: Option<&Damping>,
    forces: Option<&Forces>,
) -> Rates {
    let p = momenta(graph, gradient);
    let mut rates = contact(graph, energy, gradient, &p, &p);
    if let Some(forces) = forces {
        let forces = forces.at(graph, &gradient.p, |_, force| force);
        add(graph, &mut rates.p, &forces);
    }
    if let Some(damping) = damping {
        for (rate, drag) in rates.p.iter_mut().zip(damping.drag(graph, &gradient.p)) {
            *rate = graph.sub(*rate, drag);
        }
    }
    rates
}

/// The equations of a lift, a contact Hamiltonian affine in p whose momenta are not followed:
///
/// q' = ∂H/∂p,
/// p' = 0,
/// s' = −H at p = 0.
pub(crate) fn lift(graph: &mut Graph, energy: Id, gradient: &Gradient) -> Rates {
    let zero = graph.zero();
    let at_rest = Substitution::new(|_: &mut Graph, symbol| matches!(symbol, Symbol::Momentum(_)).then_some(zero))
        .apply(graph, energy);
    Rates { q: gradient.p.clone(), p: vec![zero; gradient.p.len()], s: Some(graph.neg(at_rest)) }
}

/// The equations of a structure matrix S(x): x' = S(x) ∇H.
pub(crate) fn structured(graph: &mut Graph, matrix: &[Vec<Id>], slopes: &[Id]) -> Vec<Id> {
    times(graph, matrix, slopes)
}

/// The Euler–Lagrange equation with damping C and forces F: d/dt ∂L/∂v = ∂L/∂q − Cv + F.
///
/// `place` moves entries of C and F to the point of evaluation.
pub(crate) fn euler_lagrange(
    graph: &mut Graph,
    by_q: &[Id],
    velocities: &[Id],
    damping: Option<&[Vec<Id>]>,
    forces: Option<&Forces>,
    mut place: impl FnMut(&mut Graph, Id) -> Id,
) -> Vec<Id> {
    let mut rates = by_q.to_vec();
    if let Some(matrix) = damping {
        for (rate, drag) in rates.iter_mut().zip(drag(graph, matrix, velocities, &mut place)) {
            let terms: Vec<Id> = drag.into_iter().map(|term| graph.neg(term)).collect();
            *rate = graph.sum(&[&[*rate], &terms[..]].concat());
        }
    }
    if let Some(forces) = forces {
        let forces = forces.at(graph, velocities, place);
        add(graph, &mut rates, &forces);
    }
    rates
}

/// Herglotz's equation for a Lagrangian L(q, v, s, t) with s' = L, one entry of d/dt ∂L/∂v = ∂L/∂q + ∂L/∂v ∂L/∂s.
pub(crate) fn herglotz(graph: &mut Graph, by_q: Id, by_v: Id, by_s: Id) -> Id {
    graph.build(by_q + by_s * by_v)
}

/// The momenta p as symbols.
pub(crate) fn momenta(graph: &mut Graph, gradient: &Gradient) -> Vec<Id> {
    (0..gradient.p.len() as u32).map(|i| graph.symbol(Symbol::Momentum(i))).collect()
}

/// The terms of every entry of Cv.
fn drag(
    graph: &mut Graph,
    matrix: &[Vec<Id>],
    velocities: &[Id],
    place: &mut impl FnMut(&mut Graph, Id) -> Id,
) -> Vec<Vec<Id>> {
    let matrix: Vec<Vec<Id>> =
        matrix.iter().map(|row| row.iter().map(|entry| place(graph, *entry)).collect()).collect();
    let mut term = |i: usize, j: usize, v: Id| {
        let entry = checked_damping(graph, &matrix, i, j);
        graph.mul(entry, v)
    };
    (0..matrix.len()).map(|i| velocities.iter().enumerate().map(|(j, v)| term(i, j, *v)).collect()).collect()
}

/// The entry Cᵢⱼ, which is NaN at run time if the block of C for coordinates i and j is not positive semidefinite.
pub(crate) fn checked_damping(graph: &mut Graph, matrix: &[Vec<Id>], i: usize, j: usize) -> Id {
    let [entry, first, second] = [matrix[i][j], matrix[i][i], matrix[j][j]];
    // Blocks of numbers have been checked before.
    if graph.is_zero(entry) || [entry, first, second].iter().all(|id| graph.as_number(*id).is_some()) {
        return entry;
    }
    if i == j {
        return graph.call(Function::NotNegative, &[entry]);
    }
    let bound = graph.mul(first, second);
    graph.call(Function::Bounded, &[entry, bound])
}

/// Adds one vector to another.
fn add(graph: &mut Graph, vector: &mut [Id], other: &[Id]) {
    for (entry, other) in vector.iter_mut().zip(other) {
        *entry = graph.add(*entry, *other);
    }
}

/// The product of a matrix and a vector.
pub(crate) fn times(graph: &mut Graph, matrix: &[Vec<Id>], vector: &[Id]) -> Vec<Id> {
    matrix.iter().map(|row| graph.dot(row, vector)).collect()
}
