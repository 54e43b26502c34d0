//! The equations of implicit steps of a Lagrangian, with velocities as unknowns.

mod action;
mod ends;

use super::field::{middle, taking};
use super::forward::jacobian;
use super::gradient::discrete_gradient;
use crate::analyze::Forces;
use crate::ir::collect::collected_with;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};
pub(crate) use action::{action_force, action_stage, decaying};

/// What is known of L(q, v, t), and of friction.
#[derive(Clone, Copy)]
pub(crate) struct Given<'a> {
    /// ∂L/∂q and ∂L/∂v.
    pub(crate) forces: &'a [Id],
    pub(crate) momenta: &'a [Id],
    /// M = ∂²L/∂v².
    pub(crate) mass: &'a [Vec<Id>],
    /// ∂L/∂v and −L at rest.
    pub(crate) shift: &'a [Id],
    pub(crate) potential: Id,
    /// C.
    pub(crate) damping: Option<&'a [Vec<Id>]>,
    pub(crate) others: Option<&'a Forces>,
}

impl Given<'_> {
    /// M, a and V.
    fn read(&self) -> Vec<Id> {
        self.mass.iter().flatten().chain(self.shift).chain([&self.potential]).copied().collect()
    }
}

/// f = ∂L/∂q − Cv, and other forces.
pub(crate) fn force(graph: &mut Graph, given: Given<'_>) -> Vec<Id> {
    let velocities: Vec<Id> = (0..given.forces.len() as u32).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let force = rubbed(graph, given.forces, given.damping, &velocities);
    pushed(graph, force, given.others, (&velocities, |_: &mut Graph, force| force))
}

/// ∂L/∂v, f, and the derivatives of both by q and v, one after the other.
pub(crate) fn stage(graph: &mut Graph, given: Given<'_>) -> Vec<Id> {
    let degrees = given.momenta.len() as u32;
    let force = force(graph, given);
    let positions: Vec<Symbol> = (0..degrees).map(Symbol::Position).collect();
    let velocities: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
    let momenta_by_q = jacobian(graph, given.momenta, &positions);
    let mut forces_by_q = jacobian(graph, &force, &positions);
    let mut forces_by_v = jacobian(graph, &force, &velocities);
    // Of equal derivatives, which may be written differently, one is computed.
    if given.damping.is_none() && given.others.is_none() {
        for i in 0..force.len() {
            for j in 0..force.len() {
                forces_by_v[i][j] = momenta_by_q[j][i];
                if i < j {
                    forces_by_q[i][j] = forces_by_q[j][i];
                }
            }
        }
    }
    let matrices = [momenta_by_q, given.mass.to_vec(), forces_by_q, forces_by_v].map(|matrix| matrix.concat());
    [given.momenta.to_vec(), force, matrices.concat()].concat()
}

/// The polarised discrete gradient with d = v₁ − v₀ for its unknown: M(q₁)v₁ + a(q₁) − p₁ and p₁ − p₀, then the derivatives of both. Time
/// is that of the middle of the step. Terms are collected.
pub(crate) fn polarised(graph: &mut Graph, given: Given<'_>) -> Vec<Id> {
    let degrees = given.momenta.len() as u32;
    let [h, t] = [Symbol::StepLength, Symbol::Time].map(|symbol| graph.symbol(symbol));
    let (ends, means) = (ends(graph, degrees), means(graph, degrees));
    let increments: Vec<Id> = means.iter().map(|mean| graph.mul(h, *mean)).collect();
    let polarised = polarisation(graph, given);
    let slopes = discrete_gradient(graph, polarised, degrees).q;
    let damping: Option<Vec<Vec<Id>>> = given.damping.map(|matrix| {
        let mut there = Substitution::new(middle);
        matrix.iter().map(|row| row.iter().map(|entry| there.apply(graph, *entry)).collect()).collect()
    });
    let force = rubbed(graph, &slopes, damping.as_deref(), &means);
    let mut there = Substitution::new(middle);
    let force = pushed(graph, force, given.others, (&means, |graph: &mut Graph, force| there.apply(graph, force)));
    let mut moved = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::PositionIncrement(i) => Some(increments[i as usize]),
        _ => None,
    });
    let mut scaled = |force: &Id| {
        let force = moved.apply(graph, *force);
        graph.mul(h, force)
    };
    let impulse: Vec<Id> = force.iter().map(&mut scaled).collect();

    // The momentum at the end, by L at its time.
    let half = graph.scale(Number::HALF, h);
    let late = graph.add(t, half);
    let mut end = Substitution::new(|graph: &mut Graph, symbol| match symbol {
        Symbol::Position(i) => {
            let q = graph.symbol(symbol);
            Some(graph.add(q, increments[i as usize]))
        }
        Symbol::Time => Some(late),
        _ => None,
    });
    let momenta = momenta(graph, given, &ends, |graph, node| end.apply(graph, node));
    let unknowns: Vec<Symbol> = (0..degrees).map(Symbol::VelocityIncrement).collect();
    let [by_d, impulse_by_d] = [&momenta, &impulse].map(|values| jacobian(graph, values, &unknowns).concat());
    let mut residual = vec![];
    for (i, (momentum, impulse)) in (0..).zip(momenta.iter().zip(&impulse)) {
        let p = graph.symbol(Symbol::Momentum(i));
        let [p, impulse] = [p, *impulse].map(|id| graph.neg(id));
        residual.push(graph.sum(&[*momentum, p, impulse]));
    }
    let matrix: Vec<Id> = by_d.iter().zip(&impulse_by_d).map(|(a, b)| graph.sub(*a, *b)).collect();
    let roots = [residual, impulse, matrix, impulse_by_d].concat();
    let ends = ends::by_slopes(graph, &given.read(), &increments);
    collected_with(graph, &roots, &ends)
}

/// M v + a at a place.
fn momenta(
    graph: &mut Graph,
    given: Given<'_>,
    velocities: &[Id],
    mut place: impl FnMut(&mut Graph, Id) -> Id,
) -> Vec<Id> {
    let mut momenta = vec![];
    for i in 0..velocities.len() {
        let mut terms = vec![place(graph, given.shift[i])];
        for (entry, v) in given.mass[i].iter().zip(velocities) {
            let entry = place(graph, *entry);
            terms.push(graph.mul(entry, *v));
        }
        momenta.push(graph.sum(&terms));
    }
    momenta
}

/// v₁ = v₀ + d.
fn ends(graph: &mut Graph, degrees: u32) -> Vec<Id> {
    let mut end = |i| {
        let [start, d] = [Symbol::Velocity(i), Symbol::VelocityIncrement(i)].map(|symbol| graph.symbol(symbol));
        graph.add(start, d)
    };
    (0..degrees).map(&mut end).collect()
}

/// v̄ = v₀ + d/2.
fn means(graph: &mut Graph, degrees: u32) -> Vec<Id> {
    let mut mean = |i| {
        let [start, d] = [Symbol::Velocity(i), Symbol::VelocityIncrement(i)].map(|symbol| graph.symbol(symbol));
        let half = graph.scale(Number::HALF, d);
        graph.add(start, half)
    };
    (0..degrees).map(&mut mean).collect()
}

/// Λ(q) = ½v₀ᵀM(q)v₁ + a(q)·v̄ − V(q), the same for both orders of v₀ and v₁.
pub(crate) fn polarisation(graph: &mut Graph, given: Given<'_>) -> Id {
    let degrees = given.momenta.len() as u32;
    let starts: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let (ends, means) = (ends(graph, degrees), means(graph, degrees));
    let mut terms = vec![graph.neg(given.potential)];
    for i in 0..starts.len() {
        terms.push(graph.mul(given.shift[i], means[i]));
        for j in 0..=i {
            let mut pair = graph.mul(starts[i], ends[j]);
            if i != j {
                let other = graph.mul(starts[j], ends[i]);
                pair = graph.add(pair, other);
            }
            let half = graph.scale(Number::HALF, pair);
            terms.push(graph.mul(given.mass[i][j], half));
        }
    }
    graph.sum(&terms)
}

/// Forces with others, at velocities.
fn pushed(
    graph: &mut Graph,
    forces: Vec<Id>,
    others: Option<&Forces>,
    (velocities, place): (&[Id], impl FnMut(&mut Graph, Id) -> Id),
) -> Vec<Id> {
    let Some(others) = others else { return forces };
    let others = others.at(graph, velocities, place);
    forces.into_iter().zip(others).map(|(force, other)| graph.add(force, other)).collect()
}

/// Forces less friction Cv.
fn rubbed(graph: &mut Graph, forces: &[Id], damping: Option<&[Vec<Id>]>, velocities: &[Id]) -> Vec<Id> {
    let Some(matrix) = damping else { return forces.to_vec() };
    let mut rubbed = vec![];
    for (i, force) in forces.iter().enumerate() {
        let mut terms = vec![*force];
        for (j, velocity) in velocities.iter().enumerate() {
            let coefficient = taking(graph, matrix, i, j);
            let drag = graph.mul(coefficient, *velocity);
            terms.push(graph.neg(drag));
        }
        rubbed.push(graph.sum(&terms));
    }
    rubbed
}
