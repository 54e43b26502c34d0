//! Tolerated error of a step in each coordinate.

use crate::scalar::{Real, signed};
use crate::solving::rounding::ROUNDINGS;
use crate::solving::size::largest;
use crate::space::{Action, Array, PerCoordinate, Record, Tape};

/// Number of times of change of the initial state during which errors act on other coordinates. In later steps, step length over expected part is 3
/// to 7 of these times. With 1 and 2, a chain with a wave took 2.2 and 1.4 times as many steps.
pub(crate) const REACH: f64 = 4.0;

/// Tolerated error of a step in every coordinate: a part of the largest magnitude that the coordinate has had, plus an absolute error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance<A, Z> {
    pub(crate) relative: f64,
    pub(crate) absolute: PerCoordinate<A, Z>,
    /// Largest magnitude that each coordinate has had.
    pub(crate) sizes: PerCoordinate<A, Z>,
    /// Error that the tolerated errors of other coordinates cause in each coordinate, divided by the relative tolerance.
    caused: PerCoordinate<A, Z>,
    /// Longest time of change of the state so far.
    longest: f64,
    /// Whether errors are much smaller than the step length suggests, as for perturbation methods. A long step then gives no estimate of the time of
    /// change.
    errors_are_small: bool,
}

/// Data by which the error of a step is judged.
pub(crate) struct Judged<'a, A, Z> {
    /// Expected step length divided by the time in which the state changes.
    pub(crate) part: f64,
    pub(crate) before: &'a PerCoordinate<A, Z>,
    pub(crate) after: &'a PerCoordinate<A, Z>,
}

impl<A: Array, Z: Action<A::Real>> Record<A::Real> for Tolerance<A, Z> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sizes.record(tape);
        self.caused.record(tape);
        tape.number(&mut self.longest);
    }
}

impl<A: Array, Z: Action<A::Real>> Tolerance<A, Z> {
    pub(crate) fn new(relative: f64, errors_are_small: bool) -> Self {
        let zero = PerCoordinate::zero();
        Tolerance { relative, absolute: zero, sizes: zero, caused: zero, longest: 0.0, errors_are_small }
    }

    /// Includes a point from which a run continues.
    pub(crate) fn start(&mut self, x: &PerCoordinate<A, Z>) {
        keep(&mut self.sizes, x);
    }

    /// Returns an unusable tolerance, if there is one.
    pub(crate) fn unusable(&self) -> Option<f64> {
        let negative = |x: &A::Real| x.any_below(0.0) || !x.magnitude().is_finite();
        let absolute = self.absolute.numbers().find(negative).map(signed);
        if is_part(self.relative) { absolute } else { Some(self.relative) }
    }

    /// Returns the size of a coordinate in a step to `after`. If the coordinate was zero so far, its speed in this step is kept for the time in which the
    /// state changes. The value at the end is its size.
    fn size(&self, i: usize, after: f64, part: f64) -> f64 {
        match self.sizes.at(i).magnitude() {
            0.0 => after / part,
            size => size.max(after),
        }
    }

    /// Returns whether a coordinate leaves zero for the first time.
    #[inline(always)]
    pub(crate) fn is_first_motion(&self, after: &PerCoordinate<A, Z>) -> bool {
        let moves = |(size, x): (A::Real, A::Real)| size.magnitude() == 0.0 && x.magnitude() > 0.0;
        self.sizes.numbers().zip(after.numbers()).any(moves)
    }

    /// Includes a step between two points. Its length is `part` of the time in which the state changes.
    pub(crate) fn include(
        &mut self,
        [before, after]: [&PerCoordinate<A, Z>; 2],
        h: f64,
        part: f64,
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) {
        let mut reached = *after;
        for (i, x) in reached.numbers_mut().enumerate() {
            *x = A::Real::from_f64(self.size(i, x.magnitude(), part));
        }
        keep(&mut self.sizes, &reached);
        self.changes_in((h.abs() / part).min(f64::MAX), before, rates);
    }

    /// Updates the caused errors, if the state changes in a longer time than any before.
    pub(crate) fn changes_in(
        &mut self,
        time: f64,
        x: &PerCoordinate<A, Z>,
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) {
        if time > self.longest && time < f64::INFINITY {
            self.longest = time;
            let pace = if self.errors_are_small { self.pace(&rates(x)) } else { f64::INFINITY };
            self.cause(x, time.min(pace), rates);
        }
    }

    /// Returns the shortest time in which a coordinate changes by its own size.
    #[cold]
    fn pace(&self, rates: &PerCoordinate<A, Z>) -> f64 {
        let moving = (0..PerCoordinate::<A, Z>::LEN).filter(|i| self.sizes.at(*i).magnitude() > 0.0);
        moving.map(|i| self.sizes.at(i).magnitude() / rates.at(i).magnitude()).fold(f64::INFINITY, f64::min)
    }

    /// Estimates the error that the tolerated errors of some coordinates cause in the others within `time`. This error is tolerated there as well.
    /// Without it, a coordinate that a motion has not reached yet, or that contains only rounding, would force tiny steps.
    ///
    /// Computed at the start of a run, and whenever a time of change exceeds all before.
    #[cold]
    fn cause(
        &mut self,
        x: &PerCoordinate<A, Z>,
        time: f64,
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) {
        let (here, mut sizes) = (rates(x), *x);
        // Each round reaches the next neighbours, and sets only coordinates that earlier rounds left unchanged.
        for _ in 0..PerCoordinate::<A, Z>::LEN {
            let mut next = sizes;
            // Equal and alternating signs: errors of neighbours may cancel in one of the two patterns.
            for alternate in [1.0, -1.0] {
                let (mut moved, mut sign) = (*x, 1.0);
                for (x, size) in moved.numbers_mut().zip(sizes.numbers()) {
                    *x += A::Real::from_f64(sign * self.relative * size.magnitude());
                    sign *= alternate;
                }
                let there = rates(&moved);
                for (i, next) in next.numbers_mut().enumerate() {
                    let change = (there.at(i) - here.at(i)).magnitude();
                    let size = time * change / self.relative;
                    let raised = sizes.at(i) != x.at(i);
                    // The rates may be undefined at the perturbed point.
                    if !raised && size > next.magnitude() && size < f64::INFINITY {
                        *next = A::Real::from_f64(size);
                    }
                }
            }
            if next == sizes {
                break;
            }
            sizes = next;
        }
        keep(&mut self.caused, &sizes);
    }

    /// Returns the largest entry of each estimated error of a step, in units of the tolerance.
    ///
    /// A coordinate whose value and rate are zero is not measured in its first step. Other coordinates drive it, and only its order of magnitude is
    /// right.
    pub(crate) fn errors<const N: usize>(
        &self,
        step: &Judged<'_, A, Z>,
        estimates: &[PerCoordinate<A, Z>; N],
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) -> [f64; N] {
        let moving = self.sizes.numbers().all(|size| size.magnitude() > 0.0);
        let rates = if moving { PerCoordinate::zero() } else { rates(step.before) };
        let mut errors = [0.0; N];
        for i in 0..PerCoordinate::<A, Z>::LEN {
            if !moving && self.sizes.at(i).magnitude() == 0.0 && rates.at(i).magnitude() == 0.0 {
                continue;
            }
            let tolerated = self.of(i, step.after.at(i).magnitude(), step.part);
            for (error, estimate) in errors.iter_mut().zip(estimates) {
                let estimate = estimate.at(i).magnitude();
                // The quotient of two zeros counts as zero.
                let entry = if estimate == 0.0 { 0.0 } else { estimate / tolerated };
                *error = largest([*error, entry].into_iter());
            }
        }
        errors
    }

    /// Returns the tolerated error of coordinate `i` in a step to `after`. The last term covers values below the normal numbers, which have few
    /// digits.
    pub(crate) fn of(&self, i: usize, after: f64, part: f64) -> f64 {
        let size = self.size(i, after, part).max(self.caused.at(i).magnitude());
        let rounding = ROUNDINGS * A::Real::epsilon() * A::Real::smallest();
        self.relative * size + self.absolute.at(i).magnitude() + rounding
    }
}

/// Returns whether a relative tolerance is between 0 and 1. An error as large as the state leaves no result.
pub(crate) fn is_part(tolerance: f64) -> bool {
    tolerance > 0.0 && tolerance < 1.0
}

/// Raises the sizes to the magnitudes of a point. Infinite coordinates are ignored, because no error could be measured by them.
fn keep<A: Array, Z: Action<A::Real>>(sizes: &mut PerCoordinate<A, Z>, x: &PerCoordinate<A, Z>) {
    for (size, x) in sizes.numbers_mut().zip(x.numbers()) {
        if x.magnitude() > size.magnitude() && x.magnitude() < f64::INFINITY {
            *size = A::Real::from_f64(x.magnitude());
        }
    }
}
