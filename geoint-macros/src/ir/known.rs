//! Which nodes are known: a hash table of their numbers, which are all that it holds.

use super::hash::Fold;
use super::id::Id;
use std::hash::{Hash, Hasher};

/// The numbers of nodes by their hashes. In an unoptimised build std's table costs several times as much.
#[derive(Clone, Debug, Default)]
pub(super) struct Known {
    /// A power of two of places, not more than half of them taken. A number is at the place of its hash, or at the next free one.
    places: Vec<Option<(u64, Id)>>,
    taken: usize,
}

/// The hash of a node.
pub(super) fn hash(node: &impl Hash) -> u64 {
    let mut fold = Fold::default();
    node.hash(&mut fold);
    fold.finish()
}

impl Known {
    /// The number with a hash for which something holds.
    pub(super) fn find(&self, hash: u64, is: impl Fn(Id) -> bool) -> Option<Id> {
        let mut place = self.place(hash);
        while let Some((other, id)) = self.places.get(place).copied().flatten() {
            if other == hash && is(id) {
                return Some(id);
            }
            place = self.after(place);
        }
        None
    }

    /// A number that is not known.
    pub(super) fn insert(&mut self, hash: u64, id: Id) {
        if 2 * self.taken >= self.places.len() {
            let larger = vec![None; (2 * self.places.len()).max(1024)];
            for (hash, id) in std::mem::replace(&mut self.places, larger).into_iter().flatten() {
                self.put(hash, id);
            }
        }
        self.put(hash, id);
        self.taken += 1;
    }

    fn put(&mut self, hash: u64, id: Id) {
        let mut place = self.place(hash);
        while self.places[place].is_some() {
            place = self.after(place);
        }
        self.places[place] = Some((hash, id));
    }

    /// By the upper half, which depends on all bits of a node.
    fn place(&self, hash: u64) -> usize {
        (hash >> 32) as usize & self.places.len().wrapping_sub(1)
    }

    fn after(&self, place: usize) -> usize {
        (place + 1) & (self.places.len() - 1)
    }
}
