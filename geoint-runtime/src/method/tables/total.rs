//! A check of tables at compile time: the fractions of a table add up to their total.

/// Returns whether `fractions` are finite and add up to `total`, except for rounding. For constant tables the compiler evaluates this function.
pub(crate) const fn adds_up(fractions: &[f64], total: f64) -> bool {
    let (mut sum, mut size, mut i) = (0.0_f64, total.abs(), 0);
    while i < fractions.len() {
        sum += fractions[i];
        size += fractions[i].abs();
        i += 1;
    }
    // Infinite fractions would make the bound on the right infinite.
    size < f64::INFINITY && (sum - total).abs() <= (fractions.len() as f64 + 1.0) * f64::EPSILON * size
}

#[cfg(test)]
mod tests {
    use super::adds_up;

    #[test]
    fn non_finite_fractions_never_add_up() {
        assert!(adds_up(&[0.5, 0.25, 0.25], 1.0) && adds_up(&[0.1; 10], 1.0) && adds_up(&[], 0.0));
        assert!(!adds_up(&[], 1.0) && !adds_up(&[0.5, 0.5 + 1e-14], 1.0));
        let (infinite, no_number) = (f64::INFINITY, f64::NAN);
        for fractions in [[infinite, 1.0], [-infinite, 1.0], [infinite, -infinite], [no_number, 1.0], [1e308, 1e308]] {
            for total in [1.0, 0.0, infinite, no_number] {
                assert!(!adds_up(&fractions, total), "{fractions:?} {total}");
            }
        }
    }
}
