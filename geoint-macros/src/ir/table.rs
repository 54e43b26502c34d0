//! A value for some of the nodes of a graph.

use super::id::Id;

/// A map from nodes to values, as an array: nodes are numbered without gaps.
#[derive(Clone, Debug)]
pub(crate) struct Table<T>(Vec<Option<T>>);

impl<T> Default for Table<T> {
    fn default() -> Self {
        Table(vec![])
    }
}

impl<T: Copy> Table<T> {
    pub(crate) fn get(&self, id: Id) -> Option<T> {
        self.0.get(id.index()).copied().flatten()
    }

    pub(crate) fn insert(&mut self, id: Id, value: T) {
        if self.0.len() <= id.index() {
            self.0.resize(id.index() + 1, None);
        }
        self.0[id.index()] = Some(value);
    }

    /// The nodes that have a value, in order.
    pub(crate) fn ids(&self) -> impl Iterator<Item = Id> + '_ {
        self.0.iter().enumerate().filter(|(_, value)| value.is_some()).map(|(i, _)| Id::from_index(i))
    }

    pub(crate) fn contains(&self, id: Id) -> bool {
        self.get(id).is_some()
    }
}

impl<T: Copy> std::ops::Index<Id> for Table<T> {
    type Output = T;

    /// The value of a node that is known to have one.
    fn index(&self, id: Id) -> &T {
        self.0[id.index()].as_ref().expect("operands are visited before what is built of them")
    }
}
