//! Which error of a step is tolerated, coordinate by coordinate?

use crate::scalar::{Real, signed};
use crate::solving::rounding::ROUNDINGS;
use crate::solving::size::largest;
use crate::space::{Action, Array, PerCoordinate, Record, Tape};

/// For so many of the times in which a start changes by itself errors act on other coordinates: later on a step over the part that it takes is as
/// long, 3 to 7 of them. With 1 and 2 a chain with a wave took 2.2 and 1.4 times as many steps.
pub(crate) const REACH: f64 = 4.0;

/// The tolerance of a step's error in every coordinate: a part of the largest magnitude that the coordinate has had, and
/// an absolute error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance<A, Z> {
    pub(crate) relative: f64,
    pub(crate) absolute: PerCoordinate<A, Z>,
    /// The largest magnitude that a coordinate has had.
    pub(crate) sizes: PerCoordinate<A, Z>,
    /// Of what errors of other coordinates cause in it, over the tolerance.
    caused: PerCoordinate<A, Z>,
    /// The longest time so far in which the state changes.
    longest: f64,
    /// Whether errors are a small part of what the length of a step lets expect: long steps then say nothing of the time in which the state changes.
    small: bool,
}

/// A step as its error is judged.
pub(crate) struct Judged<'a, A, Z> {
    /// What part of the time it takes in which the state changes.
    pub(crate) part: f64,
    pub(crate) before: &'a PerCoordinate<A, Z>,
    pub(crate) after: &'a PerCoordinate<A, Z>,
    /// The estimated error.
    pub(crate) gap: &'a PerCoordinate<A, Z>,
}

impl<A: Array, Z: Action<A::Real>> Record<A::Real> for Tolerance<A, Z> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sizes.record(tape);
        self.caused.record(tape);
        tape.number(&mut self.longest);
    }
}

impl<A: Array, Z: Action<A::Real>> Tolerance<A, Z> {
    pub(crate) fn new(relative: f64, small: bool) -> Self {
        let zero = PerCoordinate::zero();
        Tolerance { relative, absolute: zero, sizes: zero, caused: zero, longest: 0.0, small }
    }

    /// Includes a point from which a run goes on.
    pub(crate) fn start(&mut self, x: &PerCoordinate<A, Z>) {
        keep(&mut self.sizes, x);
    }

    /// A tolerance that is none.
    pub(crate) fn unusable(&self) -> Option<f64> {
        let negative = |x: &A::Real| x.any_below(0.0) || !x.magnitude().is_finite();
        let absolute = self.absolute.numbers().find(negative).map(signed);
        if is_part(self.relative) { absolute } else { Some(self.relative) }
    }

    /// The size by which a coordinate is measured in a step to `after`: one that was zero so far has the size that it reaches at this
    /// speed in the time in which the state changes.
    fn size(&self, i: usize, after: f64, part: f64) -> f64 {
        match self.sizes.at(i).magnitude() {
            0.0 => after / part,
            size => size.max(after),
        }
    }

    /// Whether a coordinate is not zero for the first time.
    #[inline(always)]
    pub(crate) fn is_first_motion(&self, after: &PerCoordinate<A, Z>) -> bool {
        let moves = |(size, x): (A::Real, A::Real)| size.magnitude() == 0.0 && x.magnitude() > 0.0;
        self.sizes.numbers().zip(after.numbers()).any(moves)
    }

    /// Includes a step from one point to another, which is a part of the time in which the state changes.
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

    /// The state at `x` changes in so long a time: what is caused within it is measured if it is longer than all before.
    pub(crate) fn changes_in(
        &mut self,
        time: f64,
        x: &PerCoordinate<A, Z>,
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) {
        if time > self.longest && time < f64::INFINITY {
            self.longest = time;
            let pace = if self.small { self.pace(&rates(x)) } else { f64::INFINITY };
            self.cause(x, time.min(pace), rates);
        }
    }

    /// The time in which the coordinate that changes fastest does so by itself.
    #[cold]
    fn pace(&self, rates: &PerCoordinate<A, Z>) -> f64 {
        let moving = (0..PerCoordinate::<A, Z>::LEN).filter(|i| self.sizes.at(*i).magnitude() > 0.0);
        moving.map(|i| self.sizes.at(i).magnitude() / rates.at(i).magnitude()).fold(f64::INFINITY, f64::min)
    }

    /// What tolerated errors of some coordinates cause in others within the time in which the state changes is tolerated there as
    /// well: a motion that has not reached a coordinate yet, or is nothing but rounding there, does not hold up the others.
    ///
    /// It is measured at a start, whatever the length of the first step, and while steps become longer than all before.
    #[cold]
    fn cause(
        &mut self,
        x: &PerCoordinate<A, Z>,
        time: f64,
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) {
        let (here, mut sizes) = (rates(x), *x);
        // Each round reaches the next neighbours, and raises what was not raised before.
        for _ in 0..PerCoordinate::<A, Z>::LEN {
            let mut next = sizes;
            // With equal and with alternating signs: errors of neighbours may cancel.
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
                    // What is not a number is no size.
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

    /// The largest error of a step in units of what is tolerated.
    ///
    /// A coordinate that is zero, and whose rate is, is not measured in its first step: it is driven by others, and only the order
    /// of magnitude of what it becomes is right.
    pub(crate) fn error(
        &self,
        step: &Judged<'_, A, Z>,
        rates: impl Fn(&PerCoordinate<A, Z>) -> PerCoordinate<A, Z>,
    ) -> f64 {
        let entry = |x: &PerCoordinate<A, Z>, i: usize| x.at(i).magnitude();
        let moving = self.sizes.numbers().all(|size| size.magnitude() > 0.0);
        let rates = if moving { PerCoordinate::zero() } else { rates(step.before) };
        largest((0..PerCoordinate::<A, Z>::LEN).map(|i| {
            let gap = entry(step.gap, i);
            if gap == 0.0 || (entry(&self.sizes, i) == 0.0 && entry(&rates, i) == 0.0) {
                return 0.0;
            }
            gap / self.of(i, entry(step.after, i), step.part)
        }))
    }

    /// The error that is tolerated in coordinate `i` in a step to `after`. Below the normal numbers a coordinate has few digits, and no rounding of these
    /// counts.
    pub(crate) fn of(&self, i: usize, after: f64, part: f64) -> f64 {
        let size = self.size(i, after, part).max(self.caused.at(i).magnitude());
        let rounding = ROUNDINGS * A::Real::epsilon() * A::Real::smallest();
        self.relative * size + self.absolute.at(i).magnitude() + rounding
    }
}

/// Whether a relative tolerance is a part of a state: errors as large as that are no result.
pub(crate) fn is_part(tolerance: f64) -> bool {
    tolerance > 0.0 && tolerance < 1.0
}

/// Includes a point in the largest magnitudes: by a coordinate that is infinite nothing could be measured.
fn keep<A: Array, Z: Action<A::Real>>(sizes: &mut PerCoordinate<A, Z>, x: &PerCoordinate<A, Z>) {
    for (size, x) in sizes.numbers_mut().zip(x.numbers()) {
        if x.magnitude() > size.magnitude() && x.magnitude() < f64::INFINITY {
            *size = A::Real::from_f64(x.magnitude());
        }
    }
}
