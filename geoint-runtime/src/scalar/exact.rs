//! Sums and products together with their rounding errors (error-free transformations).

use super::real::Real;

/// Returns a + b and its rounding error. Precondition: |b| ≤ |a|. T. J. Dekker, Numer. Math. 18 (1971) 224.
#[inline(always)]
pub(crate) fn sum_with_small<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Returns a + b and its rounding error. D. E. Knuth, *Seminumerical Algorithms*, 4.2.2.
#[inline(always)]
pub(crate) fn exact_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    let added = sum - a;
    (sum, (a - (sum - added)) + (b - added))
}

/// Returns a·b and its rounding error, from the halves of the digits. No fused operation is needed. T. J. Dekker, Numer. Math. 18 (1971) 224.
#[inline(always)]
pub(crate) fn exact_product<R: Real>(a: R, b: R) -> (R, R) {
    let product = a * b;
    let (a, b) = (halves(a), halves(b));
    (product, (((a.0 * b.0 - product) + a.0 * b.1) + a.1 * b.0) + a.1 * b.1)
}

/// Returns the upper and the lower half of the digits.
#[inline(always)]
pub(crate) fn halves<R: Real>(x: R) -> (R, R) {
    let upper = x.upper_half();
    (upper, x - upper)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns pseudo-random odd numbers with the given number of bits.
    fn digits(bits: u32) -> impl Iterator<Item = u64> {
        let start = 0x9e37_79b9_7f4a_7c15_u64;
        (0..1000).scan(start, move |x, _| {
            *x = x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(start);
            Some(*x >> (64 - bits) | 1 | 1 << (bits - 1))
        })
    }

    #[test]
    fn products_and_rounding_errors_sum_to_exact_integers() {
        for (a, b) in digits(53).zip(digits(53).skip(7)) {
            let (product, lost) = exact_product(a as f64, b as f64);
            assert_eq!(product as u128 as i128 + lost as i128, i128::from(a) * i128::from(b));
            assert_eq!(product, a as f64 * b as f64);
        }
        for (a, b) in digits(24).zip(digits(24).skip(7)) {
            let (product, lost) = exact_product(a as f32, b as f32);
            assert_eq!(product as i64 + lost as i64, (a * b) as i64);
        }
    }

    #[test]
    fn halves_of_large_and_small_numbers() {
        for x in [1.7e308, -1.1e300, 3.3e-300, 0.0, 1.0 + f64::EPSILON] {
            let (upper, lower) = halves(x);
            assert_eq!(upper + lower, x);
            // 26 bits.
            assert_eq!(upper.to_bits() & ((1 << 27) - 1), 0);
            assert!(lower.abs() <= x.abs() / f64::from(1 << 25));
        }
        let (product, lost) = exact_product(-1.1e300_f64, 1e8 + 1.0);
        assert!(product.is_finite() && lost.abs() <= f64::EPSILON * product.abs());
    }
}
