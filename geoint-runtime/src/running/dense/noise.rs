//! Rounding error of a function of the state.

use crate::scalar::Real;
use crate::space::{Action, Array, Snapshot};

/// Returns the sum of the changes of a function when each coordinate, and time, is changed by one rounding error.
pub(super) fn noise<X: Snapshot>(state: &X, value: impl Fn(&X) -> f64) -> f64 {
    let (here, (t, z, s)) = (value(state), state.parts());
    let nudge = |x: &mut X::Real| *x *= X::Real::from_f64(1.0 + X::Real::epsilon());
    let mut noise = 0.0;
    let mut include = |(t, z, s)| noise += (value(&X::of(t, z, s)) - here).abs();
    for k in 0..X::Phase::LEN {
        let mut z = z;
        nudge(&mut z.as_mut_slice()[k]);
        include((t, z, s));
    }
    let (mut moved, mut later) = (s, t);
    moved.numbers_mut().iter_mut().for_each(nudge);
    nudge(&mut later);
    include((t, z, moved));
    include((later, z, s));
    // No comparison is possible without a number.
    if noise >= 0.0 { noise } else { 0.0 }
}
