//! The mass matrix M = ∂²L/∂v².

use super::{Flaw, at_rest, invariant};
use crate::ir::{Graph, Id, Symbol};
use crate::{analyze, diff};

/// ∂²L/∂v², of equal entries one; free of v where it can be.
pub(super) fn masses(graph: &mut Graph, momenta: &[Id], symbols: &[Symbol]) -> Vec<Vec<Id>> {
    let mut mass = diff::jacobian(graph, momenta, symbols);
    for i in 0..mass.len() {
        let affine = analyze::is_polynomial_in(graph, &[momenta[i]], 1, is_velocity);
        for j in 0..=i {
            // A constant may have been written with velocities in it.
            let entry = if affine { at_rest(graph, mass[i][j], |_| true) } else { mass[i][j] };
            (mass[i][j], mass[j][i]) = (entry, entry);
        }
    }
    mass
}

pub(super) fn is_velocity(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Velocity(_))
}

/// M without coordinates on which its entries do not depend.
pub(super) fn simplified(graph: &mut Graph, mass: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let mut simple = mass.to_vec();
    for i in 0..mass.len() {
        for j in 0..=i {
            let entry = if graph.reads(mass[i][j]).v { mass[i][j] } else { invariant::simplified(graph, mass[i][j]) };
            (simple[i][j], simple[j][i]) = (entry, entry);
        }
    }
    simple
}

/// Entries of the first matrix where they read no state, else of the second.
pub(super) fn choose(graph: &Graph, simple: &[Vec<Id>], written: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let entry = |(simple, written): (&Id, &Id)| if graph.reads(*simple).state() { *written } else { *simple };
    simple.iter().zip(written).map(|(simple, written)| simple.iter().zip(written).map(entry).collect()).collect()
}

/// Refuses a Lagrangian some of whose velocities have no inertia.
pub(super) fn regular(graph: &Graph, momenta: &[Id], mass: &[Vec<Id>]) -> Result<(), Flaw> {
    let massless = |i: &usize| mass[*i].iter().all(|entry| graph.is_zero(*entry));
    let all: Vec<usize> = (0..mass.len()).filter(massless).collect();
    let Some(first) = all.first() else { return Ok(()) };
    let (unread, linear): (Vec<usize>, Vec<usize>) = all.iter().partition(|i| graph.is_zero(momenta[**i]));
    if all.len() == mass.len() && !linear.is_empty() {
        return Err(Flaw::Linear(momenta.to_vec()));
    }
    // A coordinate whose velocity is not read may be the momentum of another one.
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

/// Whether a diagonal matrix is known to be negative definite.
pub(super) fn is_negative(graph: &mut Graph, mass: &[Vec<Id>]) -> bool {
    (0..mass.len()).all(|i| {
        let opposite = graph.neg(mass[i][i]);
        (0..mass.len()).all(|j| i == j || graph.is_zero(mass[i][j])) && graph.is_positive(opposite)
    })
}
