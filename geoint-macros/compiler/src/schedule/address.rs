//! Entries of the arrays that loops read and write.

use super::layout::{Array, Place};

/// The most indices of an array in a loop.
pub(super) const MOST_INDICES: usize = 3;

/// Indices of an entry, the last index first. Missing indices are 0.
pub(crate) type Indices = [i32; MOST_INDICES];

/// The array of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Computed {
    pub(crate) array: usize,
    /// The part of each entry. Nothing if entries are numbers.
    pub(crate) part: Option<usize>,
}

/// A source of operands. The order of the variants decides the order of members.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// The number of an operand that all members share.
    One(usize),
    /// An array of the caller, and the number of its indices.
    Given(Array, usize),
    /// The slots of an earlier level.
    Slots(usize),
    /// The array of another loop.
    Computed(Computed),
}

/// An entry of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Address {
    pub(super) source: Source,
    pub(super) indices: Indices,
}

/// Successive entries of a source. Member i reads the entry at `first + i·step`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Successive {
    pub(crate) source: Source,
    pub(crate) first: Indices,
    pub(crate) step: Indices,
}

impl Address {
    /// Returns the address of an entry. Returns nothing for numbers outside of arrays, and for too many indices.
    pub(super) fn of(place: &Place) -> Option<Address> {
        let rank = place.indices.len();
        if rank == 0 || rank > MOST_INDICES {
            return None;
        }
        let mut indices = Indices::default();
        for (to, from) in indices.iter_mut().zip(place.indices.iter().rev()) {
            *to = *from as i32;
        }
        Some(Address { source: Source::Given(place.array, rank), indices })
    }

    /// Returns the difference of the indices of two entries.
    pub(super) fn minus(&self, other: &Address) -> Indices {
        std::array::from_fn(|i| self.indices[i] - other.indices[i])
    }
}
