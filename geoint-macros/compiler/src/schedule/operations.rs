//! Counts of operations.

/// The number of operations in a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Operations {
    /// Sums, differences, products.
    pub(crate) arithmetic: usize,
    /// Divisions and square roots.
    pub(crate) divisions: usize,
    /// Functions. A sine and its cosine are two.
    pub(crate) calls: usize,
}

impl Operations {
    /// Returns a number of sums and products.
    pub(super) fn arithmetic(arithmetic: usize) -> Operations {
        Operations { arithmetic, ..Operations::default() }
    }

    /// Returns a number of calls.
    pub(super) fn calls(calls: usize) -> Operations {
        Operations { calls, ..Operations::default() }
    }

    /// Returns the number of all operations. A fused a·b + c counts as two.
    pub(crate) fn total(self) -> usize {
        self.arithmetic + self.divisions + self.calls
    }

    /// Returns a rough duration in units of one sum.
    pub(crate) fn weight(self) -> usize {
        self.arithmetic + 4 * self.divisions + 20 * self.calls
    }
}

impl std::ops::Add for Operations {
    type Output = Operations;
    fn add(self, other: Operations) -> Operations {
        Operations {
            arithmetic: self.arithmetic + other.arithmetic,
            divisions: self.divisions + other.divisions,
            calls: self.calls + other.calls,
        }
    }
}

impl std::ops::Mul<Operations> for usize {
    type Output = Operations;
    fn mul(self, one: Operations) -> Operations {
        Operations { arithmetic: self * one.arithmetic, divisions: self * one.divisions, calls: self * one.calls }
    }
}
