//! Jacobi coordinates: the position of each body relative to the centre of mass of the bodies before it.
//!
//! With η_i the mass of bodies 0…i and R_i = R_{i−1} + (m_i/η_i) Q_i: q_i = q₀ + Q_i + R_{i−1}. Q₀ is the centre of mass of all bodies. Nested
//! sums, and their reverse sweep, cost one term for each body, not for each pair. J. Wisdom & M. Holman, Astron. J. 102 (1991) 1528; H. Rein &
//! D. Tamayo, Mon. Not. R. Astron. Soc. 452 (2015) 376.

use super::frame::{Frame, Masses, Offsets};
use crate::ir::{Graph, Id};

pub(super) const JACOBI: Frame = Frame {
    name: "Jacobi's coordinates, bodies in the order of the array",
    inside: |body| 0..body,
    ratio,
    enter,
    leave,
    enter_velocities: enter,
    leave_velocities: |graph, masses, inner| leave(graph, masses, inner).places(graph),
    jump: None,
};

/// Returns η_i/η_{i−1}.
fn ratio(graph: &mut Graph, masses: &Masses, body: usize) -> Id {
    match body.checked_sub(1) {
        Some(before) => graph.div(masses.sums[body], masses.sums[before]),
        None => masses.share_of_all(graph, 0),
    }
}

/// Returns Q_i = q_i − X_{i−1} with the centre of mass X_{i−1} of the bodies before.
fn enter(graph: &mut Graph, masses: &Masses, outer: &[Id]) -> Vec<Id> {
    let (mut inner, mut centre) = (vec![outer[0]], outer[0]);
    for (body, x) in outer.iter().enumerate().skip(1) {
        let from_centre = graph.sub(*x, centre);
        inner.push(from_centre);
        let share = masses.share(graph, body, body);
        let shift = graph.mul(share, from_centre);
        centre = graph.add(shift, centre);
    }
    inner[0] = centre;
    inner
}

/// Returns q₀ = Q₀ − R and the offsets Q_i + R_{i−1}.
fn leave(graph: &mut Graph, masses: &Masses, inner: &[Id]) -> Offsets {
    let (mut each, mut sum) = (vec![graph.zero()], graph.zero());
    for (body, q) in inner.iter().enumerate().skip(1) {
        each.push(graph.add(*q, sum));
        let share = masses.share(graph, body, body);
        let part = graph.mul(share, *q);
        sum = graph.add(part, sum);
    }
    Offsets { first: graph.sub(inner[0], sum), each }
}
