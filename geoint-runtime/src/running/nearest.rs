//! The names nearest to a name that no method has.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::Display;

/// The largest number of names in a suggestion.
const MOST_NAMES: usize = 3;

/// The candidates with the smallest edit distance from a name, without regard to case.
pub(super) struct Nearest {
    name: Vec<char>,
    /// Sorted by distance, at most [`MOST_NAMES`].
    found: Vec<(usize, String)>,
}

impl Nearest {
    /// Starts a search without candidates.
    pub(super) fn to(name: &str) -> Self {
        Nearest { name: in_lower_case(name), found: Vec::new() }
    }

    /// Keeps the candidate if it is near. At most a third of the letters may differ, so an empty name has no near candidate.
    pub(super) fn offer(&mut self, candidate: impl Display) {
        let candidate = candidate.to_string();
        let distance = distance(&self.name, &in_lower_case(&candidate));
        if distance > self.name.len() / 3
            || candidate.is_empty()
            || self.found.iter().any(|(_, name)| *name == candidate)
        {
            return;
        }
        let place = self.found.partition_point(|(smaller, _)| *smaller <= distance);
        self.found.insert(place, (distance, candidate));
        self.found.truncate(MOST_NAMES);
    }

    /// Returns the nearest names, the best one first. A name with two more differences than the best one is left out.
    pub(super) fn names(self) -> Vec<String> {
        let best = self.found.first().map_or(0, |(distance, _)| *distance);
        self.found.into_iter().filter(|(distance, _)| *distance <= best + 1).map(|(_, name)| name).collect()
    }
}

fn in_lower_case(name: &str) -> Vec<char> {
    name.chars().flat_map(char::to_lowercase).collect()
}

/// Returns the smallest number of letters that are inserted, removed or replaced to turn `a` into `b` (V. I. Levenshtein, Sov. Phys. Dokl. 10 (1966) 707).
fn distance(a: &[char], b: &[char]) -> usize {
    // Entry j is the distance between the letters of `a` so far and the first j letters of `b`.
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for j in 0..b.len() {
            let replaced = diagonal + usize::from(*letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(name: &str) -> Vec<String> {
        let mut nearest = Nearest::to(name);
        for candidate in ["RK4", "BlanesMoan4", "BlanesMoan6", "BlanesMoan4X", "BlanesMoan4", "Gauss<2>", "Gauss<3>"] {
            nearest.offer(candidate);
        }
        nearest.names()
    }

    #[test]
    fn distances_are_those_of_levenshtein() {
        for (a, b, expected) in
            [("kitten", "sitting", 3), ("", "abc", 3), ("abc", "", 3), ("flaw", "lawn", 2), ("rk4", "rk4", 0)]
        {
            assert_eq!(distance(&in_lower_case(a), &in_lower_case(b)), expected, "{a} {b}");
        }
    }

    #[test]
    fn near_names_come_first_and_far_names_are_left_out() {
        assert_eq!(nearest("BlanesMoan5"), ["BlanesMoan4", "BlanesMoan6", "BlanesMoan4X"]);
        assert_eq!(nearest("blanesmoan4x"), ["BlanesMoan4X", "BlanesMoan4"]);
        assert_eq!(nearest("rk4"), ["RK4"]);
        assert_eq!(nearest("Gaus<3>"), ["Gauss<3>", "Gauss<2>"]);
        for far in ["", "R", "Leapfrog", "Runge"] {
            assert!(nearest(far).is_empty(), "{far}");
        }
    }
}
