//! Estimates from the coefficients of a series: step length, convergence, time in which the state changes, and agreement of rates.

use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Record, Snapshot, Tape};

/// Log₂ of the safety factor between the tolerance and the last term of a step. Without it, at tolerance ε, truncation lets the energy of a Kepler
/// orbit drift by 1.7·10⁻¹³ in 10⁴ periods. Rounding alone gives a random walk of 2·10⁻¹⁴.
const LOG_SAFETY: f64 = 9.0;

/// Tolerated relative deviation of the rates at the end of a step of given length. No accuracy is specified there, so only gross errors are refused.
const COARSEST_RATES: f64 = 0.5;

/// Largest tolerance that is used. Beyond it, the last terms do not measure the error, because the series may not converge.
const LARGEST_TOLERANCE: f64 = 1.0 / 16.0;

/// Log₂ of the largest accepted ratio of two estimates of the radius of convergence: by the terms of half the order, and by the last terms.
const LOG_RADIUS_RATIO: f64 = 2.0;

/// A group moves far if a step changes it by more than this many times its size.
const FAR: f64 = 2.0;

/// Largest magnitudes so far of positions, momenta and other groups of coordinates, and the tolerance relative to them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate<X: Snapshot> {
    /// Log₂ of the largest last term of a step, relative to the size of its group.
    tolerance: f64,
    /// Tolerated relative deviation of rates: √τ/8 with the tolerance τ of the user, without the safety factor, or `COARSEST_RATES`.
    part: f64,
    /// Size of each group, stored at its first coordinate.
    sizes: PerCoordinate<X::Phase, X::Action>,
}

impl<X: Snapshot> Record<X::Real> for Estimate<X> {
    fn record(&mut self, tape: &mut impl Tape<X::Real>) {
        self.sizes.record(tape);
    }
}

impl<X: Snapshot> Estimate<X> {
    /// Number of groups of coordinates of one unit. The action is the last group.
    const GROUPS: usize = X::Phase::LEN / X::ALIKE + X::Action::LEN;

    pub(crate) fn new(tolerance: f64) -> Self {
        let tolerance = Real::log2(tolerance.max(X::Real::epsilon()).min(LARGEST_TOLERANCE));
        Estimate { tolerance: tolerance - LOG_SAFETY, part: exp2(0.5 * tolerance) / 8.0, sizes: PerCoordinate::zero() }
    }

    /// Returns an estimate for steps of given length.
    pub(crate) fn of_any_accuracy() -> Self {
        Estimate { part: COARSEST_RATES, ..Self::new(0.0) }
    }

    /// Returns the coordinates of group `i`.
    #[inline(always)]
    fn group(x: &PerCoordinate<X::Phase, X::Action>, i: usize) -> &[X::Real] {
        let first = i * X::ALIKE;
        if first < X::Phase::LEN { &x.z.as_slice()[first..first + X::ALIKE] } else { x.s.numbers() }
    }

    /// Returns the largest magnitude in group `i`.
    #[inline(always)]
    fn magnitude(x: &PerCoordinate<X::Phase, X::Action>, i: usize) -> f64 {
        Self::group(x, i).iter().fold(0.0, |largest, x| larger(x.magnitude(), largest))
    }

    #[inline(always)]
    fn size(&self, i: usize) -> f64 {
        Self::group(&self.sizes, i)[0].magnitude()
    }

    /// Includes a point from which a run continues. A point that is not finite is ignored, because no error could be measured by it.
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

    /// Returns the longest step at which the last term is within the tolerance, in every group. Infinite if all terms from half the order on
    /// are zero.
    ///
    /// The step is a fraction of the radius of convergence R. For R, the smaller estimate by the last two terms is used, because every other term of
    /// an even or odd solution is zero. The term of order 1 is not used as the last but one, because it does not measure the error. If both terms are
    /// zero, the last non-zero term decides. A group that is zero so far is measured by its first non-zero term.
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

    /// Returns `false` if the last two terms are zero. Otherwise returns whether the terms of half the order and those of the last orders give one radius of convergence. They do not if the force is constant
    /// up to rounding: the last terms are then small, but larger than the earlier terms suggest. They belong to a distant feature that the series
    /// does not resolve.
    #[inline(always)]
    pub(crate) fn converges(&self, jet: &[PerCoordinate<X::Phase, X::Action>]) -> bool {
        let radius = |order: usize| smaller(self.radius(jet, order), self.radius(jet, order - 1));
        let (order, last) = (jet.len(), radius(jet.len()));
        last < f64::INFINITY && radius(order / 2 + 1) <= last + LOG_RADIUS_RATIO
    }

    /// Returns whether these rates move a group by more than `FAR` times its size in a step of length `h`.
    #[inline(always)]
    pub(crate) fn moves_far(&self, h: f64, rates: &PerCoordinate<X::Phase, X::Action>) -> bool {
        (0..Self::GROUPS).any(|i| h.abs() * Self::magnitude(rates, i) > FAR * self.size(i))
    }

    /// Returns log₂ of the radius of convergence by the term of order m: the time in which this term is as large as its group.
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

    /// Computes `radius` if the size or the term of a group is zero or below the normal numbers.
    #[cold]
    fn radius_by_group(&self, jet: &[PerCoordinate<X::Phase, X::Action>], m: usize) -> f64 {
        // Numbers below the normal ones have too few digits for an estimate.
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

    /// Estimates the time in which the state changes, in the unit of the coefficients: the time until a term is as large as its group. A group that
    /// is zero so far is measured by its first term. Terms that have overflowed, or are below the normal numbers, are ignored. Infinite if no term is
    /// left.
    pub(crate) fn time(&self, jet: &[PerCoordinate<X::Phase, X::Action>]) -> f64 {
        (0..Self::GROUPS).map(|i| Self::time_of_group(&self.sizes, jet, i)).fold(f64::INFINITY, f64::min)
    }

    /// Computes `time` for a state, without the sizes of earlier states. For a group near zero, for example at an event, the first term is the
    /// measure instead.
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

    /// Returns the step length as a fraction of the radius of convergence, for this order.
    pub(crate) fn part_of_radius(&self, order: usize) -> f64 {
        exp2(self.tolerance / order as f64)
    }

    /// Returns whether two rates at one time agree: h·|difference| ≤ h·(part·scale + late) + 64 ε·size in every group. The scale is the larger one of the second
    /// rate and of the rate `before`, at the start of the step. `late` is the change of the rates by the rounding of time.
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
            for gap in Self::group(&gap, i) {
                good &= h.abs() * gap.magnitude() <= most;
            }
        }
        good
    }
}

/// Returns the larger of two numbers; the second one if one is not a number. One instruction, unlike [`f64::max`].
#[inline(always)]
fn larger(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}

/// Returns the smaller of two numbers; the second one if one is not a number.
#[inline(always)]
fn smaller(x: f64, y: f64) -> f64 {
    if x < y { x } else { y }
}

/// Returns the difference of two positive normal numbers as integers with the same bits: a measure of log₂ (x/y).
#[inline(always)]
fn difference(x: f64, y: f64) -> i64 {
    x.to_bits() as i64 - y.to_bits() as i64
}

/// Returns log₂ (x/y) from `difference(x, y)`, with an error of at most 0.0861.
#[inline(always)]
fn log2(difference: i64) -> f64 {
    difference as f64 * (1.0 / (1_u64 << 52) as f64)
}

/// Returns 2ʸ with a relative error of at most 0.32 %.
#[inline(always)]
fn exp2(y: f64) -> f64 {
    if !(y > -1000.0 && y < 1000.0) {
        return if y > 0.0 { f64::INFINITY } else { 0.0 };
    }
    // Numbers of this magnitude have a spacing of 1. The sum is rounded to an integer, which its last bits contain.
    const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;
    let shifted = (y - 0.5) + WHOLE;
    let fraction = y - (shifted - WHOLE);
    f64::from_bits((shifted.to_bits() + 1023) << 52) * (1.0 + fraction * (0.6565 + 0.3435 * fraction))
}
