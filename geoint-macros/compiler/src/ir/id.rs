//! The number of a node.

/// A node of a graph. Every node has a larger number than its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Id(u32);

impl Id {
    /// Returns the place of the node in the graph.
    #[inline(always)]
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }

    /// Returns the node at a place of the graph.
    #[inline(always)]
    pub(super) fn from_index(index: usize) -> Id {
        Id(index as u32)
    }
}
