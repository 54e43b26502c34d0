//! How large is a coordinate? The one measure for everything that compares coordinates of different units.

use crate::scalar::Real;
use crate::slope::before_squares;
use crate::space::{Array, Record, Square, Tape};

/// What is left of a size after every point that is included: half after some fifty.
const FADING: f64 = 1.0 - 1.0 / 64.0;

/// Where a residual is larger than this part of the unknown the equation says nothing of it, however small the correction is.
const RESOLVED: f64 = 1.0 / 16.0;

/// The largest magnitude of every entry that was met lately: of a coordinate, its increment, or the terms that are added up on the
/// way to it. What was met long ago fades.
///
/// Entries are compared with their own sizes only, so that a change of the units of any of them by a power of two changes no
/// result by a single bit. A size of zero belongs to an entry that has not moved yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes<A>(A);

impl<A: Array> Record<A::Real> for Sizes<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.array(&mut self.0);
    }
}

impl<A: Array> Sizes<A> {
    /// Nothing was met yet.
    pub(crate) fn new() -> Self {
        Sizes(A::zero())
    }

    /// Includes a point and an increment of it.
    #[inline(always)]
    pub(crate) fn include(&mut self, origin: &A, x: &A) {
        for (i, size) in self.0.as_mut_slice().iter_mut().enumerate() {
            let (now, before) = (sum(origin, x, i), FADING * size.magnitude());
            // What is not a number is no size.
            *size = A::Real::from_f64(if now > before { now } else { before });
        }
    }

    /// Of a point alone.
    #[inline(always)]
    pub(crate) fn at(x: &A) -> Self {
        let mut sizes = *x;
        for size in sizes.as_mut_slice() {
            *size = A::Real::from_f64(size.magnitude());
        }
        Sizes(sizes)
    }

    /// Of these magnitudes.
    pub(crate) fn of_magnitudes(sizes: A) -> Self {
        Sizes(sizes)
    }

    /// The same size for all: entries of one unit.
    pub(crate) fn equal() -> Self {
        let mut sizes = A::zero();
        sizes.as_mut_slice().fill(A::Real::from_f64(1.0));
        Sizes(sizes)
    }

    /// Units for the first and the second half of the unknowns, positions and momenta, from a matrix that takes unknowns to unknowns:
    /// an entry has the unit of its row over that of its column.
    pub(crate) fn of_blocks(matrix: &Square<A>) -> Self {
        let half = A::LEN / 2;
        let block = |rows: core::ops::Range<usize>, columns: core::ops::Range<usize>| {
            let rows = A::entries_of::<A>(matrix)[rows].iter();
            largest(rows.flat_map(|row| &row.as_slice()[columns.clone()]).map(|x| x.magnitude()))
        };
        let (upper, lower) = (block(0..half, half..A::LEN), block(half..A::LEN, 0..half));
        let mut sizes = Self::equal();
        if upper > 0.0 && lower > 0.0 {
            let (first, second) = sizes.0.as_mut_slice().split_at_mut(half);
            first.fill(A::Real::from_f64(Real::sqrt(upper)));
            second.fill(A::Real::from_f64(Real::sqrt(lower)));
        }
        sizes
    }

    /// The sizes in order.
    #[inline(always)]
    pub(crate) fn entries(&mut self) -> &mut [A::Real] {
        self.0.as_mut_slice()
    }

    /// The same, to be read.
    #[inline(always)]
    pub(crate) fn as_slice(&self) -> &[A::Real] {
        self.0.as_slice()
    }

    /// The size of entry `i`.
    #[inline(always)]
    pub(crate) fn of(&self, i: usize) -> f64 {
        self.0.as_slice()[i].magnitude()
    }

    /// Every entry times its size.
    pub(crate) fn multiply(&self, x: &mut A) {
        for (x, size) in x.as_mut_slice().iter_mut().zip(self.0.as_slice()) {
            *x *= *size;
        }
    }

    /// Takes a gradient to units of the sizes, and divides it by the sum of its magnitudes then, which is returned: by so much, times
    /// ε, rounding of the coordinates changes the function. A gradient of zero stays.
    pub(crate) fn normalise(&self, gradient: &mut A) -> A::Real {
        // So that products with small sizes do not vanish.
        let scale = before_squares(A::Real::from_f64(gradient.as_slice().iter().map(|x| x.magnitude()).sum()));
        for x in gradient.as_mut_slice() {
            *x *= scale;
        }
        self.multiply(gradient);
        let terms = A::Real::from_f64(gradient.as_slice().iter().map(|x| x.magnitude()).sum());
        if terms.magnitude() > 0.0 {
            for x in gradient.as_mut_slice() {
                *x /= terms;
            }
        }
        terms / scale
    }

    /// The sum of the squares of all entries in units of their sizes.
    pub(crate) fn square(&self, x: &A) -> f64 {
        let square = |(i, x): (usize, &A::Real)| {
            let ratio = if x.magnitude() == 0.0 { 0.0 } else { x.magnitude() / self.of(i) };
            ratio * ratio
        };
        x.as_slice().iter().enumerate().map(square).sum()
    }

    /// Whether every entry of `delta` is at most `bound` of its size. No squares: those of coordinates in large or tiny units are no numbers, or zero.
    #[inline(always)]
    pub(crate) fn exceed(&self, delta: &A, bound: f64) -> bool {
        let mut exceed = true;
        for i in 0..A::LEN {
            let (change, size) = (delta.as_slice()[i].magnitude(), self.of(i));
            exceed &= change <= bound * size;
        }
        exceed
    }

    /// Whether every entry of a residual is small beside the entry of `origin + x`.
    #[inline(always)]
    pub(crate) fn resolve(&self, residual: &A, origin: &A, x: &A) -> bool {
        (0..A::LEN).all(|i| residual.as_slice()[i].magnitude() <= RESOLVED * self.of(i).max(sum(origin, x, i)))
    }

    /// The largest entry of `delta`, each relative to the size of the entry of `origin + x` that it corrects. At most 1 where an
    /// entry has no size but the correction; not a number if `delta` is none.
    #[inline(always)]
    pub(crate) fn relative(&self, delta: &A, origin: &A, x: &A) -> f64 {
        // Sizes first, by choices between numbers: a choice between ways to go on would be guessed wrongly wherever sizes and coordinates are nearly
        // as large as each other.
        let mut sizes = A::zero();
        for (i, size) in sizes.as_mut_slice().iter_mut().enumerate() {
            let (before, now) = (self.of(i), sum(origin, x, i) + delta.as_slice()[i].magnitude());
            // `f64::max` would take three instructions more, and lose what is not a number.
            let largest = if before > now { before } else { now };
            // Nothing to correct is no correction, even of zero: a size of zero is that of a change of zero.
            *size = A::Real::from_f64(if largest == 0.0 { 1.0 } else { largest });
        }
        let ratio = |(change, size): (&A::Real, &A::Real)| change.magnitude() / size.magnitude();
        largest(delta.as_slice().iter().zip(sizes.as_slice()).map(ratio))
    }
}

/// |origin| + |x| of entry `i`.
#[inline(always)]
pub(crate) fn sum<A: Array>(origin: &A, x: &A, i: usize) -> f64 {
    origin.as_slice()[i].magnitude() + x.as_slice()[i].magnitude()
}

/// The largest number, and what is not a number if there is one: `f64::max` would lose that.
#[inline(always)]
pub(crate) fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |largest, x| if x > largest || x.is_nan() { x } else { largest })
}
