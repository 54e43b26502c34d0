//! Interval arithmetic in `f64`. The interval of an expression contains all values of the expression, if each symbol lies in its interval.
//!
//! Ends are rounded outwards, by one unit in the last place after correctly rounded operations, and by a further [`ULPS`] after library functions. If
//! an operand is partly outside the domain of a function, only the part inside is used. If it is entirely outside, or NaN, the result is the whole line.
//! R. E. Moore, R. B. Kearfott & M. J. Cloud, *Introduction to Interval Analysis* (2009).

mod arithmetic;

use super::Real;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Bound of the error of elementary functions, in units of the last place. Libraries state errors of 1 to 3 units.
const ULPS: f64 = 4.0;

/// All finite numbers from `low` to `high`. Invariant: the interval is not empty, and no end is NaN. An infinite end means that the interval is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// Returns the smallest and the largest number. Both are NaN if a number is NaN.
fn extremes<const N: usize>(x: [f64; N]) -> [f64; 2] {
    x.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        if x.is_nan() { [f64::NAN; 2] } else { [if *x < low { *x } else { low }, if *x > high { *x } else { high }] }
    })
}

impl Interval {
    pub(crate) const WHOLE: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// Returns the interval with these ends. Returns the whole line if an end is NaN, or if `low > high`.
    pub(crate) fn new(low: f64, high: f64) -> Self {
        if low <= high {
            // An end that has overflowed inwards is replaced by the largest finite number.
            Interval { low: low.min(f64::MAX), high: high.max(f64::MIN) }
        } else {
            Self::WHOLE
        }
    }

    pub(crate) fn point(x: f64) -> Self {
        if x.is_finite() { Self::new(x, x) } else { Self::WHOLE }
    }

    /// Returns the interval, rounded outwards by one unit in the last place.
    fn rounded(low: f64, high: f64) -> Self {
        Self::new(low.next_down(), high.next_up())
    }

    /// Returns the interval, rounded outwards by the error of a library function.
    fn approximate(low: f64, high: f64) -> Self {
        let margin = |x: f64| if x.is_finite() { x.magnitude() * (ULPS * f64::EPSILON) } else { 0.0 };
        Self::rounded(low - margin(low), high + margin(high))
    }

    pub(crate) fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// Returns the part between two bounds, or the whole line if that part is empty.
    fn within(self, low: f64, high: f64) -> Self {
        Self::new(self.low.max(low), self.high.min(high))
    }

    pub(crate) fn contains_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    pub(crate) fn is_whole(self) -> bool {
        self == Self::WHOLE
    }

    fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// Returns the image under an increasing function.
    fn rising(self, f: impl Fn(f64) -> f64) -> Self {
        Self::approximate(f(self.low), f(self.high))
    }

    fn falling(self, f: impl Fn(f64) -> f64) -> Self {
        Self::approximate(f(self.high), f(self.low))
    }

    /// Returns the interval of x², without negative numbers.
    pub(crate) fn square(self) -> Self {
        self.abs() * self.abs()
    }

    pub(crate) fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Self::new(0.0, self.high.max(-self.low))
        }
    }

    pub(crate) fn signum(self) -> Self {
        if self.low > 0.0 {
            Self::point(1.0)
        } else if self.high < 0.0 {
            Self::point(-1.0)
        } else {
            Self::new(-1.0, 1.0)
        }
    }

    pub(crate) fn max(self, y: Self) -> Self {
        Self::new(self.low.max(y.low), self.high.max(y.high))
    }

    pub(crate) fn sqrt(self) -> Self {
        let x = self.within(0.0, f64::INFINITY);
        if x.is_whole() { x } else { Self::rounded(Real::sqrt(x.low), Real::sqrt(x.high)).within(0.0, f64::INFINITY) }
    }

    pub(crate) fn cbrt(self) -> Self {
        self.rising(Real::cbrt)
    }

    pub(crate) fn hypot(self, y: Self) -> Self {
        let (x, y) = (self.abs(), y.abs());
        let end = |x, y| if x == 0.0 || y == 0.0 { x + y } else { Real::hypot(x, y) };
        Self::approximate(end(x.low, y.low), end(x.high, y.high)).within(0.0, f64::INFINITY)
    }

    /// Returns the image under a sine wave `f` with maxima at `crest` + 2πn. The image contains the values at both ends. It contains ±1 if a maximum or
    /// minimum may lie between the ends.
    fn wave(self, crest: f64, f: fn(f64) -> f64) -> Self {
        let bounds = Self::new(-1.0, 1.0);
        // For larger arguments, rounding makes the number of turns unreliable.
        if !(self.high - self.low < TAU && self.low.magnitude().max(self.high.magnitude()) < 1e9) {
            return bounds;
        }
        let reaches = |top: f64| {
            let [a, b] = [self.low, self.high].map(|x| (x - top) / TAU);
            let slack = 1e-14 * (1.0 + a.magnitude() + b.magnitude());
            floor(b + slack) >= a - slack
        };
        let [low, high] = extremes([f(self.low), f(self.high)]);
        let Interval { mut low, mut high } = Self::approximate(low, high);
        if reaches(crest) {
            high = 1.0;
        }
        if reaches(crest + PI) {
            low = -1.0;
        }
        Self::new(low, high).within(-1.0, 1.0)
    }

    pub(crate) fn sin(self) -> Self {
        self.wave(FRAC_PI_2, Real::sin)
    }

    pub(crate) fn cos(self) -> Self {
        self.wave(0.0, Real::cos)
    }

    pub(crate) fn tan(self) -> Self {
        if self.high - self.low < PI && !self.cos().contains_zero() { self.rising(Real::tan) } else { Self::WHOLE }
    }

    pub(crate) fn asin(self) -> Self {
        let x = self.within(-1.0, 1.0);
        if x.is_whole() { x } else { x.rising(Real::asin) }
    }

    pub(crate) fn acos(self) -> Self {
        let x = self.within(-1.0, 1.0);
        if x.is_whole() { x } else { x.falling(Real::acos).within(0.0, 4.0) }
    }

    pub(crate) fn atan(self) -> Self {
        self.rising(Real::atan)
    }

    /// Returns the angles of the points (x, self). All angles if the cut or the origin may be among the points.
    pub(crate) fn atan2(self, x: Self) -> Self {
        if self.is_cut(x) {
            return Self::approximate(-PI, PI);
        }
        let corners = [(self.low, x.low), (self.low, x.high), (self.high, x.low), (self.high, x.high)];
        let [low, high] = extremes(corners.map(|(y, x)| Real::atan2(y, x)));
        Self::approximate(low, high)
    }

    /// Returns whether the points (x, self) may include the cut or the origin, where the angle jumps.
    pub(crate) fn is_cut(self, x: Self) -> bool {
        self.contains_zero() && x.low <= 0.0
    }

    pub(crate) fn sinh(self) -> Self {
        self.rising(Real::sinh)
    }

    pub(crate) fn cosh(self) -> Self {
        self.abs().rising(Real::cosh).within(1.0, f64::INFINITY)
    }

    pub(crate) fn tanh(self) -> Self {
        self.rising(Real::tanh).within(-1.0, 1.0)
    }

    pub(crate) fn asinh(self) -> Self {
        self.rising(Real::asinh)
    }

    pub(crate) fn acosh(self) -> Self {
        let x = self.within(1.0, f64::INFINITY);
        if x.is_whole() { x } else { x.rising(Real::acosh).within(0.0, f64::INFINITY) }
    }

    pub(crate) fn atanh(self) -> Self {
        let x = self.within(-1.0, 1.0);
        if x.is_whole() { x } else { x.rising(Real::atanh) }
    }

    pub(crate) fn exp(self) -> Self {
        self.rising(Real::exp).within(0.0, f64::INFINITY)
    }

    pub(crate) fn exp2(self) -> Self {
        self.rising(Real::exp2).within(0.0, f64::INFINITY)
    }

    pub(crate) fn exp_m1(self) -> Self {
        self.rising(Real::exp_m1).within(-1.0, f64::INFINITY)
    }

    /// Returns the image under a logarithm `f` that is defined above `edge`.
    pub(crate) fn logarithm(self, edge: f64, f: impl Fn(f64) -> f64) -> Self {
        let x = self.within(edge, f64::INFINITY);
        if x.is_whole() || x.high == edge { Self::WHOLE } else { x.rising(f) }
    }

    pub(crate) fn powf(self, y: Self) -> Self {
        let x = self.within(0.0, f64::INFINITY);
        if x.is_whole() {
            return x;
        }
        // Monotonic in each argument, so the extremes are at corners.
        let corners = [(x.low, y.low), (x.low, y.high), (x.high, y.low), (x.high, y.high)];
        let [low, high] = extremes(corners.map(|(x, y)| Real::powf(x, y)));
        Self::approximate(low, high).within(0.0, f64::INFINITY)
    }
}

/// Returns the largest integer up to x. Precondition: |x| < 2⁶³.
fn floor(x: f64) -> f64 {
    let whole = x as i64 as f64;
    if whole > x { whole - 1.0 } else { whole }
}
