//! Steps in which all functions stay far from zero need no search for events.

use super::{Dense, has_reached};
use crate::running::StepError;
use crate::running::trajectory::Scalar;
use crate::scalar::{Real, signed};
use crate::space::Array;

/// The slope at the start of the first step is measured over this part of it.
const PART: f64 = 1.0 / 1024.0;

/// A function is far from zero if it is larger than this multiple of its change along a step.
const FAR: f64 = 2.0;

/// Takes steps to the time `t` while every function stays far from zero. Returns whether the run is at `t`; if not, it is at the start of a step
/// in which a function may come near zero.
///
/// The change along a step is bounded by the parabola through three values, as in the search for pairs of zeros.
pub(super) fn pass<T: Dense, G: Array<Real = Scalar<T>>>(
    run: &mut T,
    t: Scalar<T>,
    g: impl Fn(&T::State) -> G,
) -> Result<bool, StepError> {
    let backwards = run.steps_backwards();
    if has_reached(run.time(), t, backwards) {
        return Ok(false);
    }
    // Time and values at the start of the step before.
    let mut earlier = None;
    let mut before = g(&run.state());
    while !has_reached(run.time(), t, backwards) {
        let start = run.clone();
        if !run.step_towards(t)? {
            run.end_at(t)?;
        }
        let after = g(&run.state());
        let step = run.time() - start.time();
        let (time, values) = match earlier {
            Some(earlier) => earlier,
            None => {
                let time = start.time() + Scalar::<T>::from_f64(PART) * step;
                (time, g(&T::between(&start, run, time)?))
            }
        };
        let part = signed(time - start.time()) / signed(step);
        let is_far = |i: usize| {
            let [third, first, last] = [&values, &before, &after].map(|g: &G| signed(g.as_slice()[i]));
            let slope = (third - first) / part;
            let bend = (last - first - slope) / (1.0 - part);
            // Values that are no numbers are not far.
            first.abs() > FAR * (slope.abs() + 2.0 * bend.abs())
        };
        if !(0..G::LEN).all(is_far) {
            *run = start;
            return Ok(false);
        }
        earlier = Some((start.time(), before));
        before = after;
    }
    Ok(true)
}
