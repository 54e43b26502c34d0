//! A fast hasher for interning. Keys are short and come from no adversary. In an unoptimised build, the hasher of std costs more than all other work.

use super::node::Node;
use std::hash::{BuildHasherDefault, Hash, Hasher};

/// A hash map with the hasher [`Fold`].
pub(crate) type HashMap<K, V> = std::collections::HashMap<K, V, BuildHasherDefault<Fold>>;

/// Folds words into one by rotate, xor and multiply with an odd constant. This is the hash function of Firefox.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Fold(u64);

impl Fold {
    #[inline(always)]
    fn fold(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x517c_c1b7_2722_0a95);
    }

    /// Returns the half that depends on all bits of the input.
    fn upper(self) -> u32 {
        (self.0 >> 32) as u32
    }
}

impl Hasher for Fold {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.fold(u64::from(*byte)));
    }
    fn write_u32(&mut self, word: u32) {
        self.fold(u64::from(word));
    }
    fn write_u64(&mut self, word: u64) {
        self.fold(word);
    }
    fn write_i128(&mut self, word: i128) {
        self.fold(word as u64 ^ (word >> 64) as u64);
    }
    fn write_usize(&mut self, word: usize) {
        self.fold(word as u64);
    }
    fn finish(&self) -> u64 {
        self.0
    }
}

/// Returns the hash of a value.
pub(crate) fn of(thing: &impl Hash) -> u32 {
    let mut fold = Fold::default();
    thing.hash(&mut fold);
    fold.upper()
}

/// Returns the hash of a node.
pub(super) fn of_node(node: &Node) -> u32 {
    let mut fold = Fold::default();
    match node {
        Node::Number(value) => fold.fold(value.hash_word()),
        Node::Symbol(symbol) => symbol.hash(&mut fold),
        Node::Linear(constant, terms) => {
            fold.fold(constant.hash_word());
            for (c, id) in terms {
                fold.fold(c.hash_word());
                fold.fold(id.index() as u64);
            }
        }
        Node::Power(base, exponent) => {
            fold.fold(exponent.hash_word());
            fold.fold(base.index() as u64);
        }
        Node::Call(function, _) => fold.fold(*function as u64),
        Node::Compare(relation, ..) => fold.fold(*relation as u64),
        Node::Truth(value) => fold.fold(u64::from(*value)),
        Node::Product(_) | Node::Select(..) | Node::And(..) | Node::Or(..) | Node::Not(_) => {}
    }
    if !matches!(node, Node::Linear(..) | Node::Power(..)) {
        node.for_each_child(|id| fold.fold(id.index() as u64));
    }
    fold.upper()
}
