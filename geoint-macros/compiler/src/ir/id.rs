//! The number of a node.

/// A node of a graph; operands have smaller numbers than what is built of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Id(u32);

impl Id {
    #[inline(always)]
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }

    #[inline(always)]
    pub(super) fn from_index(index: usize) -> Id {
        Id(index as u32)
    }
}
