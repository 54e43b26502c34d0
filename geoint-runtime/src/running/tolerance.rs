//! Which error of a step is tolerated, coordinate by coordinate?

use crate::scalar::{Real, signed};
use crate::solving::size::{Sizes, largest};
use crate::space::Array;

/// The tolerance of a step's error in every coordinate of (q, p): a part of the largest magnitude that the coordinate has had, and
/// an absolute error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance<A: Array> {
    pub(crate) relative: f64,
    absolute: [A; 2],
    sizes: Sizes<[A; 2]>,
}

/// A step as its error is judged.
pub(crate) struct Judged<'a, A: Array> {
    pub(crate) h: f64,
    /// The time in which the state changes.
    pub(crate) time: f64,
    pub(crate) before: &'a [A; 2],
    pub(crate) after: &'a [A; 2],
    /// The estimated error.
    pub(crate) gap: &'a [A; 2],
}

impl<A: Array> Tolerance<A> {
    pub(crate) fn new(relative: f64, x: &[A; 2]) -> Self {
        let mut tolerance = Tolerance { relative, absolute: Array::zero(), sizes: Sizes::new() };
        tolerance.include(x);
        tolerance
    }

    pub(crate) fn absolute(&mut self, absolute: [A; 2]) {
        self.absolute = absolute;
    }

    /// A tolerance that is none.
    pub(crate) fn unusable(&self) -> Option<f64> {
        let positive = self.relative > 0.0 && self.relative < f64::INFINITY;
        let negative = |x: &&A::Real| x.any_below(0.0) || !x.magnitude().is_finite();
        let absolute = Array::as_slice(&self.absolute).iter().find(negative).map(|x| signed(*x));
        if positive { absolute } else { Some(self.relative) }
    }

    /// Includes a state in the sizes.
    pub(crate) fn include(&mut self, x: &[A; 2]) {
        self.sizes.keep(x);
    }

    /// The largest error of a step in units of what is tolerated. `field` gives the rates of a point.
    ///
    /// A coordinate that has been zero so far is measured by what it becomes, and by its rate; one that is zero, and whose rate
    /// is, is not measured in its first step: it is driven by others, and only the order of magnitude of what it becomes is right.
    pub(crate) fn error(&self, step: &Judged<'_, A>, field: impl Fn(&[A; 2]) -> [A; 2]) -> f64 {
        let entry = |x: &[A; 2], i: usize| Array::as_slice(x)[i].magnitude();
        let moving = (0..2 * A::LEN).all(|i| self.sizes.of(i) > 0.0);
        let rates = if moving { Array::zero() } else { field(step.before) };
        let tolerated = |i: usize| {
            let size = match (self.sizes.of(i), step.h.abs() * entry(&rates, i)) {
                (0.0, 0.0) => f64::INFINITY,
                (0.0, change) => change.max(entry(step.after, i)),
                (size, _) => size,
            };
            self.relative * size + entry(&self.absolute, i)
        };
        let error = |tolerated: &dyn Fn(usize) -> f64| {
            largest((0..2 * A::LEN).map(|i| match entry(step.gap, i) {
                0.0 => 0.0,
                gap => gap / tolerated(i),
            }))
        };
        let alone = error(&tolerated);
        if alone <= 1.0 {
            return alone;
        }
        // Each round reaches the next neighbours.
        let (mut coupling, mut together) = (<[A; 2]>::zero(), alone);
        for _ in 0..A::LEN {
            let before = coupling;
            self.couple(&mut coupling, step, &tolerated, &field);
            together = error(&|i| tolerated(i).max(entry(&coupling, i)));
            if together <= 1.0 || coupling == before {
                break;
            }
        }
        together
    }

    /// What the tolerated errors of other degrees of freedom cause in one of them within the time in which the state changes. That is
    /// tolerated there as well: a motion that has not reached it yet, or is nothing but rounding, does not hold up the others.
    #[cold]
    fn couple(
        &self,
        coupling: &mut [A; 2],
        step: &Judged<'_, A>,
        tolerated: &dyn Fn(usize) -> f64,
        field: &impl Fn(&[A; 2]) -> [A; 2],
    ) {
        let (n, before) = (A::LEN, *coupling);
        let here = field(step.before);
        // The error that is tolerated in a degree of freedom that moves, for those that do not.
        let error = |i: usize| Some(tolerated(i)).filter(|error| error.is_finite()).unwrap_or(0.0);
        let most = [0, n].map(|first| largest((first..first + n).map(error)));
        for i in 0..n {
            // With equal and with alternating signs: errors of neighbours may cancel.
            for alternate in [1.0, -1.0] {
                let (mut moved, mut sign) = (*step.before, 1.0);
                for (j, x) in Array::as_mut_slice(&mut moved).iter_mut().enumerate() {
                    // Of its own momentum or position only what others cause there.
                    let caused = Array::as_slice(&before)[j].magnitude();
                    let error = if j % n == i { caused } else { error(j).max(caused) };
                    *x += A::Real::from_f64(sign * error);
                    sign *= alternate;
                }
                let there = field(&moved);
                for (k, most) in [i, i + n].into_iter().zip(most) {
                    let change = (Array::as_slice(&there)[k] - Array::as_slice(&here)[k]).magnitude();
                    let (error, x) = ((step.time * change).min(most), &mut Array::as_mut_slice(coupling)[k]);
                    // What is not a number is no error.
                    if error > x.magnitude() {
                        *x = A::Real::from_f64(error);
                    }
                }
            }
        }
    }
}
