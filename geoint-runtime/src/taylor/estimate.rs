//! How long a step may be: from its last two coefficients.

use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Record, Tape};

/// Steps for an error so many times smaller than the tolerance, in powers of 2: at the accuracy of the scalar the energy of a Kepler
/// orbit would drift with what is truncated, 1.7·10⁻¹³ in 10⁴ periods, where it walks 2·10⁻¹⁴ by rounding.
const BELOW: f64 = 6.0;

/// Beyond this the last terms say nothing of the error: the series may not converge.
const LOOSEST: f64 = 1.0 / 16.0;

/// The largest magnitudes that positions, momenta and so on have had, and the tolerance relative to them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate<Z, S> {
    /// Log₂ of what the last term of a step may be.
    tolerance: f64,
    /// Coordinates come in groups of so many that have one unit.
    alike: usize,
    /// Of every group, at its first coordinate.
    sizes: PerCoordinate<Z, S>,
}

impl<Z: Array, S: Action<Z::Real>> Record<Z::Real> for Estimate<Z, S> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        self.sizes.record(tape);
    }
}

impl<Z: Array, S: Action<Z::Real>> Estimate<Z, S> {
    pub(crate) fn new(tolerance: f64, alike: usize) -> Self {
        let tolerance = tolerance.max(Z::Real::epsilon()).min(LOOSEST);
        Estimate { tolerance: Real::log2(tolerance) - BELOW, alike, sizes: PerCoordinate::zero() }
    }

    /// The largest magnitude in every group, the action last.
    #[inline(always)]
    fn magnitudes<'a>(alike: usize, x: &'a PerCoordinate<Z, S>) -> impl Iterator<Item = f64> + 'a {
        let largest = |group: &[Z::Real]| group.iter().fold(0.0, |largest: f64, x| largest.max(x.magnitude()));
        x.z.as_slice().chunks_exact(alike).chain(x.s.numbers().chunks(1)).map(largest)
    }

    /// The sizes, in the same order.
    #[inline(always)]
    fn sizes(&self) -> impl Iterator<Item = f64> + '_ {
        let first = |group: &[Z::Real]| group[0].magnitude();
        self.sizes.z.as_slice().chunks_exact(self.alike).chain(self.sizes.s.numbers().chunks(1)).map(first)
    }

    /// Includes a point.
    #[inline(always)]
    pub(crate) fn include(&mut self, x: &PerCoordinate<Z, S>) {
        let Estimate { alike, sizes, .. } = self;
        let groups = sizes.z.as_mut_slice().chunks_exact_mut(*alike).chain(sizes.s.numbers_mut().chunks_mut(1));
        for (size, now) in groups.zip(Self::magnitudes(*alike, x)) {
            if now > size[0].magnitude() {
                size[0] = Z::Real::from_f64(now);
            }
        }
    }

    /// The longest step at which the last two terms are within the tolerance, in every group; infinite for a polynomial of less than
    /// half the order.
    ///
    /// Two terms, because every other one is zero where a solution is even or odd. Where both are, the last one that is not decides. A
    /// group that is zero so far is measured by its first term that is not.
    #[inline(always)]
    pub(crate) fn length(&self, jet: &[PerCoordinate<Z, S>]) -> f64 {
        let order = jet.len();
        let mut least = self.bound(jet, order).min(self.bound(jet, order - 1));
        let mut m = order - 1;
        while least == f64::INFINITY && m > order / 2 {
            m -= 1;
            least = self.bound(jet, m);
        }
        exp2(least)
    }

    /// Log₂ of the longest step at which the term of order m is within the tolerance.
    #[inline(always)]
    fn bound(&self, jet: &[PerCoordinate<Z, S>], m: usize) -> f64 {
        let mut least = f64::INFINITY;
        for (group, (size, term)) in self.sizes().zip(Self::magnitudes(self.alike, &jet[m - 1])).enumerate() {
            // What is below the normal numbers has no digits to tell anything by. What is not a number bounds the step as well: nothing is
            // longer than that.
            if term < Z::Real::smallest() {
                continue;
            }
            let (size, k) = if size >= Z::Real::smallest() { (size, 0) } else { self.first(jet, group) };
            if k < m {
                least = least.min((self.tolerance + log2(size) - log2(term)) * (1.0 / (m - k) as f64));
            }
        }
        least
    }

    /// The first term of a group that is not zero, with its order.
    #[cold]
    fn first(&self, jet: &[PerCoordinate<Z, S>], group: usize) -> (f64, usize) {
        let terms = jet.iter().map(|x| Self::magnitudes(self.alike, x).nth(group).unwrap_or(0.0));
        terms.zip(1..).find(|(term, _)| *term >= Z::Real::smallest()).unwrap_or((1.0, usize::MAX))
    }

    /// In how long, roughly, the state changes at these rates.
    pub(crate) fn time(&self, rates: &PerCoordinate<Z, S>) -> f64 {
        let times =
            self.sizes().zip(Self::magnitudes(self.alike, rates)).filter(|(size, _)| *size >= Z::Real::smallest());
        times.map(|(size, rate)| size / rate).fold(f64::INFINITY, f64::min)
    }

    /// Whether two rates are the same at the end of a step, but for much more than the tolerance and rounding: of coordinates, and of the
    /// time of the end, which changes rates by `late`.
    #[inline(always)]
    pub(crate) fn agree(
        &self,
        h: f64,
        rates: [&PerCoordinate<Z, S>; 2],
        before: &PerCoordinate<Z, S>,
        late: &PerCoordinate<Z, S>,
    ) -> bool {
        let part = exp2(0.5 * self.tolerance);
        let (rounding, smallest) = (64.0 * Z::Real::epsilon(), Z::Real::smallest());
        let mut gap = *rates[0];
        gap.add_scaled(Z::Real::from_f64(-1.0), rates[1]);
        let late = Self::magnitudes(self.alike, late);
        let groups = Self::magnitudes(self.alike, &gap).zip(late).map(|(gap, late)| gap - late).zip(self.sizes());
        let scales = Self::magnitudes(self.alike, rates[1]).zip(Self::magnitudes(self.alike, before));
        groups.zip(scales).fold(true, |good, ((gap, size), (here, before))| {
            good & (h.abs() * gap <= h.abs() * part * here.max(before) + rounding * size + smallest)
        })
    }
}

/// Log₂ x for a positive normal number, off by at most 0.0431: exponent and fraction as the bits have them.
#[inline(always)]
fn log2(x: f64) -> f64 {
    x.to_bits() as f64 * (1.0 / (1_u64 << 52) as f64) - (1023.0 - 0.043)
}

/// 2ʸ, off by at most 0.32 %.
#[inline(always)]
fn exp2(y: f64) -> f64 {
    if !(y > -1000.0 && y < 1000.0) {
        return if y > 0.0 { f64::INFINITY } else { 0.0 };
    }
    let floor = y as i64 - i64::from(y < 0.0);
    let fraction = y - floor as f64;
    f64::from_bits(((floor + 1023) as u64) << 52) * (1.0 + fraction * (0.6565 + 0.3435 * fraction))
}
