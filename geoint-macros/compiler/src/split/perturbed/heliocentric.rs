//! Democratic heliocentric coordinates: positions relative to body 0, and velocities relative to the centre of mass.
//!
//! Q_i = q_i − q₀ and V_i = v_i − V₀ with the velocity V₀ of the centre of mass. T is then Σ m_i|V_i|²/2 + |Σ m_i V_i|²/2m₀. The second term,
//! the kinetic energy of body 0, gives all other bodies the same velocity: a jump. The order of bodies is arbitrary. M. J. Duncan, H. F. Levison &
//! M. H. Lee, Astron. J. 116 (1998) 2067.

use super::frame::{Frame, Masses, Offsets};
use crate::ir::{Graph, Id};

pub(super) const HELIOCENTRIC: Frame = Frame {
    name: "heliocentric coordinates, velocities against the centre of mass",
    inside: |body| 0..body.min(1),
    ratio: |graph, masses, body| if body == 0 { masses.share_of_all(graph, 0) } else { graph.integer(1) },
    enter: |graph, masses, outer| {
        let mut inner: Vec<Id> = outer.iter().map(|x| graph.sub(*x, outer[0])).collect();
        inner[0] = centre(graph, masses, outer);
        inner
    },
    leave: |graph, masses, inner| {
        let shift = weighted_sum(graph, masses, inner, Masses::share_of_all);
        let mut each = inner.to_vec();
        each[0] = graph.zero();
        Offsets { first: graph.sub(inner[0], shift), each }
    },
    enter_velocities: |graph, masses, outer| {
        let centre = centre(graph, masses, outer);
        let mut inner: Vec<Id> = outer.iter().map(|x| graph.sub(*x, centre)).collect();
        inner[0] = centre;
        inner
    },
    leave_velocities: |graph, masses, inner| {
        let jump = jump(graph, masses, inner);
        let mut outer: Vec<Id> = inner.iter().map(|v| graph.add(*v, inner[0])).collect();
        outer[0] = graph.sub(inner[0], jump);
        outer
    },
    jump: Some(jump),
};

/// Returns the centre Σ m_i x_i/η, accumulated from body to body.
fn centre(graph: &mut Graph, masses: &Masses, outer: &[Id]) -> Id {
    let mut centre = outer[0];
    for (body, x) in outer.iter().enumerate().skip(1) {
        let (share, from_centre) = (masses.share(graph, body, body), graph.sub(*x, centre));
        let shift = graph.mul(share, from_centre);
        centre = graph.add(shift, centre);
    }
    centre
}

/// Returns Σ wᵢ xᵢ over all bodies but body 0.
fn weighted_sum(graph: &mut Graph, masses: &Masses, inner: &[Id], weight: fn(&Masses, &mut Graph, usize) -> Id) -> Id {
    let mut parts = vec![];
    for (body, x) in inner.iter().enumerate().skip(1) {
        let weight = weight(masses, graph, body);
        parts.push(graph.mul(weight, *x));
    }
    graph.sum(&parts)
}

/// Returns Σ (m_i/m₀) V_i, the negative velocity of body 0 relative to the centre of mass.
fn jump(graph: &mut Graph, masses: &Masses, inner: &[Id]) -> Id {
    weighted_sum(graph, masses, inner, |masses, graph, body| masses.share(graph, body, 0))
}
