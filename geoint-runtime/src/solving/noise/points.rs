//! Chooses the line on which a residual is evaluated to measure its rounding: its direction, and the distance of the first points.
//!
//! The points are x + distance·`direction`. They must be so far apart that terms round differently. They must be so near that the residual without rounding
//! looks smooth.

use crate::scalar::Real;
use crate::solving::size::{Units, kind, largest, largest_of_kind};

/// The fractional part of the golden ratio. Multiples of it are spread evenly modulo 1, because ratios of integers approximate it worst.
pub(super) const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The largest first distance, as a part of the unknowns, at which functions are assumed to look smooth. A larger one might take curvature for rounding.
const LARGEST_NEAR: f64 = 1e-3;

/// The position of the first points.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Start {
    /// Close to the point, where functions of the unknowns are smooth.
    Near,
    /// At the distance of corrections that are large even beside the unknowns. Functions that change on a shorter scale look rough there, too. Roughness
    /// therefore counts as rounding only if the function is smooth farther away.
    Corrections,
}

/// Writes the direction in which the unknowns move: for each one 0.5 to 1.5 times the largest size of its kind.
#[inline(never)]
pub(super) fn write_direction<R: Real>(sizes: &[R], units: Units, direction: &mut [R]) {
    for (i, d) in direction.iter_mut().enumerate() {
        let unit = largest_of_kind(sizes, units, i);
        // Each unknown moves by another part of its unit, so differences of neighbours change, too. The square makes these changes unequal.
        let golden = GOLDEN * ((i + 1) * (i + 1)) as f64;
        *d = R::from_f64(unit * (0.5 + (golden - libm::floor(golden))));
    }
}

/// Returns the first distance in units of `direction`, the largest of all kinds, and shortens `direction` for the other kinds. The unknowns of each kind then
/// start at `multiple` times their own last corrections `delta`. An angle, for example, may be large beside the scale on which its functions change.
///
/// With [`Start::Near`], a kind starts at ε if this distance exceeds [`LARGEST_NEAR`]. With [`Start::Corrections`], the result is `None` if it exceeds it in no
/// kind.
#[inline(never)]
pub(super) fn first_distance<R: Real>(
    delta: &[R],
    multiple: f64,
    units: Units,
    start: Start,
    direction: &mut [R],
) -> Option<f64> {
    // The first distance for kind k, from the largest ratio of a correction to the direction.
    let first = |direction: &[R], k: usize| {
        let part = |(i, (delta, size)): (usize, (&R, &R))| {
            if kind(units, i) != k || delta.magnitude() == 0.0 { 0.0 } else { delta.magnitude() / size.magnitude() }
        };
        let nearest = multiple * largest(delta.iter().zip(direction).enumerate().map(part));
        if nearest <= LARGEST_NEAR || start == Start::Corrections { nearest.max(R::epsilon()) } else { R::epsilon() }
    };
    let nearest = (0..units.kinds).map(|k| first(direction, k)).fold(0.0, f64::max);
    if start == Start::Corrections && nearest <= LARGEST_NEAR {
        return None;
    }
    for k in 0..units.kinds {
        let shortening = R::from_f64(first(direction, k) / nearest);
        direction.iter_mut().enumerate().filter(|(i, _)| kind(units, *i) == k).for_each(|(_, d)| *d *= shortening);
    }
    Some(nearest)
}
