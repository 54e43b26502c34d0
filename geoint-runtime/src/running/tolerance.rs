//! Which error of a step is tolerated, coordinate by coordinate?

use crate::scalar::{Real, signed};
use crate::solving::size::{Sizes, largest};
use crate::space::Array;

/// The tolerance of a step's error in every coordinate of (q, p): a part of the largest magnitude that the coordinate has had, and
/// an absolute error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance<A: Array> {
    pub(crate) relative: f64,
    absolute: A,
    /// Of what a coordinate was.
    sizes: Sizes<A>,
    /// Of what errors of other coordinates cause in it, over the tolerance.
    caused: Sizes<A>,
    /// The longest time so far in which the state changes.
    longest: f64,
}

/// A step as its error is judged.
pub(crate) struct Judged<'a, A: Array> {
    /// What part of the time it takes in which the state changes.
    pub(crate) part: f64,
    pub(crate) before: &'a A,
    pub(crate) after: &'a A,
    /// The estimated error.
    pub(crate) gap: &'a A,
}

impl<A: Array> Tolerance<A> {
    pub(crate) fn new(relative: f64, x: &A) -> Self {
        let (mut sizes, caused) = (Sizes::new(), Sizes::new());
        sizes.keep(x);
        Tolerance { relative, absolute: A::zero(), sizes, caused, longest: 0.0 }
    }

    pub(crate) fn absolute(&mut self, absolute: A) {
        self.absolute = absolute;
    }

    /// A tolerance that is none.
    pub(crate) fn unusable(&self) -> Option<f64> {
        let positive = self.relative > 0.0 && self.relative < f64::INFINITY;
        let negative = |x: &&A::Real| x.any_below(0.0) || !x.magnitude().is_finite();
        let absolute = self.absolute.as_slice().iter().find(negative).map(|x| signed(*x));
        if positive { absolute } else { Some(self.relative) }
    }

    /// The size by which a coordinate is measured in a step to `after`: one that was zero so far has the size that it reaches at this
    /// speed in the time in which the state changes.
    fn size(&self, i: usize, after: f64, part: f64) -> f64 {
        match self.sizes.of(i) {
            0.0 => after / part,
            size => size.max(after),
        }
    }

    /// Includes a step from one point to another, which is a part of the time in which the state changes. `field` gives the rates of
    /// a point, where only their magnitudes and differences count.
    pub(crate) fn include(&mut self, [before, after]: [&A; 2], h: f64, part: f64, field: impl Fn(&A) -> A) {
        let mut reached = *after;
        for (i, x) in reached.as_mut_slice().iter_mut().enumerate() {
            *x = A::Real::from_f64(self.size(i, x.magnitude(), part));
        }
        self.sizes.keep(&reached);
        let time = h.abs() / part;
        if time > self.longest {
            self.longest = time;
            self.cause(before, time, field);
        }
    }

    /// What tolerated errors of some coordinates cause in others within the time in which the state changes is tolerated there as
    /// well: a motion that has not reached a coordinate yet, or is nothing but rounding there, does not hold up the others.
    ///
    /// It is measured while steps become longer than all before: the few steps after a start.
    #[cold]
    fn cause(&mut self, x: &A, time: f64, field: impl Fn(&A) -> A) {
        let (here, mut sizes) = (field(x), *x);
        // Each round reaches the next neighbours, and raises what was not raised before.
        for _ in 0..A::LEN {
            let mut next = sizes;
            // With equal and with alternating signs: errors of neighbours may cancel.
            for alternate in [1.0, -1.0] {
                let (mut moved, mut sign) = (*x, 1.0);
                for (x, size) in moved.as_mut_slice().iter_mut().zip(sizes.as_slice()) {
                    *x += A::Real::from_f64(sign * self.relative * size.magnitude());
                    sign *= alternate;
                }
                let there = field(&moved);
                for (i, next) in next.as_mut_slice().iter_mut().enumerate() {
                    let change = (there.as_slice()[i] - here.as_slice()[i]).magnitude();
                    let size = time * change / self.relative;
                    let raised = sizes.as_slice()[i] != x.as_slice()[i];
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
        self.caused.keep(&sizes);
    }

    /// The largest error of a step in units of what is tolerated; `field` as above.
    ///
    /// A coordinate that is zero, and whose rate is, is not measured in its first step: it is driven by others, and only the order
    /// of magnitude of what it becomes is right.
    pub(crate) fn error(&self, step: &Judged<'_, A>, field: impl Fn(&A) -> A) -> f64 {
        let entry = |x: &A, i: usize| x.as_slice()[i].magnitude();
        let moving = (0..A::LEN).all(|i| self.sizes.of(i) > 0.0);
        let rates = if moving { A::zero() } else { field(step.before) };
        largest((0..A::LEN).map(|i| {
            let gap = entry(step.gap, i);
            if gap == 0.0 || (self.sizes.of(i) == 0.0 && entry(&rates, i) == 0.0) {
                return 0.0;
            }
            let size = self.size(i, entry(step.after, i), step.part).max(self.caused.of(i));
            gap / (self.relative * size + entry(&self.absolute, i))
        }))
    }
}
