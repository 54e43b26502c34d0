//! A value for some of the nodes of a graph.

use super::id::Id;

/// A map from nodes to values. Nodes are numbered without gaps, so the number of a node leads to the place of its value.
#[derive(Clone, Debug)]
pub(crate) struct Table<T> {
    /// One plus the place of a node's value, or 0. Zeros come from the allocator. An unoptimised build would write any other initial value in a loop.
    places: Vec<u32>,
    values: Vec<T>,
}

impl<T> Default for Table<T> {
    fn default() -> Self {
        Table { places: vec![], values: vec![] }
    }
}

impl<T: Copy> Table<T> {
    /// Returns the value of a node, if it has one.
    pub(crate) fn get(&self, id: Id) -> Option<T> {
        match self.place(id) {
            0 => None,
            place => Some(self.values.as_slice()[place - 1]),
        }
    }

    /// Sets the value of a node.
    pub(crate) fn insert(&mut self, id: Id, value: T) {
        let place = self.place(id);
        if place > 0 {
            self.values.as_mut_slice()[place - 1] = value;
            return;
        }
        if self.places.len() <= id.index() {
            let mut longer = vec![0; (id.index() + 1).next_power_of_two()];
            longer[..self.places.len()].copy_from_slice(&self.places);
            self.places = longer;
        }
        self.values.push(value);
        self.places.as_mut_slice()[id.index()] = self.values.len() as u32;
    }

    /// Returns the nodes with a value, in order.
    pub(crate) fn ids(&self) -> impl Iterator<Item = Id> + '_ {
        self.places.iter().enumerate().filter(|(_, place)| **place > 0).map(|(i, _)| Id::from_index(i))
    }

    /// Returns whether a node has a value.
    pub(crate) fn contains(&self, id: Id) -> bool {
        self.place(id) > 0
    }

    #[inline(always)]
    fn place(&self, id: Id) -> usize {
        let places = self.places.as_slice();
        if id.index() < places.len() { places[id.index()] as usize } else { 0 }
    }
}

impl<T: Copy> std::ops::Index<Id> for Table<T> {
    type Output = T;

    /// Precondition: the node has a value. Traversals visit operands first, so the values of operands exist.
    fn index(&self, id: Id) -> &T {
        &self.values.as_slice()[self.places.as_slice()[id.index()] as usize - 1]
    }
}
