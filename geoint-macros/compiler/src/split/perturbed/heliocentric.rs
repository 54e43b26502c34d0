//! Democratic heliocentric coordinates: each body as seen from body 0, with its velocity against the centre of mass.
//!
//! Q_i = q_i − q₀, V_i = v_i − V₀ with the velocity V₀ of the centre. T is then Σ m_i|V_i|²/2 and |Σ m_i V_i|²/2m₀, the motion of body 0, which moves
//! all others alike: a jump. No order of bodies is asked for. M. J. Duncan, H. F. Levison & M. H. Lee, Astron. J. 116 (1998) 2067.

use super::frame::{Frame, Masses, Offsets};
use crate::ir::{Graph, Id};

pub(super) const HELIOCENTRIC: Frame = Frame {
    name: "heliocentric coordinates, velocities against the centre of mass",
    inside: |body| 0..body.min(1),
    ratio,
    enter: |graph, masses, outer| {
        let from_first = outer.iter().skip(1).map(|x| graph.sub(*x, outer[0])).collect();
        with_centre(graph, masses, outer, from_first)
    },
    leave: |graph, masses, inner| {
        let shift = mean(graph, masses, inner, |graph, masses, body| masses.share(graph, body, masses.each.len() - 1));
        let mut each = inner.to_vec();
        each[0] = graph.zero();
        Offsets { first: graph.sub(inner[0], shift), each }
    },
    enter_velocities: |graph, masses, outer| {
        let centre = centre(graph, masses, outer);
        let from_centre = outer.iter().skip(1).map(|x| graph.sub(*x, centre)).collect();
        with_centre(graph, masses, outer, from_centre)
    },
    leave_velocities: |graph, masses, inner| {
        let jump = jump(graph, masses, inner);
        let mut outer: Vec<Id> = inner.iter().map(|v| graph.add(*v, inner[0])).collect();
        outer[0] = graph.sub(inner[0], jump);
        outer
    },
    jump: Some(jump),
};

/// 1; m₀/η of all.
fn ratio(graph: &mut Graph, masses: &Masses, body: usize) -> Id {
    if body == 0 { masses.share(graph, 0, masses.each.len() - 1) } else { graph.integer(1) }
}

/// Σ m_i x_i/η, from body to body.
fn centre(graph: &mut Graph, masses: &Masses, outer: &[Id]) -> Id {
    let mut centre = outer[0];
    for (body, x) in outer.iter().enumerate().skip(1) {
        let (share, from_centre) = (masses.share(graph, body, body), graph.sub(*x, centre));
        let shift = graph.mul(share, from_centre);
        centre = graph.add(shift, centre);
    }
    centre
}

fn with_centre(graph: &mut Graph, masses: &Masses, outer: &[Id], mut others: Vec<Id>) -> Vec<Id> {
    others.insert(0, centre(graph, masses, outer));
    others
}

/// Σ wᵢ xᵢ of all bodies but body 0.
fn mean(graph: &mut Graph, masses: &Masses, inner: &[Id], weight: fn(&mut Graph, &Masses, usize) -> Id) -> Id {
    let mut parts = vec![];
    for (body, x) in inner.iter().enumerate().skip(1) {
        let weight = weight(graph, masses, body);
        parts.push(graph.mul(weight, *x));
    }
    graph.sum(&parts)
}

/// Σ (m_i/m₀) V_i: against the centre of mass body 0 moves with less this.
fn jump(graph: &mut Graph, masses: &Masses, inner: &[Id]) -> Id {
    mean(graph, masses, inner, |graph, masses, body| masses.share(graph, body, 0))
}
