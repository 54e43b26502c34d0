//! Central forces between bodies: a power of the squared distance, multiplied by each component of the distance vector.

use super::{fused, plus, power, product, scaled, squares, times, whole};
use crate::scalar::Real;
use crate::space::Array;

/// Coefficients of one order.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Row<A, const K: usize> {
    factors: [A; K],
    square: A,
    power: A,
}

/// Series of u = Σ d², of y = c·u^α, and of the products of y with each d. `A` holds one such force, or several side by side.
#[derive(Debug)]
pub struct Central<A: Array, const K: usize, const P: usize> {
    exponent: A::Real,
    /// α·y₀/u₀.
    ratio: A,
    rows: [Row<A, K>; P],
}

impl<A: Array, const K: usize, const P: usize> Central<A, K, P> {
    /// Starts with the coefficients of order 0.
    #[inline(always)]
    pub fn new(factors: [A; K], square: A, power: A, exponent: A::Real) -> Self {
        let mut ratio = power;
        for (y, u) in ratio.as_mut_slice().iter_mut().zip(square.as_slice()) {
            *y = exponent * *y / *u;
        }
        let mut rows = [Row { factors: [A::zero(); K], square: A::zero(), power: A::zero() }; P];
        rows[0] = Row { factors, square, power };
        Central { exponent, ratio, rows }
    }

    /// Sets all d of order n ≥ 1.
    #[inline(always)]
    pub fn take(&mut self, n: usize, factors: [A; K]) {
        self.rows[n].factors = factors;
    }

    /// Returns the products of order n ≥ 1. Precondition: all d of this order are set.
    ///
    /// All sums share one loop, which reads every coefficient once. Not inlined: next to other sums, the vectoriser mixes their terms and separates
    /// adjacent values.
    #[inline(never)]
    pub fn order(&mut self, n: usize) -> [A; K] {
        let order = whole::<A::Real>(n);
        let next = self.exponent + A::Real::from_f64(1.0);
        // Weights j(α + 1) − n of the terms j and n − j of the power. They start in the middle, so that the newest coefficients enter last.
        let lowest = whole::<A::Real>(n.div_ceil(2) - 1);
        let [mut below, mut above] = [lowest, order - lowest].map(|j| everywhere::<A>(j.multiply_add(next, -order)));
        let (down, up) = (everywhere::<A>(-next), everywhere::<A>(next));
        let ([mut low_products, mut high_products, mut halves], [mut low_power, mut high_power]) =
            ([[A::zero(); K]; 3], [A::zero(); 2]);
        if n.is_multiple_of(2) {
            let Row { factors, square, power } = &self.rows[n / 2];
            for k in 0..K {
                low_products[k] = times(factors[k], *power);
                halves[k] = times(scaled(A::Real::from_f64(0.5), factors[k]), factors[k]);
            }
            low_power = scaled(whole::<A::Real>(n / 2).multiply_add(next, -order), times(*square, *power));
        }
        for j in n / 2 + 1..n.min(P) {
            let [low, high] = [&self.rows[n - j], &self.rows[j]];
            for k in 0..K {
                low_products[k] = fused(low.factors[k], high.power, low_products[k]);
                high_products[k] = fused(high.factors[k], low.power, high_products[k]);
                halves[k] = fused(low.factors[k], high.factors[k], halves[k]);
            }
            low_power = fused(times(below, low.square), high.power, low_power);
            high_power = fused(times(above, high.square), low.power, high_power);
            (below, above) = (plus(below, down), plus(above, up));
        }
        let (first, factors) = (&self.rows[0], self.rows[n].factors);
        let half = halves.into_iter().fold(A::nothing(), plus);
        let square = squares(first.factors, factors, plus(half, half));
        let power = power([first.square, self.ratio], square, plus(low_power, high_power), n);
        let mut products = low_products;
        for k in 0..K {
            let sum = plus(low_products[k], high_products[k]);
            products[k] = product([first.factors[k], first.power], [factors[k], power], sum);
        }
        (self.rows[n].square, self.rows[n].power) = (square, power);
        products
    }

    /// Returns u of order n.
    #[inline(always)]
    pub fn square(&self, n: usize) -> A {
        self.rows[n].square
    }

    /// Returns y of order n.
    #[inline(always)]
    pub fn power(&self, n: usize) -> A {
        self.rows[n].power
    }
}

/// Returns an array with the same number in every entry.
#[inline(always)]
fn everywhere<A: Array>(x: A::Real) -> A {
    let mut all = A::zero();
    all.as_mut_slice().iter_mut().for_each(|entry| *entry = x);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every coefficient equals the sum that defines it, for two forces side by side.
    #[test]
    fn coefficients_are_the_sums_that_define_them() {
        const P: usize = 15;
        let exponent = -1.7;
        let d = |k: usize, n: usize| [1.0 + k as f64, 0.3 - k as f64].map(|x| (x + n as f64).sin() / (1 + n) as f64);
        let now = |n: usize| [d(0, n), d(1, n), d(2, n)];
        let start = now(0);
        let square: [f64; 2] = core::array::from_fn(|lane| start.iter().map(|d| d[lane] * d[lane]).sum());
        let power = square.map(|u| 0.6 * f64::powf(u, exponent));
        let mut central = Central::<[f64; 2], 3, P>::new(start, square, power, exponent);
        for n in 1..P {
            central.take(n, now(n));
            let products = central.order(n);
            for lane in 0..2 {
                let d = |k: usize, n: usize| d(k, n)[lane];
                let u: [f64; P] = core::array::from_fn(|n| central.square(n)[lane]);
                let y: [f64; P] = core::array::from_fn(|n| central.power(n)[lane]);
                let close = |a: f64, terms: &dyn Fn(usize) -> f64, first: usize, over: f64| {
                    let all = (first..=n).map(terms);
                    let [sum, size] = all.fold([0.0; 2], |[sum, size], x| [sum + x, size + x.abs()]);
                    assert!(
                        (a - sum / over).abs() <= 16.0 * f64::EPSILON * size / over.abs(),
                        "{n}: {a}, {}",
                        sum / over
                    );
                };
                close(u[n], &|j| (0..3).map(|k| d(k, j) * d(k, n - j)).sum(), 0, 1.0);
                let weight = |j: usize| j as f64 * (exponent + 1.0) - n as f64;
                close(y[n], &|j| weight(j) * u[j] * y[n - j], 1, n as f64 * u[0]);
                for k in 0..3 {
                    close(products[k][lane], &|j| d(k, j) * y[n - j], 0, 1.0);
                }
            }
        }
    }
}
