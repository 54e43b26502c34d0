//! Axes: the place of a number, and the ticks.

use std::ops::Range;

/// An axis: its label with a unit, its range, and its scale.
#[derive(Clone, Debug)]
pub struct Axis {
    pub(super) label: String,
    /// Range of the number, or of its decimal logarithm.
    pub(super) range: Range<f64>,
    logarithmic: bool,
}

impl Axis {
    /// Returns a linear axis.
    pub fn linear(label: impl Into<String>, range: Range<f64>) -> Self {
        Axis { label: label.into(), range, logarithmic: false }
    }

    /// Returns a logarithmic axis; the range is that of the decimal logarithm.
    pub fn decades(label: impl Into<String>, range: Range<f64>) -> Self {
        Axis { label: label.into(), range, logarithmic: true }
    }

    /// Returns the place of a number: 0 at the start of the range and 1 at its end, NaN if the number has no logarithm.
    pub(super) fn place(&self, x: f64) -> f64 {
        let x = match self.logarithmic {
            true if x <= 0.0 => f64::NAN,
            true => x.log10(),
            false => x,
        };
        (x - self.range.start) / (self.range.end - self.range.start)
    }

    /// Returns about `count` ticks or fewer: numbers with their labels.
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

    /// Returns the multiples of powers of ten by `digits` in the range.
    fn multiples(&self, digits: &[i32]) -> Vec<(f64, String)> {
        let (first, last) = (self.range.start.floor() as i32, self.range.end.ceil() as i32);
        let all = (first..=last).flat_map(|n| digits.iter().map(move |digit| f64::from(*digit) * 10_f64.powi(n)));
        let inside = |x: &f64| (-1e-9..=1.0 + 1e-9).contains(&self.place(*x));
        all.filter(inside).map(|x| (x, number(x))).collect()
    }
}

/// Returns the least number of the form 1, 2 or 5 times a power of ten that is at least `least`.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power).find(|step| *step >= least).unwrap_or(10.0 * power)
}

/// Formats the number of a tick with a wide minus sign. Rounds to nine decimals, because a computed tick has a rounding error.
fn number(x: f64) -> String {
    let rounded = (x * 1e9).round() / 1e9 + 0.0;
    rounded.to_string().replace('-', "−")
}

/// Formats a whole number as an exponent.
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
