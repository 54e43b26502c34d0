//! Defines the size of a coordinate, the only measure for comparisons of coordinates with different units.

use crate::scalar::Real;
use crate::slope::before_squares;
use crate::space::{Array, Record, Square, Tape};

/// The factor by which a size fades with every point that is included. A size has halved after some fifty points.
const FADING: f64 = 1.0 - 1.0 / 64.0;

/// The largest residual, as a part of the unknown, with which the equation determines the unknown. Above this limit, a small correction proves
/// nothing.
const RESOLVED: f64 = 1.0 / 16.0;

/// The largest recent magnitude of every entry. An entry is a coordinate, its increment, or the terms that add up to it. Earlier magnitudes fade.
///
/// An entry is compared with its own size only. A change of its unit by a power of two therefore changes no result by a single bit. An entry that has
/// not moved yet has size zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes<A>(A);

impl<A: Array> Record<A::Real> for Sizes<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.array(&mut self.0);
    }
}

impl<A: Array> Sizes<A> {
    /// Returns sizes that include no point yet.
    pub(crate) fn new() -> Self {
        Sizes(A::zero())
    }

    /// Includes a point and an increment of it.
    #[inline(always)]
    pub(crate) fn include(&mut self, origin: &A, x: &A) {
        for (i, size) in self.0.as_mut_slice().iter_mut().enumerate() {
            let (now, before) = (sum(origin, x, i), FADING * size.magnitude());
            // NaN does not enter a size.
            *size = A::Real::from_f64(if now > before { now } else { before });
        }
    }

    /// Returns sizes that also include the point `x`.
    pub(crate) fn with(mut self, x: &A) -> Self {
        self.include(x, &A::zero());
        self
    }

    /// Returns the sizes of one point.
    #[inline(always)]
    pub(crate) fn at(x: &A) -> Self {
        let mut sizes = *x;
        for size in sizes.as_mut_slice() {
            *size = A::Real::from_f64(size.magnitude());
        }
        Sizes(sizes)
    }

    /// Returns the point next to `x` at which every entry is larger by the fraction `part` of its size.
    pub(crate) fn beside(&self, x: &A, part: f64) -> A {
        let mut beside = *x;
        for (i, x) in beside.as_mut_slice().iter_mut().enumerate() {
            *x += A::Real::from_f64(part * self.of(i));
        }
        beside
    }

    /// Returns sizes with these magnitudes.
    pub(crate) fn of_magnitudes(sizes: A) -> Self {
        Sizes(sizes)
    }

    /// Returns size 1 for all entries, which have one unit.
    pub(crate) fn equal() -> Self {
        let mut sizes = A::zero();
        sizes.as_mut_slice().fill(A::Real::from_f64(1.0));
        Sizes(sizes)
    }

    /// Returns for each entry the largest size of its kind.
    pub(crate) fn of_kinds(&self, units: Units) -> Self {
        let mut largest = A::zero();
        for (i, size) in largest.as_mut_slice().iter_mut().enumerate() {
            *size = A::Real::from_f64(largest_of_kind(self.as_slice(), units, i));
        }
        Sizes(largest)
    }

    /// Returns units for the positions and for the momenta, the two halves of the unknowns. They follow from a matrix that maps unknowns to unknowns.
    /// An entry of the matrix has the unit of its row over the unit of its column.
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

    /// Returns the sizes in order, to be changed.
    #[inline(always)]
    pub(crate) fn entries(&mut self) -> &mut [A::Real] {
        self.0.as_mut_slice()
    }

    /// Returns the sizes in order.
    #[inline(always)]
    pub(crate) fn as_slice(&self) -> &[A::Real] {
        self.0.as_slice()
    }

    /// Returns the size of entry `i`.
    #[inline(always)]
    pub(crate) fn of(&self, i: usize) -> f64 {
        self.0.as_slice()[i].magnitude()
    }

    /// Multiplies every entry by its size.
    pub(crate) fn multiply(&self, x: &mut A) {
        for (x, size) in x.as_mut_slice().iter_mut().zip(self.0.as_slice()) {
            *x *= *size;
        }
    }

    /// Converts a gradient to units of the sizes and divides it by the sum of its magnitudes. Returns the sum: rounding of the coordinates changes
    /// the function by ε times the sum. A gradient of zero stays unchanged.
    pub(crate) fn normalise(&self, gradient: &mut A) -> A::Real {
        // The scale keeps products with small sizes from vanishing.
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

    /// Returns the sum of the magnitudes of a gradient in units of the sizes: rounding of the coordinates changes the function by ε times the
    /// sum.
    #[inline(always)]
    pub(crate) fn terms(&self, gradient: &A) -> f64 {
        self.0
            .as_slice()
            .iter()
            .zip(gradient.as_slice())
            .map(|(size, slope)| size.magnitude() * slope.magnitude())
            .sum()
    }

    /// Returns the sum of the squares of all entries in units of their sizes.
    pub(crate) fn square(&self, x: &A) -> f64 {
        let square = |(i, x): (usize, &A::Real)| {
            let ratio = if x.magnitude() == 0.0 { 0.0 } else { x.magnitude() / self.of(i) };
            ratio * ratio
        };
        x.as_slice().iter().enumerate().map(square).sum()
    }

    /// Returns whether every entry of `delta` is at most `bound` times the size of its coordinate.
    #[inline(always)]
    pub(crate) fn all_within(&self, delta: &A, bound: f64) -> bool {
        // Squares are avoided, because they overflow or vanish in large or tiny units.
        let mut within = true;
        for i in 0..A::LEN {
            let (change, size) = (delta.as_slice()[i].magnitude(), self.of(i));
            within &= change <= bound * size;
        }
        within
    }

    /// Returns whether every entry of a residual is small beside the entry of `origin + x`.
    #[inline(always)]
    pub(crate) fn resolve(&self, residual: &A, origin: &A, x: &A) -> bool {
        (0..A::LEN).all(|i| residual.as_slice()[i].magnitude() <= RESOLVED * self.of(i).max(sum(origin, x, i)))
    }

    /// Returns the largest entry of `delta` relative to the size of the entry of `origin + x` that it corrects. The result is at most 1 if an entry
    /// has no size but the correction. It is NaN if `delta` contains NaN.
    #[inline(always)]
    pub(crate) fn relative(&self, delta: &A, origin: &A, x: &A) -> f64 {
        // Sizes come first, by conditional moves, because a processor mispredicts branches if sizes and coordinates are nearly equal.
        let mut sizes = A::zero();
        for (i, size) in sizes.as_mut_slice().iter_mut().enumerate() {
            let (before, now) = (self.of(i), sum(origin, x, i) + delta.as_slice()[i].magnitude());
            // `f64::max` would take three instructions more, and drop NaN.
            let largest = if before > now { before } else { now };
            // A size of zero implies a change of zero. The ratio is then zero.
            *size = A::Real::from_f64(if largest == 0.0 { 1.0 } else { largest });
        }
        let ratio = |(change, size): (&A::Real, &A::Real)| change.magnitude() / size.magnitude();
        largest(delta.as_slice().iter().zip(sizes.as_slice()).map(ratio))
    }
}

/// The number of unknowns that follow each other and have one unit, and the number of such kinds: positions and momenta are two kinds.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// Unknowns of one kind.
    pub alike: usize,
    /// Kinds of unknowns.
    pub kinds: usize,
}

/// Returns the kind of entry `i`.
pub(crate) fn kind(Units { alike, kinds }: Units, i: usize) -> usize {
    i / alike % kinds
}

/// Returns the largest size of the kind of entry `i`.
pub(crate) fn largest_of_kind<R: Real>(sizes: &[R], units: Units, i: usize) -> f64 {
    let alike = sizes.iter().enumerate().filter(|(j, _)| kind(units, *j) == kind(units, i));
    alike.map(|(_, size)| size.magnitude()).fold(0.0, f64::max)
}

/// Returns |origin| + |x| of entry `i`.
#[inline(always)]
pub(crate) fn sum<A: Array>(origin: &A, x: &A, i: usize) -> f64 {
    origin.as_slice()[i].magnitude() + x.as_slice()[i].magnitude()
}

/// Returns the largest number, or NaN if there is one. `f64::max` would drop NaN.
#[inline(always)]
pub(crate) fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |largest, x| if x > largest || x.is_nan() { x } else { largest })
}
