//! L taken apart: velocities that M couples, and how each such part follows from momenta.

use super::{Flaw, Kinetic, Part, at_rest, conjugate, mass, quadratic};
use crate::ir::{Graph, Id, Number, Symbol};
use crate::{analyze, diff};

/// From so many velocities on that a full mass matrix couples, H costs more than L with its velocities as unknowns: twice as much with 3,
/// five times with 6.
const FULL: usize = 3;

/// L taken apart.
pub(super) struct Parts {
    pub(super) parts: Vec<Part>,
    /// What is known of H in the momenta.
    pub(super) kinetic: Id,
    pub(super) potential: Id,
    /// An entry of M for which H would be long.
    pub(super) long: Option<Id>,
}

pub(super) fn parts(
    graph: &mut Graph,
    lagrangian: Id,
    (momenta, entries, shift): (&[Id], &[Vec<Id>], &[Id]),
    closed: bool,
) -> Result<Parts, Flaw> {
    let (mut parts, mut squares, mut kinetic) = (vec![], vec![], vec![]);
    let (mut rest, mut others, mut long) = (lagrangian, vec![], None);
    for velocities in diff::blocks(graph, entries) {
        let picked = |row: &[Id]| velocities.iter().map(|i| row[*i as usize]).collect::<Vec<Id>>();
        let block: Vec<Vec<Id>> = velocities.iter().map(|i| picked(&entries[*i as usize])).collect();
        if !analyze::is_polynomial_in(graph, &picked(momenta), 1, mass::is_velocity) {
            others.push(velocities);
            continue;
        }
        let shift = picked(shift);
        let full = block.iter().flatten().copied().find(|entry| block.len() >= FULL && graph.reads(*entry).moves());
        // Where H would be long it is not made, unless it is asked for or tells why M is singular.
        if closed || full.is_none() || !analyze::is_regular(graph, &block) {
            let reduced = quadratic::reduced(graph, &velocities, &shift);
            match quadratic::inverse_form(graph, &block, &reduced) {
                Ok(mut form) => squares.append(&mut form),
                Err(quadratic::NoForm::Singular(combination)) => return Err(singular(graph, velocities, combination)),
                Err(quadratic::NoForm::NoPivot(entry)) => long = Some(entry),
            }
        }
        long = long.or(full);
        rest = at_rest(graph, rest, |i| velocities.contains(&i));
        parts.push(Part { velocities, kinetic: Kinetic::Quadratic { mass: block, shift } });
    }
    let squares = quadratic::sum(graph, &squares);
    kinetic.push(graph.scale(Number::HALF, squares));
    let conjugates = !others.is_empty();
    for velocities in others {
        let alone = at_rest(graph, rest, |i| !velocities.contains(&i));
        let found = match conjugate::of(graph, alone, &velocities) {
            Some(conjugate::Conjugate { term, energy, rule }) => {
                kinetic.push(energy);
                Kinetic::Conjugate { term, rule }
            }
            None => {
                let picked = |i: &u32| velocities.iter().map(|j| entries[*i as usize][*j as usize]).collect();
                let block: Vec<Vec<Id>> = velocities.iter().map(picked).collect();
                let none = graph.zero();
                let momenta = quadratic::reduced(graph, &velocities, &vec![none; block.len()]);
                if let Err(quadratic::NoForm::Singular(combination)) = quadratic::inverse_form(graph, &block, &momenta)
                {
                    return Err(singular(graph, velocities, combination));
                }
                Kinetic::Open(alone)
            }
        };
        parts.push(Part { velocities, kinetic: found });
    }
    // What has a conjugate goes with its velocities; of what is linear in them there may be a rest.
    if conjugates {
        let linear = |graph: &Graph, term: Id| analyze::is_polynomial_in(graph, &[term], 1, mass::is_velocity);
        let mut terms = conjugate::terms(graph, rest);
        terms.retain(|term| linear(graph, *term));
        rest = graph.sum(&terms);
        rest = at_rest(graph, rest, |_| true);
    }
    parts.sort_by_key(|part| part.velocities[0]);
    let (kinetic, potential) = (graph.sum(&kinetic), graph.neg(rest));
    Ok(Parts { parts, kinetic, potential, long })
}

/// w·p = 0 at every state says that wᵀM = 0.
fn singular(graph: &mut Graph, velocities: Vec<u32>, combination: Id) -> Flaw {
    let momenta: Vec<Symbol> = velocities.iter().map(|i| Symbol::Momentum(*i)).collect();
    let direction = diff::jacobian(graph, &[combination], &momenta).concat();
    Flaw::Singular(velocities, direction)
}
