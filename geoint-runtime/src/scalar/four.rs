//! Arithmetic on four numbers at a time, in one SIMD register if the processor has them.

use super::real::{Four, Real};
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

macro_rules! operators {
    ($($operator:ident $method:ident = $four:ident),* $(,)?) => { $(
        impl<R: Real> $operator for Four<R> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Four(R::$four(self.0, other.0))
            }
        }
    )* };
}

operators! { Add add = add_four, Sub sub = subtract_four, Mul mul = multiply_four, Div div = divide_four }

impl<R: Real> Neg for Four<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Four(from_fn(|i| -self.0[i]))
    }
}

impl<R: Real> Four<R> {
    /// Returns `self·a + b`, fused if [`Real::multiply_add`] is fused.
    #[inline(always)]
    pub fn multiply_add(self, a: Self, b: Self) -> Self {
        Four(R::multiply_add_four(self.0, a.0, b.0))
    }

    /// Returns the square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Four(R::sqrt_four(self.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares operations on four numbers with operations on single numbers, including special values.
    macro_rules! keeps_its_bits {
        ($name:ident, $real:ident) => {
            #[test]
            fn $name() {
                let large = $real::MAX.sqrt();
                let numbers = [
                    0.0,
                    -0.0,
                    1.0,
                    -1.0 / 3.0,
                    0.7,
                    1e-30,
                    3e30,
                    large,
                    1.5 * large,
                    $real::MAX,
                    $real::MIN_POSITIVE,
                    $real::MIN_POSITIVE / 64.0,
                    -$real::EPSILON,
                    1.0 + $real::EPSILON,
                    $real::INFINITY,
                    $real::NEG_INFINITY,
                    $real::NAN,
                ];
                let four = |begin: usize| from_fn(|lane| numbers[(begin + lane) % numbers.len()]);
                let same = |what: &str, Four(found): Four<$real>, expected: [$real; 4]| {
                    for (found, expected) in found.iter().zip(expected) {
                        let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
                        assert!(same, "{what}: {found:e} and {expected:e}");
                    }
                };
                for i in 0..numbers.len() {
                    for j in 0..numbers.len() {
                        let ([a, b, c], [x, y, z]) = ([i, j, i + j].map(four), [i, j, i + j].map(|k| Four(four(k))));
                        same("+", x + y, from_fn(|k| a[k] + b[k]));
                        same("-", x - y, from_fn(|k| a[k] - b[k]));
                        same("*", x * y, from_fn(|k| a[k] * b[k]));
                        same("/", x / y, from_fn(|k| a[k] / b[k]));
                        same("multiply_add", x.multiply_add(y, z), from_fn(|k| Real::multiply_add(a[k], b[k], c[k])));
                        same("sqrt", x.sqrt(), from_fn(|k| Real::sqrt(a[k])));
                        same("neg", -x, from_fn(|k| -a[k]));
                    }
                }
            }
        };
    }

    keeps_its_bits!(double_precision, f64);
    keeps_its_bits!(single_precision, f32);
}
