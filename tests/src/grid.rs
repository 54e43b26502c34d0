//! Starts and steps that a method is tried with.

/// Returns pairs of a start and a step. An optimised build returns all pairs. Other builds return one pair in `few`, and other pairs for each `case`.
/// Every case contains each start and each step, because `few` is at most the length of either list.
pub fn pairs<A: Copy, B: Copy>(starts: &[A], steps: &[B], few: usize, case: &str) -> impl Iterator<Item = (A, B)> {
    assert!((1..=starts.len().min(steps.len())).contains(&few), "a start or a step would be left out");
    let few = if cfg!(debug_assertions) { few } else { 1 };
    let first: usize = case.bytes().map(usize::from).sum();
    let steps_of = move |i: usize| {
        steps.iter().enumerate().filter(move |(j, _)| (i + j + first).is_multiple_of(few)).map(|(_, h)| *h)
    };
    starts.iter().enumerate().flat_map(move |(i, start)| steps_of(i).map(move |h| (*start, h)))
}
