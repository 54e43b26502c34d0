//! Implements [`Real`] for `f64` and `f32`, by the standard library, or by libm without it.

use super::real::Real;
use wide::{f32x4, f64x4};

/// Selects the first value if fused multiply-add is available (feature `std`, target feature `fma`, no `strict-math`), else the second one.
macro_rules! fused {
    ($fused:expr, $apart:expr) => {{
        #[cfg(all(feature = "std", target_feature = "fma", not(feature = "strict-math")))]
        let value = $fused;
        #[cfg(not(all(feature = "std", target_feature = "fma", not(feature = "strict-math"))))]
        let value = $apart;
        value
    }};
}

/// Implements [`Real`] for a floating-point type. Each function has a version of the standard library and one of libm.
macro_rules! floats {
    ($($real:ident, $four:ident, $magnitude:expr, $lower_bits:literal, $time:expr, { $($method:ident($($y:ident)?) = $libm:ident),* $(,)? }, $sincos:ident;)*) => { $(
        impl Real for $real {
            type Mask = bool;
            #[inline(always)]
            fn less(self, y: Self) -> bool {
                self < y
            }
            #[inline(always)]
            fn less_equal(self, y: Self) -> bool {
                self <= y
            }
            #[inline(always)]
            fn equal(self, y: Self) -> bool {
                self == y
            }
            #[inline(always)]
            fn choose<const N: usize>(
                mask: bool,
                first: impl FnOnce() -> [Self; N],
                second: impl FnOnce() -> [Self; N],
            ) -> [Self; N] {
                if mask { first() } else { second() }
            }
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $real
            }
            #[inline(always)]
            fn magnitude(self) -> f64 {
                $magnitude(self)
            }
            #[inline(always)]
            fn any_below(self, bound: f64) -> bool {
                self < bound as $real
            }
            #[inline(always)]
            fn epsilon() -> f64 {
                $real::EPSILON as f64
            }
            #[inline(always)]
            fn smallest() -> f64 {
                $real::MIN_POSITIVE as f64
            }
            #[inline(always)]
            fn time(t0: [Self; 2], n: u64, h: Self) -> Self {
                $time(t0, n, h)
            }
            #[inline(always)]
            fn multiply_add(self, a: Self, b: Self) -> Self {
                fused!($real::mul_add(self, a, b), self * a + b)
            }
            #[inline(always)]
            fn add_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
                ($four::from(a) + $four::from(b)).to_array()
            }
            #[inline(always)]
            fn subtract_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
                ($four::from(a) - $four::from(b)).to_array()
            }
            #[inline(always)]
            fn multiply_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
                ($four::from(a) * $four::from(b)).to_array()
            }
            #[inline(always)]
            fn divide_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
                ($four::from(a) / $four::from(b)).to_array()
            }
            #[inline(always)]
            fn multiply_add_four(x: [Self; 4], a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
                let [x, a, b] = [x, a, b].map($four::from);
                fused!(x.mul_add(a, b), x * a + b).to_array()
            }
            #[inline(always)]
            fn sqrt_four(x: [Self; 4]) -> [Self; 4] {
                $four::from(x).sqrt().to_array()
            }
            // Rounds to fewer bits by integer operations. Dekker's product could overflow.
            #[inline(always)]
            fn upper_half(self) -> Self {
                let rounded = self.to_bits().wrapping_add(1 << ($lower_bits - 1));
                $real::from_bits(rounded >> $lower_bits << $lower_bits)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                #[cfg(feature = "std")]
                return $real::sin_cos(self);
                #[cfg(not(feature = "std"))]
                return libm::$sincos(self);
            }
            #[inline(always)]
            fn signum(self) -> Self {
                $real::signum(self)
            }
            $(
                #[inline(always)]
                fn $method(self $(, $y: Self)?) -> Self {
                    #[cfg(feature = "std")]
                    return $real::$method(self $(, $y)?);
                    #[cfg(not(feature = "std"))]
                    return libm::$libm(self $(, $y)?);
                }
            )*
        }
    )* };
}

floats! {
    f64, f64x4, f64::abs, 27, |t0: [f64; 2], n: u64, h: f64| t0[0] + (t0[1] + n as i64 as f64 * h), {
        sqrt() = sqrt, cbrt() = cbrt, hypot(y) = hypot,
        sin() = sin, cos() = cos, tan() = tan, asin() = asin, acos() = acos, atan() = atan, atan2(x) = atan2,
        sinh() = sinh, cosh() = cosh, tanh() = tanh, asinh() = asinh, acosh() = acosh, atanh() = atanh,
        exp() = exp, exp2() = exp2, exp_m1() = expm1, ln() = log, ln_1p() = log1p, log2() = log2, log10() = log10,
        powf(y) = pow, abs() = fabs, min(y) = fmin, max(y) = fmax,
    }, sincos;
    f32, f32x4, |x: f32| f64::from(x.abs()), 12, |t0: [f32; 2], n: u64, h: f32| (f64::from(t0[0]) + (f64::from(t0[1]) + n as f64 * f64::from(h))) as f32, {
        sqrt() = sqrtf, cbrt() = cbrtf, hypot(y) = hypotf,
        sin() = sinf, cos() = cosf, tan() = tanf, asin() = asinf, acos() = acosf, atan() = atanf, atan2(x) = atan2f,
        sinh() = sinhf, cosh() = coshf, tanh() = tanhf, asinh() = asinhf, acosh() = acoshf, atanh() = atanhf,
        exp() = expf, exp2() = exp2f, exp_m1() = expm1f, ln() = logf, ln_1p() = log1pf, log2() = log2f,
        log10() = log10f, powf(y) = powf, abs() = fabsf, min(y) = fminf, max(y) = fmaxf,
    }, sincosf;
}
