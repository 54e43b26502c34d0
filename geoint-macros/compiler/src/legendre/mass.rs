//! The mass matrix M = ∂²L/∂v².

use super::{Flaw, at_rest, idle_coordinates::without_idle_coordinates, is_velocity};
use crate::ir::{Graph, Id, Symbol};
use crate::{analyze, diff};

/// Returns ∂²L/∂v². Entries (i, j) and (j, i) are one node, free of velocities where the momentum is affine in them.
pub(super) fn masses(graph: &mut Graph, momenta: &[Id], symbols: &[Symbol]) -> Vec<Vec<Id>> {
    let mut mass = diff::jacobian(graph, momenta, symbols);
    for i in 0..mass.len() {
        let affine = analyze::is_polynomial_in(graph, &[momenta[i]], 1, is_velocity);
        for j in 0..=i {
            // A constant entry may be written with velocities that cancel.
            let entry = if affine { at_rest(graph, mass[i][j]) } else { mass[i][j] };
            (mass[i][j], mass[j][i]) = (entry, entry);
        }
    }
    mass
}

/// Returns M without idle coordinates, which cancel in its entries, as in sin²q + cos²q. Entries with velocities stay as they are: velocities may cancel as well.
pub(super) fn simplified(graph: &mut Graph, mass: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let mut simple = mass.to_vec();
    for i in 0..mass.len() {
        for j in 0..=i {
            let entry =
                if graph.reads(mass[i][j]).v { mass[i][j] } else { without_idle_coordinates(graph, mass[i][j]) };
            (simple[i][j], simple[j][i]) = (entry, entry);
        }
    }
    simple
}

/// Returns the simplified entries that read no state, and the written entries elsewhere. The written entries share functions with the terms of L.
pub(super) fn choose(graph: &Graph, simple: &[Vec<Id>], written: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let entry = |(simple, written): (&Id, &Id)| if graph.reads(*simple).state() { *written } else { *simple };
    simple.iter().zip(written).map(|(simple, written)| simple.iter().zip(written).map(entry).collect()).collect()
}

/// Returns the mass matrix of some velocities.
pub(super) fn block(mass: &[Vec<Id>], velocities: &[u32]) -> Vec<Vec<Id>> {
    velocities.iter().map(|i| picked(&mass[*i as usize], velocities)).collect()
}

/// Returns the entries of a vector that belong to some velocities.
pub(super) fn picked(vector: &[Id], velocities: &[u32]) -> Vec<Id> {
    velocities.iter().map(|i| vector[*i as usize]).collect()
}

/// Refuses a Lagrangian in which a velocity has no inertia, so that its row of M is zero: L does not read the velocity (`Unread`), is linear in it (`LinearIn`),
/// or is linear in all velocities (`Linear`). A singular M without a zero row is found later, by its inverse.
pub(super) fn regular(graph: &Graph, momenta: &[Id], mass: &[Vec<Id>]) -> Result<(), Flaw> {
    let massless = |i: &usize| mass[*i].iter().all(|entry| graph.is_zero(*entry));
    let all: Vec<usize> = (0..mass.len()).filter(massless).collect();
    let Some(first) = all.first() else { return Ok(()) };
    let (unread, linear): (Vec<usize>, Vec<usize>) = all.iter().partition(|i| graph.is_zero(momenta[**i]));
    if all.len() == mass.len() && !linear.is_empty() {
        return Err(Flaw::Linear(momenta.to_vec()));
    }
    // A coordinate with an unread velocity may be the momentum of another coordinate.
    let is_momentum =
        |i: &usize| linear.iter().any(|j| graph.symbols(momenta[*j]).contains(&Symbol::Position(*i as u32)));
    Err(match unread.into_iter().find(|i| !is_momentum(i)) {
        Some(i) => Flaw::Unread(i as u32),
        None => {
            let i = *linear.first().unwrap_or(first);
            Flaw::LinearIn(i as u32, momenta[i])
        }
    })
}

/// Returns whether M is diagonal and its form implies that it is negative definite.
pub(super) fn is_negative(graph: &mut Graph, mass: &[Vec<Id>]) -> bool {
    (0..mass.len()).all(|i| {
        let opposite = graph.neg(mass[i][i]);
        (0..mass.len()).all(|j| i == j || graph.is_zero(mass[i][j])) && graph.is_positive(opposite)
    })
}
