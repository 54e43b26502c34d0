//! Conditions of the energy that rounding decides.
//!
//! The equation of a step decides every condition at the end of the step. The state that is returned has been rounded, and may lie on the
//! other side: where the energy jumps there, the step has not kept it.

use super::PhaseSpace;
use crate::scalar::{Enclosure, Interval, Real, bounds};
use crate::space::{Action, Array};
use core::marker::PhantomData;

/// The first jump of the energy, if any, between two points that differ by rounding, at one of which a condition holds.
///
/// Where the energy has no jump, or one that cannot be told from rounding, there is none.
#[inline(always)]
pub(crate) fn jump_between<S: PhaseSpace<R>, R: Real>(
    system: &S,
    t: R,
    z: [&S::Phase; 2],
    s: [&S::Action; 2],
) -> Option<&'static str> {
    if Jumps::<S, R>::NONE || system.same_sides(t, z, s) { None } else { search(system, t, z, s) }
}

/// What is known of jumps at compile time.
struct Jumps<S, R>(PhantomData<(S, R)>);

impl<S: PhaseSpace<R>, R: Real> Jumps<S, R> {
    /// Nothing of a search is compiled then.
    const NONE: bool = S::JUMPS.is_empty();
}

#[cold]
#[inline(never)]
fn search<S: PhaseSpace<R>, R: Real>(system: &S, t: R, z: [&S::Phase; 2], s: [&S::Action; 2]) -> Option<&'static str> {
    let constant = |x: Interval| Enclosure::<R>::new(x, Interval::WHOLE);
    let mut all = S::Phase::fill(constant(Interval::WHOLE));
    let all = S::Phase::entries(&mut all);
    for (i, x) in all.iter_mut().enumerate() {
        *x = constant(bounds(z[0].as_slice()[i]).hull(bounds(z[1].as_slice()[i])));
    }
    let s = s.map(|s| bounds(s.scalar().unwrap_or(R::from_f64(0.0))));
    let (t, s) = (constant(bounds(t)), constant(s[0].hull(s[1])));
    (0..S::JUMPS.len()).find_map(|i| {
        let [side, height] = system.jump(i, Enclosure::constant, t, all, s);
        (side.value.contains_zero() && !height.value.contains_zero()).then_some(S::JUMPS[i])
    })
}
