//! The size of a coordinate: its largest recent magnitude. It is the only measure for comparisons of coordinates with different units.
//!
//! An entry is compared with its own size, or with the largest size of its kind ([`Units`]). If the unit of a kind changes by a power of two, comparisons have
//! the same results, unless a number underflows or overflows. Limit: a coordinate that was always zero has size zero, and no change of it is small.

use crate::scalar::Real;
use crate::slope::before_squares;
use crate::space::{Array, Record, Square, Tape};

/// The factor by which a size fades with every point that is included. A size has halved after 44 points, which may be many more steps: Newton's iteration does
/// not include each solution. Slower fading would keep the sizes of a close encounter too long. Faster fading would lose the amplitude of an oscillation.
const FADING: f64 = 1.0 - 1.0 / 64.0;

/// The largest residual, as a part of the unknown, at which a small correction is trusted. It is far above rounding, because it only has to exclude points with
/// a huge derivative.
const SMALL_RESIDUAL: f64 = 1.0 / 16.0;

/// The largest recent magnitude of every entry. An entry is a coordinate, its increment, or a sum of terms. Earlier magnitudes fade.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes<A>(A);

impl<A: Array> Record<A::Real> for Sizes<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.array(&mut self.0);
    }
}

impl<A: Array> Sizes<A> {
    /// Returns sizes that include no point yet: zeros.
    pub(crate) fn new() -> Self {
        Sizes(A::zero())
    }

    /// Includes a point and an increment of it: sᵢ ← max(|originᵢ| + |xᵢ|, 63/64 sᵢ).
    #[inline(always)]
    pub(crate) fn include(&mut self, origin: &A, x: &A) {
        for (i, size) in self.0.as_mut_slice().iter_mut().enumerate() {
            let (now, before) = (sum_of_magnitudes(origin, x, i), FADING * size.magnitude());
            // NaN does not enter a size.
            *size = A::Real::from_f64(if now > before { now } else { before });
        }
    }

    /// Returns these sizes after [`include`](Self::include) of the point `x`.
    pub(crate) fn with(mut self, x: &A) -> Self {
        self.include(x, &A::zero());
        self
    }

    /// Returns the magnitudes of one point as sizes.
    #[inline(always)]
    pub(crate) fn at(x: &A) -> Self {
        let mut sizes = *x;
        for size in sizes.as_mut_slice() {
            *size = A::Real::from_f64(size.magnitude());
        }
        Sizes(sizes)
    }

    /// Returns sizes along a path through these points or increments: the sum of their magnitudes.
    pub(crate) fn along<const N: usize>(path: [&A; N]) -> Self {
        let mut sizes = A::zero();
        for x in path {
            for (size, x) in sizes.as_mut_slice().iter_mut().zip(x.as_slice()) {
                *size += A::Real::from_f64(x.magnitude());
            }
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

    /// Returns sizes with these magnitudes. Precondition: none is negative.
    pub(crate) fn of_magnitudes(sizes: A) -> Self {
        Sizes(sizes)
    }

    /// Returns size 1 for all entries. Precondition: the entries have one unit, or are scaled to numbers near 1.
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

    /// Returns one size for the first half of the unknowns (positions) and one for the second half (momenta), from a matrix that maps unknowns to unknowns.
    ///
    /// An entry of the matrix has the unit of its row over the unit of its column. Let u be the largest entry of the upper right block, and l of the lower left
    /// one. The ratio √u : √l of the sizes then has the unit of positions over momenta. All sizes are 1 if u or l is zero. The roots are rounded.
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

    /// Returns the sizes in order, mutable.
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

    /// Replaces a gradient g by gᵢsᵢ/Σ|gⱼ|sⱼ, with the sizes s. Returns the sum: rounding of the coordinates changes the function by up to about ε times the
    /// sum. A gradient of zero stays zero.
    pub(crate) fn normalise(&self, gradient: &mut A) -> A::Real {
        // The scale is a power of two, and avoids underflow and overflow of most products.
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

    /// Returns Σ|gᵢ|sᵢ for a gradient g and the sizes s: rounding of the coordinates changes the function by up to about ε times this sum.
    #[inline(always)]
    pub(crate) fn terms(&self, gradient: &A) -> f64 {
        self.0
            .as_slice()
            .iter()
            .zip(gradient.as_slice())
            .map(|(size, slope)| size.magnitude() * slope.magnitude())
            .sum()
    }

    /// Returns Σ(xᵢ/sᵢ)² for the sizes s. A zero entry counts as zero. The sum is infinite if another entry has size zero.
    pub(crate) fn square(&self, x: &A) -> f64 {
        let square = |(i, x): (usize, &A::Real)| {
            let ratio = if x.magnitude() == 0.0 { 0.0 } else { x.magnitude() / self.of(i) };
            ratio * ratio
        };
        x.as_slice().iter().enumerate().map(square).sum()
    }

    /// Returns whether every entry of `delta` is at most `bound` times the size of its coordinate. Returns `false` for NaN.
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

    /// Returns whether every entry of a residual is at most 1/16 of its size, or of |origin| + |x|. Solvers then trust a small correction.
    #[inline(always)]
    pub(crate) fn residual_is_small(&self, residual: &A, origin: &A, x: &A) -> bool {
        (0..A::LEN).all(|i| {
            residual.as_slice()[i].magnitude() <= SMALL_RESIDUAL * self.of(i).max(sum_of_magnitudes(origin, x, i))
        })
    }

    /// Returns the largest entry of `delta` relative to its size, or to |origin| + |x| + |delta| if this is larger. The result is therefore at most 1. It is
    /// NaN if `delta` contains NaN or infinity.
    #[inline(always)]
    pub(crate) fn relative(&self, delta: &A, origin: &A, x: &A) -> f64 {
        // All sizes are computed first, by conditional moves. Branches would be mispredicted if sizes and coordinates are nearly equal.
        let mut sizes = A::zero();
        for (i, size) in sizes.as_mut_slice().iter_mut().enumerate() {
            let (before, now) = (self.of(i), sum_of_magnitudes(origin, x, i) + delta.as_slice()[i].magnitude());
            // `f64::max` would take three instructions more, and ignore NaN.
            let largest = if before > now { before } else { now };
            // The sum is zero only if the change is zero. The ratio is then zero.
            *size = A::Real::from_f64(if largest == 0.0 { 1.0 } else { largest });
        }
        let ratio = |(change, size): (&A::Real, &A::Real)| change.magnitude() / size.magnitude();
        largest(delta.as_slice().iter().zip(sizes.as_slice()).map(ratio))
    }
}

/// The units of unknowns. Unknowns of one unit are a *kind*: positions and momenta are two kinds.
///
/// Unknown i has the kind ⌊i/`alike`⌋ mod `kinds`. Two positions and two momenta at each of several stages have `alike` = 2 and `kinds` = 2.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// The number of unknowns of one kind that follow each other. Not zero.
    pub alike: usize,
    /// The number of kinds. Not zero.
    pub kinds: usize,
}

/// Returns the kind of entry `i`, from 0 to `kinds` − 1.
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
pub(crate) fn sum_of_magnitudes<A: Array>(origin: &A, x: &A, i: usize) -> f64 {
    origin.as_slice()[i].magnitude() + x.as_slice()[i].magnitude()
}

/// Returns the largest of numbers that are not negative, 0 if there is none, or NaN if one of them is NaN. `f64::max` would ignore NaN.
#[inline(always)]
pub(crate) fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |largest, x| if x > largest || x.is_nan() { x } else { largest })
}
