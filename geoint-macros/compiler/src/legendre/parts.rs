//! Splits L into parts: groups of velocities that M couples, and the energy of each group.

use super::conjugate::{self, Conjugate};
use super::quadratic::{self, NoForm};
use super::{Flaw, Kinetic, Part, at_rest, is_velocity, mass};
use crate::ir::substitute::at_zero;
use crate::ir::{Graph, Id, Number, Symbol};
use crate::{analyze, diff};

/// From this number of velocities on, H of a full mass matrix costs more than L with its velocities as unknowns: twice as much with 3 velocities, and
/// five times as much with 6.
const FULL: usize = 3;

/// A Lagrangian in parts.
pub(super) struct Parts {
    pub(super) parts: Vec<Part>,
    /// The terms of H that read momenta, as far as they are known.
    pub(super) kinetic: Id,
    pub(super) potential: Id,
    /// An entry of M that makes H long.
    pub(super) obstacle: Option<Id>,
}

/// Splits a Lagrangian with the mass matrix M and the momenta `shift` at rest.
pub(super) fn parts(
    graph: &mut Graph,
    lagrangian: Id,
    momenta: &[Id],
    mass: &[Vec<Id>],
    shift: &[Id],
    needs_energy: bool,
) -> Result<Parts, Flaw> {
    let (mut parts, mut squares, mut obstacle) = (vec![], vec![], None);
    let (mut rest, mut not_quadratic) = (lagrangian, vec![]);
    for velocities in diff::blocks(graph, mass) {
        if !analyze::is_polynomial_in(graph, &mass::picked(momenta, &velocities), 1, is_velocity) {
            not_quadratic.push(velocities);
            continue;
        }
        let (block, shift) = (mass::block(mass, &velocities), mass::picked(shift, &velocities));
        let full = block.iter().flatten().copied().find(|entry| block.len() >= FULL && graph.reads(*entry).moves());
        // A long H is built only if it is needed, or if it shows why M is singular.
        if needs_energy || full.is_none() || !analyze::is_regular(graph, &block) {
            let reduced = quadratic::reduced(graph, &velocities, &shift);
            match quadratic::inverse_form(graph, &block, &reduced) {
                Ok(mut form) => squares.append(&mut form),
                Err(NoForm::Singular(combination)) => return Err(singular(graph, velocities, combination)),
                Err(NoForm::NoPivot(entry)) => obstacle = Some(entry),
            }
        }
        obstacle = obstacle.or(full);
        rest = without(graph, rest, |i| velocities.contains(&i));
        parts.push(Part { velocities, kinetic: Kinetic::Quadratic { mass: block, shift } });
    }
    let squares = quadratic::sum(graph, &squares);
    let mut kinetic = vec![graph.scale(Number::HALF, squares)];
    let all_quadratic = not_quadratic.is_empty();
    for velocities in not_quadratic {
        let alone = without(graph, rest, |i| !velocities.contains(&i));
        let found = match conjugate::of(graph, alone, &velocities) {
            Some(Conjugate { term, energy, rule }) => {
                kinetic.push(energy);
                Kinetic::Conjugate { term, rule }
            }
            None => {
                let block = mass::block(mass, &velocities);
                let none = graph.zero();
                let momenta = quadratic::reduced(graph, &velocities, &vec![none; block.len()]);
                if let Err(NoForm::Singular(combination)) = quadratic::inverse_form(graph, &block, &momenta) {
                    return Err(singular(graph, velocities, combination));
                }
                Kinetic::Open(alone)
            }
        };
        parts.push(Part { velocities, kinetic: found });
    }
    // Terms with a conjugate are complete in H. Terms that are linear in velocities may have a summand without velocities.
    if !all_quadratic {
        let mut terms = conjugate::terms(graph, rest);
        terms.retain(|term| analyze::is_polynomial_in(graph, &[*term], 1, is_velocity));
        rest = graph.sum(&terms);
        rest = at_rest(graph, rest);
    }
    parts.sort_by_key(|part| part.velocities[0]);
    let (kinetic, potential) = (graph.sum(&kinetic), graph.neg(rest));
    Ok(Parts { parts, kinetic, potential, obstacle })
}

/// Returns a node at zero for the velocities that `vanishes` selects.
fn without(graph: &mut Graph, node: Id, vanishes: impl Fn(u32) -> bool) -> Id {
    at_zero(graph, node, |symbol| matches!(symbol, Symbol::Velocity(i) if vanishes(i)))
}

/// Returns the flaw of a singular M: w·p = 0 at every state implies wᵀM = 0.
fn singular(graph: &mut Graph, velocities: Vec<u32>, combination: Id) -> Flaw {
    let momenta: Vec<Symbol> = velocities.iter().map(|i| Symbol::Momentum(*i)).collect();
    let direction = diff::jacobian(graph, &[combination], &momenta).concat();
    Flaw::Singular(velocities, direction)
}
