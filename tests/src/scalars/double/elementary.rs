//! Elementary functions, by series and by Newton steps on them.

use super::{Double, two_product, two_sum};
use crate::scalars::compared;
use geoint_runtime::Real;

impl Real for Double {
    compared!();
    #[inline]
    fn from_f64(x: f64) -> Self {
        x.into()
    }
    #[inline]
    fn magnitude(self) -> f64 {
        self.hi.abs()
    }
    #[inline]
    fn any_below(self, bound: f64) -> bool {
        self < Double::from(bound)
    }
    fn smallest() -> f64 {
        f64::MIN_POSITIVE / f64::EPSILON
    }

    fn epsilon() -> f64 {
        f64::EPSILON * f64::EPSILON
    }

    fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return self;
        }
        // One Newton step from the root of the leading part.
        let root = self.hi.sqrt();
        two_sum(root, (self - two_product(root, root)).hi / (2.0 * root))
    }
    fn cbrt(self) -> Self {
        let mut root = Double::from(self.hi.cbrt());
        for _ in 0..2 {
            root -= (root * root * root - self) / (3.0 * root * root);
        }
        root
    }
    fn hypot(self, y: Self) -> Self {
        (self * self + y * y).sqrt()
    }
    fn sin_cos(self) -> (Self, Self) {
        // To |x| ≤ π/4 and its quadrant, then to |x| ≤ 2⁻⁸ by halving: c − 1 ← 2(c − 1)² + 4(c − 1) keeps its digits.
        let quarter = Double::PI.scaled(0.5);
        let turns = (self.hi / quarter.hi).round();
        let x = (self - quarter * turns).scaled(1.0 / 128.0);
        let (mut s, mut c) = (x.series(1, 2, true), x.series(2, 2, true));
        c = -c;
        for _ in 0..7 {
            s = (s + s * c).scaled(2.0);
            c = (c * c).scaled(2.0) + c.scaled(4.0);
        }
        let c = c + 1.0;
        match (turns as i64).rem_euclid(4) {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        }
    }
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    fn tan(self) -> Self {
        let (s, c) = self.sin_cos();
        s / c
    }
    fn asin(self) -> Self {
        self.atan2((1.0 - self * self).sqrt())
    }
    fn acos(self) -> Self {
        (1.0 - self * self).sqrt().atan2(self)
    }
    fn atan(self) -> Self {
        self.atan2(1.0.into())
    }
    fn atan2(self, x: Self) -> Self {
        // Newton: the angle between the point and the direction of a guess is small.
        let r = self.hypot(x);
        let mut angle = Double::from(self.hi.atan2(x.hi));
        for _ in 0..2 {
            let (s, c) = angle.sin_cos();
            angle += (self * c - x * s) / r;
        }
        angle
    }
    fn sinh(self) -> Self {
        let e = self.exp_m1();
        (e + e / (e + 1.0)).scaled(0.5)
    }
    fn cosh(self) -> Self {
        let e = self.exp();
        (e + 1.0 / e).scaled(0.5)
    }
    fn tanh(self) -> Self {
        self.sinh() / self.cosh()
    }
    fn asinh(self) -> Self {
        (self + (self * self + 1.0).sqrt()).ln()
    }
    fn acosh(self) -> Self {
        (self + (self * self - 1.0).sqrt()).ln()
    }
    fn atanh(self) -> Self {
        ((1.0 + self) / (1.0 - self)).ln().scaled(0.5)
    }
    fn exp(self) -> Self {
        let n = (self.hi / Double::LN_2.hi).round();
        let mut e = (self - Double::LN_2 * n).scaled(1.0 / 256.0).series(1, 1, false);
        for _ in 0..8 {
            e = e * e + e.scaled(2.0);
        }
        (e + 1.0).scaled(2.0_f64.powi(n as i32))
    }
    fn exp2(self) -> Self {
        (self * Double::LN_2).exp()
    }
    fn exp_m1(self) -> Self {
        if self.hi.abs() < 1.0 / 256.0 { self.series(1, 1, false) } else { self.exp() - 1.0 }
    }
    fn ln(self) -> Self {
        // Newton on eʸ = x.
        let mut y = Double::from(self.hi.ln());
        for _ in 0..2 {
            y += self * (-y).exp() - 1.0;
        }
        y
    }
    fn ln_1p(self) -> Self {
        (self + 1.0).ln()
    }
    fn log2(self) -> Self {
        self.ln() / Double::LN_2
    }
    fn log10(self) -> Self {
        self.ln() / Double::LN_10
    }
    fn powf(self, y: Self) -> Self {
        (self.ln() * y).exp()
    }
    fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }
    fn min(self, y: Self) -> Self {
        if y < self { y } else { self }
    }
    fn max(self, y: Self) -> Self {
        if y > self { y } else { self }
    }
    fn signum(self) -> Self {
        self.hi.signum().into()
    }
}
