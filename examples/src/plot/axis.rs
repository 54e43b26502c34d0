//! From numbers to places on an axis, and the numbers that are written beside it.

use std::ops::Range;

/// A coordinate: its name with its unit, from where to where, and whether its logarithm is drawn.
#[derive(Clone, Debug)]
pub struct Axis {
    pub(super) label: String,
    /// Of the number, or of its decimal logarithm.
    pub(super) range: Range<f64>,
    logarithmic: bool,
}

impl Axis {
    /// The number itself.
    pub fn linear(label: impl Into<String>, range: Range<f64>) -> Self {
        Axis { label: label.into(), range, logarithmic: false }
    }

    /// A positive number by its decimal logarithm; the range counts decades.
    pub fn decades(label: impl Into<String>, range: Range<f64>) -> Self {
        Axis { label: label.into(), range, logarithmic: true }
    }

    /// Which part of the range a number is from its start; not a number if it has no logarithm.
    pub(super) fn place(&self, x: f64) -> f64 {
        let x = match self.logarithmic {
            true if x <= 0.0 => f64::NAN,
            true => x.log10(),
            false => x,
        };
        (x - self.range.start) / (self.range.end - self.range.start)
    }

    /// At most about `count` numbers, with what is written at them.
    pub(super) fn ticks(&self, count: f64) -> Vec<(f64, String)> {
        let length = self.range.end - self.range.start;
        if self.logarithmic && length <= 2.6 {
            return self.multiples(&[1, 2, 5]);
        }
        let step = if self.logarithmic { (length / count).ceil() } else { round_step(length / count) };
        let first = (self.range.start / step - 1e-9).ceil() as i64;
        let last = (self.range.end / step + 1e-9).floor() as i64;
        let tick = |n| {
            let x = n as f64 * step;
            if self.logarithmic { (10_f64.powf(x), format!("10{}", superscript(x))) } else { (x, number(x)) }
        };
        (first..=last).map(tick).collect()
    }

    /// Some multiples of all powers of ten in the range.
    fn multiples(&self, digits: &[i32]) -> Vec<(f64, String)> {
        let (first, last) = (self.range.start.floor() as i32, self.range.end.ceil() as i32);
        let all = (first..=last).flat_map(|n| digits.iter().map(move |digit| f64::from(*digit) * 10_f64.powi(n)));
        let inside = |x: &f64| (-1e-9..=1.0 + 1e-9).contains(&self.place(*x));
        all.filter(inside).map(|x| (x, number(x))).collect()
    }
}

/// The least of 1, 2, 5, 10, … times a power of ten that is not below a number.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power).find(|step| *step >= least).unwrap_or(10.0 * power)
}

/// A number with a sign that is as wide as a digit; rounded, because ticks may be a rounding away from what they mean.
fn number(x: f64) -> String {
    let rounded = (x * 1e9).round() / 1e9 + 0.0;
    rounded.to_string().replace('-', "−")
}

/// A whole number as an exponent.
fn superscript(n: f64) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize - '0' as usize],
    };
    format!("{n:.0}").chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(axis: Axis, count: f64) -> Vec<String> {
        axis.ticks(count).into_iter().map(|tick| tick.1).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(written(Axis::linear("", -0.3..0.3), 5.0), ["−0.2", "0", "0.2"]);
        assert_eq!(written(Axis::linear("", 0.91..0.945), 4.0), ["0.91", "0.92", "0.93", "0.94"]);
        assert_eq!(written(Axis::decades("", -17.0..1.0), 6.0), ["10⁻¹⁵", "10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"]);
        assert_eq!(written(Axis::decades("", -2.0..-1.0), 6.0), ["0.01", "0.02", "0.05", "0.1"]);
    }
}
