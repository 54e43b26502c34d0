//! Where a residual is evaluated to see its rounding: how far apart, in which direction.

use crate::scalar::Real;
use crate::solving::size::{kind, largest, largest_of_kind};

/// The irrational number that has the worst approximations by ratios.
pub(super) const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Farther than this a function that is smooth may not look so.
const MOST_NEAR: f64 = 1e-3;

/// Where the first points are.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Start {
    /// Where functions of the unknowns are smooth.
    Near,
    /// As far as corrections are large, even beside the unknowns. There a function that changes faster does not look smooth either: what looks
    /// like rounding is believed only if the function is smooth farther away.
    Corrections,
}

/// The direction in which unknowns are moved.
#[inline(never)]
pub(super) fn along<R: Real>(sizes: &[R], kinds: [usize; 2], direction: &mut [R]) {
    for (i, d) in direction.iter_mut().enumerate() {
        let unit = largest_of_kind(sizes, kinds, i);
        // By different parts of that, so that differences of neighbours change, and each by something else.
        let golden = GOLDEN * ((i + 1) * (i + 1)) as f64;
        *d = R::from_f64(unit * (0.5 + (golden - libm::floor(golden))));
    }
}

/// How much of a direction the first distance is. Unknowns of each kind begin near their own corrections: an angle may be large beside all in
/// which a function of it changes. `None` if corrections are nowhere large beside the unknowns.
#[inline(never)]
pub(super) fn begin<R: Real>(
    (delta, farther): (&[R], f64),
    kinds: [usize; 2],
    start: Start,
    direction: &mut [R],
) -> Option<f64> {
    // The largest part of the direction that corrections of a kind are.
    let first = |direction: &[R], k: usize| {
        let part = |(i, (delta, size)): (usize, (&R, &R))| {
            if kind(kinds, i) != k || delta.magnitude() == 0.0 { 0.0 } else { delta.magnitude() / size.magnitude() }
        };
        let nearest = farther * largest(delta.iter().zip(direction).enumerate().map(part));
        if nearest <= MOST_NEAR || start == Start::Corrections { nearest.max(R::epsilon()) } else { R::epsilon() }
    };
    let nearest = (0..kinds[1]).map(|k| first(direction, k)).fold(0.0, f64::max);
    if start == Start::Corrections && nearest <= MOST_NEAR {
        return None;
    }
    for k in 0..kinds[1] {
        let less = R::from_f64(first(direction, k) / nearest);
        direction.iter_mut().enumerate().filter(|(i, _)| kind(kinds, *i) == k).for_each(|(_, d)| *d *= less);
    }
    Some(nearest)
}
