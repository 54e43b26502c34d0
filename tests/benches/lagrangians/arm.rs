//! An arm in space.

use crate::paired::Pair;

pub(crate) fn steps() -> Vec<Pair> {
    vec![]
}
