//! The equation of a step in a plane.

use super::equation::StepEquation;
use super::newton::Newton;
use crate::scalar::{Real, zero};

/// The increment d = g(d) of two coordinates from `origin`, to rounding; `equation` gives g and 1 − g'. Not a number where there is none.
#[inline]
pub fn planar_step<R: Real>(origin: [R; 2], equation: impl Fn(&[R; 2]) -> ([R; 2], [[R; 2]; 2]) + Copy) -> [R; 2] {
    // Two kinds: the coordinates may have different units.
    let found = Newton::<[R; 2]>::new(1, 2).solve(&Planar { origin, equation }, &mut ());
    if found.outcome.is_ok() { found.x } else { [R::from_f64(f64::NAN); 2] }
}

#[derive(Clone, Copy)]
struct Planar<R, F> {
    origin: [R; 2],
    equation: F,
}

impl<R: Real, F: Fn(&[R; 2]) -> ([R; 2], [[R; 2]; 2]) + Copy> StepEquation<[R; 2], ()> for Planar<R, F> {
    const PATIENT: bool = false;

    fn origin(&self) -> [R; 2] {
        self.origin
    }

    fn explicit(&self) -> [R; 2] {
        (self.equation)(&[zero(); 2]).0
    }

    #[inline(always)]
    fn evaluate(&self, (): &mut (), d: &[R; 2], matrix: &mut [[R; 2]; 2]) -> [R; 2] {
        let (image, slopes) = (self.equation)(d);
        *matrix = slopes;
        image
    }
}
