//! Solves the equation of an implicit step of two coordinates, for the pieces of [`PlanarSplitting`](crate::PlanarSplitting).

use crate::scalar::{Real, zero};
use crate::solving::equation::{Effort, Solver, StepEquation, Units};
use crate::solving::newton::Newton;
use crate::space::vector::difference;

/// Returns the increment d = g(d) of two coordinates from `origin`, solved to rounding. `equation` returns g and the matrix 1 − ∂g/∂d.
///
/// The result is NaN if Newton's iteration finds no solution.
#[inline]
pub fn planar_step<R: Real>(origin: [R; 2], equation: impl Fn(&[R; 2]) -> ([R; 2], [[R; 2]; 2]) + Copy) -> [R; 2] {
    // Two kinds of one coordinate each: their units may differ.
    let solution = Newton::<[R; 2]>::new(Units { alike: 1, kinds: 2 }).solve(&Planar { origin, equation }, &mut ());
    solution.map_or([R::from_f64(f64::NAN); 2], |solution| solution.x)
}

/// The equation d = g(d) in the form that the solver needs.
#[derive(Clone, Copy)]
struct Planar<R, F> {
    origin: [R; 2],
    equation: F,
}

impl<R: Real, F: Fn(&[R; 2]) -> ([R; 2], [[R; 2]; 2]) + Copy> StepEquation<[R; 2], ()> for Planar<R, F> {
    const EFFORT: Effort = Effort::Fast;

    fn origin(&self) -> [R; 2] {
        self.origin
    }

    fn guess(&self) -> [R; 2] {
        (self.equation)(&[zero(); 2]).0
    }

    #[inline(always)]
    fn residual(&self, (): &mut (), d: &[R; 2], matrix: &mut [[R; 2]; 2]) -> [R; 2] {
        let (image, slopes) = (self.equation)(d);
        *matrix = slopes;
        difference(d, &image)
    }
}
