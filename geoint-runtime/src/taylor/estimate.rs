//! How long a step may be: from its last two coefficients.

use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Record, Snapshot, Tape};

/// Steps whose last term is so many times smaller than the tolerance, in powers of 2: at the accuracy of the scalar the energy of a Kepler
/// orbit would drift with what is truncated, 1.7·10⁻¹³ in 10⁴ periods, where it walks 2·10⁻¹⁴ by rounding.
const BELOW: f64 = 9.0;

/// By such a part rates at the end of a step of given length may be off: nobody has said how accurate it is to be, but to be a step.
const COARSEST: f64 = 0.5;

/// Beyond this the last terms say nothing of the error: the series may not converge.
const LOOSEST: f64 = 1.0 / 16.0;

/// Log₂ of how many times larger the radius of convergence by the terms of half the order may be than the one by the last terms.
const SHRINKS: f64 = 2.0;

/// A step moves a group far by more than so many times its size.
const FAR: f64 = 2.0;

/// The largest magnitudes that positions, momenta and so on have had, and the tolerance relative to them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate<X: Snapshot> {
    /// Log₂ of what the last term of a step may be.
    tolerance: f64,
    /// By such a part rates at the end of a step may be off.
    part: f64,
    /// Of every group, at its first coordinate.
    sizes: PerCoordinate<X::Phase, X::Action>,
}

impl<X: Snapshot> Record<X::Real> for Estimate<X> {
    fn record(&mut self, tape: &mut impl Tape<X::Real>) {
        self.sizes.record(tape);
    }
}

impl<X: Snapshot> Estimate<X> {
    /// Groups of coordinates of one unit, the action last.
    const GROUPS: usize = X::Phase::LEN / X::ALIKE + X::Action::LEN;

    pub(crate) fn new(tolerance: f64) -> Self {
        let tolerance = Real::log2(tolerance.max(X::Real::epsilon()).min(LOOSEST));
        Estimate { tolerance: tolerance - BELOW, part: exp2(0.5 * tolerance) / 8.0, sizes: PerCoordinate::zero() }
    }

    /// For steps of given length.
    pub(crate) fn of_any_accuracy() -> Self {
        Estimate { part: COARSEST, ..Self::new(0.0) }
    }

    /// One of the groups.
    #[inline(always)]
    fn group(x: &PerCoordinate<X::Phase, X::Action>, i: usize) -> &[X::Real] {
        let first = i * X::ALIKE;
        if first < X::Phase::LEN { &x.z.as_slice()[first..first + X::ALIKE] } else { x.s.numbers() }
    }

    /// The largest magnitude in a group.
    #[inline(always)]
    fn magnitude(x: &PerCoordinate<X::Phase, X::Action>, i: usize) -> f64 {
        Self::group(x, i).iter().fold(0.0, |largest, x| larger(x.magnitude(), largest))
    }

    #[inline(always)]
    fn size(&self, i: usize) -> f64 {
        Self::group(&self.sizes, i)[0].magnitude()
    }

    /// Includes a point from which a run goes on. By one that is infinite nothing could be measured.
    pub(crate) fn start(&mut self, x: &PerCoordinate<X::Phase, X::Action>) {
        if x.is_finite() {
            self.include(x);
        }
    }

    /// Includes a point.
    #[inline(always)]
    pub(crate) fn include(&mut self, x: &PerCoordinate<X::Phase, X::Action>) {
        for i in 0..Self::GROUPS {
            let size = X::Real::from_f64(larger(Self::magnitude(x, i), self.size(i)));
            let first = i * X::ALIKE;
            if first < X::Phase::LEN {
                self.sizes.z.as_mut_slice()[first] = size;
            } else {
                self.sizes.s.numbers_mut()[0] = size;
            }
        }
    }

    /// The longest step at which the last term is within the tolerance, in every group; infinite for a polynomial of less than half the order.
    ///
    /// It is a part of the radius of convergence, the smaller one by the last two terms: every other one is zero where a solution is even or odd.
    /// The first one is none of them, which says nothing of an error. Where both are zero, the last term that is not decides. A group that is
    /// zero so far is measured by its first term that is not.
    #[inline(always)]
    pub(crate) fn length(&self, jet: &[PerCoordinate<X::Phase, X::Action>]) -> f64 {
        let order = jet.len();
        let before = if order > 2 { self.radius(jet, order - 1) } else { f64::INFINITY };
        let (mut least, mut m) = (smaller(self.radius(jet, order), before), order);
        if least == f64::INFINITY {
            m -= 1;
        }
        while least == f64::INFINITY && m > order / 2 {
            m -= 1;
            least = self.radius(jet, m);
        }
        exp2(self.tolerance * (1.0 / m as f64) + least)
    }

    /// Whether the terms of half the order and those of the last orders tell of one radius of convergence. Beyond a force that is constant to rounding
    /// the last terms are small, but larger than those before them let expect: their radius is that of something that the series does not show.
    #[inline(always)]
    pub(crate) fn converges(&self, jet: &[PerCoordinate<X::Phase, X::Action>]) -> bool {
        let radius = |order: usize| smaller(self.radius(jet, order), self.radius(jet, order - 1));
        let (order, last) = (jet.len(), radius(jet.len()));
        last < f64::INFINITY && radius(order / 2 + 1) <= last + SHRINKS
    }

    /// Whether these rates move a group by much more than its size in a step of length `h`.
    #[inline(always)]
    pub(crate) fn moves_far(&self, h: f64, rates: &PerCoordinate<X::Phase, X::Action>) -> bool {
        (0..Self::GROUPS).any(|i| h.abs() * Self::magnitude(rates, i) > FAR * self.size(i))
    }

    /// Log₂ of the radius of convergence by the term of order m: of the time in which that is as large as its group.
    #[inline(always)]
    fn radius(&self, jet: &[PerCoordinate<X::Phase, X::Action>], m: usize) -> f64 {
        let (mut excess, smallest) = (i64::MIN, X::Real::smallest());
        for i in 0..Self::GROUPS {
            let (size, term) = (self.size(i), Self::magnitude(&jet[m - 1], i));
            if term < smallest || size < smallest {
                return self.radius_by_group(jet, m);
            }
            excess = excess.max(difference(term, size));
        }
        -log2(excess) * (1.0 / m as f64)
    }

    /// The same where a group is zero so far, or its term is.
    #[cold]
    fn radius_by_group(&self, jet: &[PerCoordinate<X::Phase, X::Action>], m: usize) -> f64 {
        // What is below the normal numbers has no digits to tell anything by.
        let smallest = X::Real::smallest();
        let radius = |i: usize| {
            let term = Self::magnitude(&jet[m - 1], i);
            let mut terms = jet[..m].iter().map(|x| Self::magnitude(x, i)).zip(1..);
            let (size, k) = match self.size(i) {
                size if size >= smallest => (size, 0),
                _ => terms.find(|(term, _)| *term >= smallest)?,
            };
            let known = term >= smallest && k < m;
            known.then(|| -log2(difference(term, size)) / (m - k) as f64)
        };
        (0..Self::GROUPS).filter_map(radius).fold(f64::INFINITY, smaller)
    }

    /// In how long, roughly, the state changes, in the unit of its coefficients: until a term is as large as its group, or of a group that is
    /// zero so far, as its first term. Terms that have overflown, or are below the normal numbers, are not asked. Infinite if none tells.
    pub(crate) fn time(&self, jet: &[PerCoordinate<X::Phase, X::Action>]) -> f64 {
        (0..Self::GROUPS).map(|i| Self::time_of_group(&self.sizes, jet, i)).fold(f64::INFINITY, f64::min)
    }

    /// The same of a state, whatever has been before it. Next to zero, where an event may be, a group tells by its rates.
    pub(crate) fn time_of(
        state: &PerCoordinate<X::Phase, X::Action>,
        jet: &[PerCoordinate<X::Phase, X::Action>],
    ) -> f64 {
        let of_group = |i: usize| {
            let [time, by_rates] = [state, &PerCoordinate::zero()].map(|x| Self::time_of_group(x, jet, i));
            if by_rates < f64::INFINITY { f64::max(time, by_rates) } else { time }
        };
        (0..Self::GROUPS).map(of_group).fold(f64::INFINITY, f64::min)
    }

    fn time_of_group(
        state: &PerCoordinate<X::Phase, X::Action>,
        jet: &[PerCoordinate<X::Phase, X::Action>],
        i: usize,
    ) -> f64 {
        let normal = |x: f64| x >= X::Real::smallest() && x < f64::INFINITY;
        let mut terms = (1..).zip(jet.iter().map(|x| Self::magnitude(x, i))).filter(|(_, term)| normal(*term));
        let first = Some((0, Self::magnitude(state, i))).filter(|(_, size)| normal(*size)).or_else(|| terms.next());
        let time = |(k, term): (usize, f64)| {
            first.map(|(j, size)| Real::exp2((Real::log2(size) - Real::log2(term)) / (k - j) as f64))
        };
        terms.filter_map(time).fold(f64::INFINITY, f64::min)
    }

    /// What part of a radius of convergence a step of this order has.
    pub(crate) fn part_of_radius(&self, order: usize) -> f64 {
        exp2(self.tolerance / order as f64)
    }

    /// Whether two rates are the same at the end of a step, but for much more than the tolerance and rounding: of coordinates, and of the
    /// time of the end, which changes rates by `late`.
    #[inline(always)]
    pub(crate) fn agree(
        &self,
        h: f64,
        rates: [&PerCoordinate<X::Phase, X::Action>; 2],
        before: &PerCoordinate<X::Phase, X::Action>,
        late: &PerCoordinate<X::Phase, X::Action>,
    ) -> bool {
        let (rounding, smallest) = (64.0 * X::Real::epsilon(), X::Real::smallest());
        let mut gap = *rates[0];
        gap.add_scaled(X::Real::from_f64(-1.0), rates[1]);
        let mut good = true;
        for i in 0..Self::GROUPS {
            let scale = larger(Self::magnitude(rates[1], i), Self::magnitude(before, i));
            let most = h.abs() * (self.part * scale + Self::magnitude(late, i)) + rounding * self.size(i) + smallest;
            // Coordinate by coordinate: the largest of a group would be sought in another order than that of the sums before.
            for gap in Self::group(&gap, i) {
                good &= h.abs() * gap.magnitude() <= most;
            }
        }
        good
    }
}

/// The larger of two numbers; the second where one is none. An operation of processors, other than [`f64::max`].
#[inline(always)]
fn larger(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}

/// The smaller of two numbers; the second where one is none.
#[inline(always)]
fn smaller(x: f64, y: f64) -> f64 {
    if x < y { x } else { y }
}

/// How far two positive normal numbers are apart: exponents and fractions as their bits have them.
#[inline(always)]
fn difference(x: f64, y: f64) -> i64 {
    x.to_bits() as i64 - y.to_bits() as i64
}

/// Log₂ x/y from the difference of x and y, off by at most 0.0861.
#[inline(always)]
fn log2(difference: i64) -> f64 {
    difference as f64 * (1.0 / (1_u64 << 52) as f64)
}

/// 2ʸ, off by at most 0.32 %.
#[inline(always)]
fn exp2(y: f64) -> f64 {
    if !(y > -1000.0 && y < 1000.0) {
        return if y > 0.0 { f64::INFINITY } else { 0.0 };
    }
    // The last digit of such a number is one: the sum is rounded to a whole number, which its last bits are.
    const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;
    let shifted = (y - 0.5) + WHOLE;
    let fraction = y - (shifted - WHOLE);
    f64::from_bits((shifted.to_bits() + 1023) << 52) * (1.0 + fraction * (0.6565 + 0.3435 * fraction))
}
