//! Decides by interval arithmetic whether a function vanishes, or is negative, on the straight line between two points.
//!
//! The line parameter runs from 0 to 1. Intervals that contain the values and the rate of the function decide a part of the line, else the part is halved
//! (R. E. Moore, R. B. Kearfott & M. J. Cloud, *Introduction to Interval Analysis*, 2009). A question that stays undecided counts as a zero, or as a
//! negative value.

use crate::scalar::Interval;

/// The largest number of parts of the line that may wait. Each halving leaves one part behind, and 47 halvings reach [`SHORTEST`].
const DEPTH: usize = 48;

/// The length of the shortest part of the line that is divided further. Shorter parts are near the rounding of the parameter.
const SHORTEST: f64 = 1e-14;

/// The largest number of parts that are examined before the question is given up. A line that passes a zero at 10⁻¹⁰ of its length takes about thirty
/// parts.
const MOST_JUDGED: u32 = 500;

/// A coordinate along the line from `start` to `end`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    start: Interval,
    end: Interval,
    /// `end` − `start`, the rate of the coordinate.
    change: Interval,
}

impl Line {
    /// The line between two unknown values.
    pub(crate) const WHOLE: Line = Line { start: Interval::WHOLE, end: Interval::WHOLE, change: Interval::WHOLE };

    /// Returns the line between two values.
    pub(crate) fn new([start, end]: [Interval; 2]) -> Self {
        Line { start, end, change: end - start }
    }

    /// Returns the values of the coordinate on a part of the line, and its rate there: the derivative by the line parameter.
    #[inline(never)]
    pub(crate) fn on(&self, part: Interval) -> (Interval, Interval) {
        let Line { start, end, change } = *self;
        let at = |x: f64| match x {
            0.0 => start,
            1.0 => end,
            _ => start + change * Interval::point(x),
        };
        (at(part.low).hull(at(part.high)), change)
    }
}

/// The result for a property on a part of the line.
enum Judgement {
    Holds,
    /// The property fails somewhere on the part, or counts as failed.
    Fails,
    /// The part is undecided, and its halves may be examined.
    Open,
}

/// Returns whether a property holds on the whole line. An undecided part is halved. A part that stays undecided counts as a failure.
fn holds(judge: impl Fn(f64, f64) -> Judgement) -> bool {
    let mut open = [(0.0_f64, 1.0_f64); DEPTH];
    let (mut waiting, mut judged) = (1, 0);
    while waiting > 0 {
        waiting -= 1;
        judged += 1;
        let (a, b) = open[waiting];
        match judge(a, b) {
            Judgement::Holds => {}
            Judgement::Open if waiting + 2 <= DEPTH && judged <= MOST_JUDGED => {
                let middle = 0.5 * (a + b);
                open[waiting] = (middle, b);
                open[waiting + 1] = (a, middle);
                waiting += 2;
            }
            Judgement::Open | Judgement::Fails => return false,
        }
    }
    true
}

/// Returns whether a function is proven to have no zero in (0, 1]. `term` returns the values and the rate of the function on a part of the line.
///
/// A zero at 0 itself does not count if the function leaves zero at once, because a step may begin there. The result is `false` if the function vanishes,
/// or comes nearer to zero than its rounding errors.
#[cold]
#[inline(never)]
pub(crate) fn vanishes_nowhere(term: &dyn Fn(Interval) -> (Interval, Interval)) -> bool {
    holds(|a, b| {
        let (value, rate) = term(Interval::new(a, b));
        let at = |x: f64| term(Interval::new(x, x)).0;
        let middle = 0.5 * (a + b);
        // By the mean value theorem, the function lies within `reach` of its value at the middle.
        let reach = rate * Interval::new(a - middle, b - middle);
        if !value.contains_zero() || !(at(middle) + reach).contains_zero() {
            return Judgement::Holds;
        }
        if !rate.contains_zero() {
            // The function is monotonic, so its ends decide. A part that starts at 0 may start at a zero.
            let (first, last) = (at(a), at(b));
            let leaves = a == 0.0 && first.contains_zero();
            if !last.contains_zero() && (leaves || (first.signum() == last.signum() && !first.contains_zero())) {
                return Judgement::Holds;
            }
            if !first.contains_zero() && !last.contains_zero() {
                return Judgement::Fails;
            }
        }
        if b - a < SHORTEST { Judgement::Fails } else { Judgement::Open }
    })
}

/// The length below which a part with negative values does not count. A shorter part cannot be distinguished from a point at which the function touches
/// zero. Near such a point, a square that is multiplied out is rounding on a part of length √ε ≈ 10⁻⁸.
const SHORTEST_GAP: f64 = 1e-7;

/// Returns whether a function is negative on a part of the line, or whether this is undecided. The function may touch zero, as a distance does. `term`
/// returns its values and its rate on a part of the line.
#[cold]
#[inline(never)]
pub(crate) fn is_negative_somewhere(term: &dyn Fn(Interval) -> (Interval, Interval)) -> bool {
    !holds(|a, b| {
        let (value, rate) = term(Interval::new(a, b));
        let middle = 0.5 * (a + b);
        let at_middle = term(Interval::new(middle, middle)).0;
        let reach = rate * Interval::new(a - middle, b - middle);
        if value.low >= 0.0 || (at_middle + reach).low >= 0.0 || b - a < SHORTEST_GAP {
            return Judgement::Holds;
        }
        // A function with the value NaN is undefined, so the part fails.
        if at_middle.high >= 0.0 { Judgement::Open } else { Judgement::Fails }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Enclosure, Real};

    /// Returns whether `f` is proven to have no zero on the line from `a` to `b`.
    fn nowhere(f: impl Fn(Enclosure<f64>) -> Enclosure<f64>, a: f64, b: f64) -> bool {
        let end = |x: f64| Interval::point(a) + Interval::point(b - a) * Interval::point(x);
        vanishes_nowhere(&|part| {
            let on = f(Enclosure::new(end(part.low).hull(end(part.high)), Interval::point(b - a)));
            (on.value, on.rate)
        })
    }

    #[test]
    fn zeros_are_seen_and_near_misses_pass() {
        let number = Enclosure::<f64>::from_f64;
        let square = |x: Enclosure<f64>| x.abs() * x.abs();
        // The line crosses the zero, ends at the zero, or starts there.
        assert!(!nowhere(|x| x, -1.0, 2.0) && !nowhere(square, -1.0, 2.0) && !nowhere(square, 1.0, 0.0));
        assert!(nowhere(|x| x, 0.0, 1.0) && nowhere(|x| x, 1.0, 2.0) && nowhere(square, 0.3, 2.0));
        for miss in [1.0, 1e-3, 1e-6, 1e-9, 1e-12] {
            assert!(nowhere(|x| square(x) + number(miss * miss), -0.7, 2.0), "{miss}");
            assert!(nowhere(|x| number(1.0) - x.cos(), miss.max(1e-7), 6.2), "{miss}");
            // The expanded square has no structure, and its minimum is far below the size of its terms.
            let expanded = |x: Enclosure<f64>| square(x) - (x + x) + number(1.0 + miss);
            assert_eq!(nowhere(expanded, -0.7, 2.0), miss > 1e-13, "{miss}");
        }
        assert!(!nowhere(|x| x.cos(), 0.4, 5.9) && !nowhere(|x| number(1.0) - x.cos(), -0.4, 0.5));
        assert!(!nowhere(|x| x.ln(), -1.0, 3.0) && !nowhere(|x| x * number(f64::NAN), 1.0, 2.0));
    }

    #[test]
    fn gaps_are_seen_and_touches_pass() {
        let negative = |f: &dyn Fn(Enclosure<f64>) -> Enclosure<f64>, a: f64, b: f64| {
            let end = |x: f64| Interval::point(a) + Interval::point(b - a) * Interval::point(x);
            is_negative_somewhere(&|part| {
                let on = f(Enclosure::new(end(part.low).hull(end(part.high)), Interval::point(b - a)));
                (on.value, on.rate)
            })
        };
        let number = Enclosure::<f64>::from_f64;
        let square = |x: Enclosure<f64>| x.abs() * x.abs();
        for width in [1.0, 1e-2, 1e-4, 1e-6] {
            assert!(negative(&|x| square(x) - number(width * width), -1.7, 2.0), "{width}");
            assert!(!negative(&|x| square(x) + number(width * width), -1.7, 2.0), "{width}");
        }
        // A distance may be zero on the way.
        assert!(!negative(&|x| number(2.0) - (x.cos() + x.cos()), -0.4, 0.5) && !negative(&|x| x, 0.0, 1.0));
        assert!(!negative(&|x| square(x) - (x + x) + number(1.0), -0.7, 2.0));
        assert!(negative(&|x| x.sin(), 1.0, 7.0) && negative(&|x| x * number(f64::NAN), 1.0, 2.0));
    }
}
