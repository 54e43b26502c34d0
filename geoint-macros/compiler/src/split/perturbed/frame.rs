//! Kinds of coordinates of bodies, each about a centre.

use crate::ir::{Graph, Id};
use std::ops::Range;

/// A number along one direction of space, by one of each body.
pub(super) type Along = fn(&mut Graph, &Masses, &[Id]) -> Id;

/// A kind of coordinates. Each function is along one direction of space, and takes a number of each body.
pub(super) struct Frame {
    pub(super) name: &'static str,
    /// The bodies that attract a body to the centre of its orbit.
    pub(super) inside: fn(usize) -> Range<usize>,
    /// The mass of a body over that with which it moves about its centre; of body 0, which stands for all, over that of all.
    pub(super) ratio: fn(&mut Graph, &Masses, usize) -> Id,
    /// Q of positions.
    pub(super) enter: fn(&mut Graph, &Masses, &[Id]) -> Vec<Id>,
    /// Positions of Q.
    pub(super) leave: fn(&mut Graph, &Masses, &[Id]) -> Offsets,
    /// V of velocities.
    pub(super) enter_velocities: fn(&mut Graph, &Masses, &[Id]) -> Vec<Id>,
    /// Velocities of V.
    pub(super) leave_velocities: fn(&mut Graph, &Masses, &[Id]) -> Vec<Id>,
    /// The velocity with which the kinetic energy that is no body's own moves all bodies but body 0.
    pub(super) jump: Option<Along>,
}

/// The masses of bodies in a row.
pub(super) struct Masses {
    pub(super) each: Vec<Id>,
    /// η_i, of bodies 0…i.
    pub(super) sums: Vec<Id>,
}

/// Where bodies are: body 0, and each from there.
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

    /// m_i/η_j.
    pub(super) fn share(&self, graph: &mut Graph, body: usize, of: usize) -> Id {
        graph.div(self.each[body], self.sums[of])
    }
}

impl Offsets {
    /// Where all of them are.
    pub(super) fn places(self, graph: &mut Graph) -> Vec<Id> {
        self.each.iter().map(|offset| graph.add(self.first, *offset)).collect()
    }
}
