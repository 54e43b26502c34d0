//! What every table is checked for when it is made: fractions that are to add up do so.

/// Whether `fractions` add up to `total`, but for their rounding: those of a constant table are checked by the compiler.
pub(crate) const fn adds_up(fractions: &[f64], total: f64) -> bool {
    let (mut sum, mut size, mut i) = (0.0_f64, total.abs(), 0);
    while i < fractions.len() {
        sum += fractions[i];
        size += fractions[i].abs();
        i += 1;
    }
    (sum - total).abs() <= (fractions.len() as f64 + 1.0) * f64::EPSILON * size
}
