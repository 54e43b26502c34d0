//! Starts and steps that a method is tried with.

/// Pairs of a start and a step: all of them in an optimised build, else one of `few` (at most the length of either list), others for each `case`.
/// Each start and each step is among those of every case.
pub fn pairs<A: Copy, B: Copy>(starts: &[A], steps: &[B], few: usize, case: &str) -> impl Iterator<Item = (A, B)> {
    assert!((1..=starts.len().min(steps.len())).contains(&few), "a start or a step would be left out");
    let few = if cfg!(debug_assertions) { few } else { 1 };
    let first: usize = case.bytes().map(usize::from).sum();
    let steps_of = move |i: usize| {
        steps.iter().enumerate().filter(move |(j, _)| (i + j + first).is_multiple_of(few)).map(|(_, h)| *h)
    };
    starts.iter().enumerate().flat_map(move |(i, start)| steps_of(i).map(move |h| (*start, h)))
}
