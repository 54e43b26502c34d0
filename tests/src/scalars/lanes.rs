//! Two numbers side by side. Each component must behave like a scalar, independent of the other component.

use super::arithmetic;
use geoint_runtime::Real;

/// A pair of numbers on which everything is done component by component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes(pub [f64; 2]);

impl Lanes {
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Lanes([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }
}

impl From<f64> for Lanes {
    fn from(x: f64) -> Self {
        Lanes([x; 2])
    }
}

arithmetic! { Lanes:
    Add::add, AddAssign::add_assign = |a, b| a.zip(b, |a, b| a + b);
    Sub::sub, SubAssign::sub_assign = |a, b| a.zip(b, |a, b| a - b);
    Mul::mul, MulAssign::mul_assign = |a, b| a.zip(b, |a, b| a * b);
    Div::div, DivAssign::div_assign = |a, b| a.zip(b, |a, b| a / b);
}

impl core::ops::Neg for Lanes {
    type Output = Self;
    fn neg(self) -> Self {
        Lanes(self.0.map(|x| -x))
    }
}

macro_rules! each {
    ($($function:ident($($y:ident)?)),*) => { $(
        fn $function(self $(, $y: Self)?) -> Self {
            each!(self $function $($y)?)
        }
    )* };
    ($x:ident $function:ident) => { Lanes($x.0.map(f64::$function)) };
    ($x:ident $function:ident $y:ident) => { $x.zip($y, f64::$function) };
}

/// A choice for each component.
#[derive(Clone, Copy, Debug)]
pub struct Choices([bool; 2]);

impl core::ops::BitAnd for Choices {
    type Output = Self;
    fn bitand(self, Choices([c, d]): Self) -> Self {
        let [a, b] = self.0;
        Choices([a & c, b & d])
    }
}

impl core::ops::BitOr for Choices {
    type Output = Self;
    fn bitor(self, Choices([c, d]): Self) -> Self {
        let [a, b] = self.0;
        Choices([a | c, b | d])
    }
}

impl core::ops::Not for Choices {
    type Output = Self;
    fn not(self) -> Self {
        Choices(self.0.map(|choice| !choice))
    }
}

impl Real for Lanes {
    type Mask = Choices;
    fn less(self, y: Self) -> Choices {
        Choices([0, 1].map(|i| self.0[i] < y.0[i]))
    }
    fn less_equal(self, y: Self) -> Choices {
        Choices([0, 1].map(|i| self.0[i] <= y.0[i]))
    }
    fn equal(self, y: Self) -> Choices {
        Choices([0, 1].map(|i| self.0[i] == y.0[i]))
    }
    fn choose<const N: usize>(
        Choices(mask): Choices,
        first: impl FnOnce() -> [Self; N],
        second: impl FnOnce() -> [Self; N],
    ) -> [Self; N] {
        match mask {
            [true, true] => first(),
            [false, false] => second(),
            _ => {
                let (first, second) = (first(), second());
                let side = |i: usize, lane: usize| if mask[lane] { first[i].0[lane] } else { second[i].0[lane] };
                core::array::from_fn(|i| Lanes([side(i, 0), side(i, 1)]))
            }
        }
    }
    fn from_f64(x: f64) -> Self {
        x.into()
    }
    fn magnitude(self) -> f64 {
        // Not `max`: that would lose a NaN.
        let [x, y] = self.0.map(f64::abs);
        if x >= y || x.is_nan() { x } else { y }
    }
    fn any_below(self, bound: f64) -> bool {
        self.0.iter().any(|x| *x < bound)
    }
    fn smallest() -> f64 {
        f64::MIN_POSITIVE
    }

    fn epsilon() -> f64 {
        f64::EPSILON
    }

    each!(sqrt(), cbrt(), hypot(y), sin(), cos(), tan(), asin(), acos(), atan(), atan2(y), sinh(), cosh(), tanh());
    each!(asinh(), acosh(), atanh(), exp(), exp2(), exp_m1(), ln(), ln_1p(), log2(), log10(), powf(y));
    each!(abs(), min(y), max(y), signum());
}
