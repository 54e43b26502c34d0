//! The equation of a step in a plane.

use super::newton::Newton;
use crate::scalar::Real;

/// The increment d = g(d) of two coordinates from `origin`, to rounding; `equation` gives g and 1 − g'. Not a number where there is none.
#[inline]
pub fn planar_step<R: Real>(origin: [R; 2], equation: impl Fn(&[R; 2]) -> ([R; 2], [[R; 2]; 2])) -> [R; 2] {
    let nothing = [R::from_f64(0.0); 2];
    // Two kinds: the coordinates may have different units.
    let found = Newton::<[R; 2]>::new(1, 2).solve(
        (&origin, None),
        || equation(&nothing).0,
        &mut (),
        |(), d| equation(d).0,
        |(), d, matrix| {
            let (image, slopes) = equation(d);
            *matrix = slopes;
            image
        },
    );
    found.map_or([R::from_f64(f64::NAN); 2], |(d, _)| d)
}
