//! Formats numbers in messages, as `{:?}` does, but without ".0" after whole numbers. Limit: precision and width of the format string are ignored.

use core::fmt;

/// Magnitudes in this range are written in decimal form, as in `{:?}`.
const DECIMAL: core::ops::Range<f64> = 1e-5..1e16;

/// Wraps a number for display in messages.
pub(super) struct Number(pub(super) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Number(x) = self;
        if *x == 0.0 || !x.is_finite() || DECIMAL.contains(&x.abs()) { write!(f, "{x}") } else { write!(f, "{x:e}") }
    }
}
