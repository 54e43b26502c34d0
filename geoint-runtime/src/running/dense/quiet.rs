//! Fast first pass of the search for an event: it takes the steps in which no function comes near zero.
//!
//! The full search copies the run and evaluates the functions many times. In most steps, three values of each function show that no zero is near.

use super::{Dense, has_reached};
use crate::running::StepError;
use crate::running::trajectory::Scalar;
use crate::scalar::{Real, signed};
use crate::space::Array;

/// The first step has no previous step. The third value is then taken after this part of the step: short against the step, long against rounding.
const FIRST_PART: f64 = 1.0 / 1024.0;

/// A function is far from zero if it exceeds this multiple of its change along the step. A factor of 1 would suffice for a parabola.
const FAR: f64 = 2.0;

/// Takes steps to the time `t` as long as every function stays far from zero. Returns `true` if it took a step and the run is at `t`. Returns `false`
/// if a function may come near zero in the next step, or if the run was at `t` already. The full search then continues from the state of the run.
///
/// A function that dips to zero and back faster than a parabola shows is missed, as in the full search.
///
/// # Errors
/// See [`StepError`]. The run holds its last good state.
pub(super) fn skip_quiet_steps<T: Dense, G: Array<Real = Scalar<T>>>(
    run: &mut T,
    t: Scalar<T>,
    g: impl Fn(&T::State) -> G,
) -> Result<bool, StepError> {
    let backwards = run.steps_backwards();
    if has_reached(run.time(), t, backwards) {
        return Ok(false);
    }
    // Time and values at the start of the step before.
    let mut previous = None;
    let mut first = g(&run.state());
    while !has_reached(run.time(), t, backwards) {
        let start = run.clone();
        if !run.step_towards(t)? {
            // No whole step fits before `t`.
            run.end_at(t)?;
        }
        let last = g(&run.state());
        let step = run.time() - start.time();
        let (time, third) = match previous {
            Some(previous) => previous,
            None => {
                let time = start.time() + Scalar::<T>::from_f64(FIRST_PART) * step;
                (time, g(&T::between(&start, run, time)?))
            }
        };
        let part = signed(time - start.time()) / signed(step);
        let is_far = |i: usize| {
            let [third, first, last] = [&third, &first, &last].map(|g: &G| signed(g.as_slice()[i]));
            // The parabola through the values at `part`, 0 and 1 is first + slope u + bend u (u − part)/(1 − part).
            let slope = (third - first) / part;
            let bend = last - first - slope;
            // The comparison is false for values that are not numbers.
            first.abs() > FAR * (slope.abs() + bend.abs())
        };
        if !(0..G::LEN).all(is_far) {
            *run = start;
            return Ok(false);
        }
        previous = Some((start.time(), first));
        first = last;
    }
    Ok(true)
}
