//! A hasher for interning: short keys, no adversary, and an unoptimised build, in which std's costs more than the rest.

use std::hash::{BuildHasherDefault, Hasher};

/// A hash map with [`Fold`].
pub(crate) type HashMap<K, V> = std::collections::HashMap<K, V, BuildHasherDefault<Fold>>;

/// Folds words into one: rotate, xor, multiply by an odd constant (the hash of the Firefox browser).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Fold(u64);

impl Fold {
    fn fold(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x517c_c1b7_2722_0a95);
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
        self.fold(word as u64);
        // Most numbers are short.
        if i64::try_from(word).is_err() {
            self.fold((word >> 64) as u64);
        }
    }
    fn write_usize(&mut self, word: usize) {
        self.fold(word as u64);
    }
    fn write_isize(&mut self, word: isize) {
        self.fold(word as u64);
    }
    fn finish(&self) -> u64 {
        self.0
    }
}
