//! Frames: coordinates of bodies in which each body moves about a centre.

use crate::ir::{Graph, Id};
use std::ops::Range;

/// Combines one component of each body to one number.
type Combine = fn(&mut Graph, &Masses, &[Id]) -> Id;

/// A kind of coordinates. Each function takes one component, along one direction of space, of each body.
pub(super) struct Frame {
    pub(super) name: &'static str,
    /// Returns the bodies at the centre of the orbit of a body.
    pub(super) inside: fn(usize) -> Range<usize>,
    /// Returns the mass of a body divided by its mass in the motion about the centre. For body 0, which stands for the centre of mass, the
    /// divisor is the total mass.
    pub(super) ratio: fn(&mut Graph, &Masses, usize) -> Id,
    /// Returns the inner positions Q.
    pub(super) enter: fn(&mut Graph, &Masses, &[Id]) -> Vec<Id>,
    /// Returns the positions for inner positions Q.
    pub(super) leave: fn(&mut Graph, &Masses, &[Id]) -> Offsets,
    /// Returns the inner velocities V.
    pub(super) enter_velocities: fn(&mut Graph, &Masses, &[Id]) -> Vec<Id>,
    /// Returns the velocities for inner velocities V.
    pub(super) leave_velocities: fn(&mut Graph, &Masses, &[Id]) -> Vec<Id>,
    /// Returns the velocity that the shared part of the kinetic energy gives to all bodies but body 0.
    pub(super) jump: Option<Combine>,
}

/// The masses of bodies in the order of the array.
pub(super) struct Masses {
    pub(super) each: Vec<Id>,
    /// η_i, the mass of bodies 0…i.
    pub(super) sums: Vec<Id>,
}

/// Positions as the position of body 0 and the offset of each body from it.
pub(super) struct Offsets {
    pub(super) first: Id,
    pub(super) each: Vec<Id>,
}

impl Masses {
    pub(super) fn new(graph: &mut Graph, each: &[Id]) -> Masses {
        let mut sums: Vec<Id> = vec![];
        for mass in each {
            let sum = sums.last().map_or(*mass, |sum| graph.add(*mass, *sum));
            sums.push(sum);
        }
        Masses { each: each.to_vec(), sums }
    }

    /// Returns m_i/η_j for i = `body` and j = `of`.
    pub(super) fn share(&self, graph: &mut Graph, body: usize, of: usize) -> Id {
        graph.div(self.each[body], self.sums[of])
    }

    /// Returns m_i divided by the total mass.
    pub(super) fn share_of_all(&self, graph: &mut Graph, body: usize) -> Id {
        self.share(graph, body, self.each.len() - 1)
    }
}

impl Offsets {
    /// Returns the positions.
    pub(super) fn places(self, graph: &mut Graph) -> Vec<Id> {
        self.each.iter().map(|offset| graph.add(self.first, *offset)).collect()
    }
}
