//! Recurrences for Taylor coefficients of order n ≥ 1, called by generated kernels.
//!
//! Coefficients are normalised: u⁽ⁿ⁾/n!.
//!
//! Sums Σ uⱼwₙ₋ⱼ start in the middle, with the oldest coefficients, in two chains. The newest coefficients enter last. Each operation then adds one
//! multiplication to the critical path. Do not reorder: with j from 0 on, the double pendulum takes four times as long.
//!
//! Sums are divided by a value, not multiplied by its stored reciprocal, whose rounding error would enter at every order. A stored reciprocal only
//! multiplies the coefficient of order n, which is smaller and on the critical path. Sums of quotients contain the newest coefficients: there, a
//! reciprocal in two parts replaces the division.
//!
//! R. E. Moore, *Interval Analysis* (1966) ch. 11; À. Jorba & M. Zou, Exp. Math. 14 (2005) 99. For powers, see also R. D. Neidinger, SIAM Rev. 52
//! (2010) 545.

mod central;

pub use central::Central;

use crate::scalar::{Real, exact_product, zero};
use crate::space::Array;

/// A set of series whose coefficients follow from those of lower orders.
pub trait Series {
    /// Computes the coefficients of order n ≥ 1 from those of lower orders.
    fn order(&mut self, n: usize);
}

/// Computes the coefficients of the orders 1 ≤ n < P. Orders up to `UNROLLED` have code of their own, with sums of constant length.
///
/// The unrolled calls are here and not in generated code. Otherwise rustc would check every call of every system, even if Taylor series are not used.
#[inline(always)]
pub fn orders<const UNROLLED: usize, const P: usize>(series: &mut impl Series) {
    macro_rules! unrolled {
        ($($n:literal)*) => {
            $(if $n < P && $n <= UNROLLED { series.order($n); })*
            for n in UNROLLED.min([$($n),*].len()) + 1..P {
                series.order(n);
            }
        };
    }
    unrolled!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31);
}

/// Computes the coefficients of the orders 1 ≤ n < P. All orders have code of their own if P ≤ `UNROLLED` + 1, otherwise none.
#[inline(always)]
pub fn all_orders<const UNROLLED: usize, const P: usize>(series: &mut impl Series) {
    if P <= UNROLLED + 1 {
        orders::<UNROLLED, P>(series);
    } else {
        orders::<0, P>(series);
    }
}

/// Returns an order as a scalar. The conversion of signed integers is a single instruction.
#[inline(always)]
pub fn whole<R: Real>(n: usize) -> R {
    R::from_f64(f64::from(n as i32))
}

/// Returns one over an order.
#[inline(always)]
pub fn inverse<R: Real>(n: usize) -> R {
    R::from_f64(1.0 / f64::from(n as i32))
}

/// Returns a·b + c, entry by entry.
#[inline(always)]
fn fused<A: Array>(a: A, b: A, mut c: A) -> A {
    if A::LEN == 1 {
        // No loop for one number: a loop changes the order of statements, and the vectoriser then pairs distant values.
        c.as_mut_slice()[0] = a.as_slice()[0].multiply_add(b.as_slice()[0], c.as_slice()[0]);
        return c;
    }
    for (c, (a, b)) in c.as_mut_slice().iter_mut().zip(a.as_slice().iter().zip(b.as_slice())) {
        *c = a.multiply_add(*b, *c);
    }
    c
}

/// Returns x·y, entry by entry.
#[inline(always)]
fn times<A: Array>(mut x: A, y: A) -> A {
    for (x, y) in x.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *x *= *y;
    }
    x
}

/// Returns x + y.
#[inline(always)]
fn plus<A: Array>(mut x: A, y: A) -> A {
    for (x, y) in x.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *x += *y;
    }
    x
}

/// Returns x/y, entry by entry.
#[inline(always)]
fn divided<A: Array>(mut x: A, y: A) -> A {
    for (x, y) in x.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *x /= *y;
    }
    x
}

/// Returns 1 − w·x for x ≈ 1/w. The rounding error of the product is included.
#[inline(always)]
fn remainder<A: Array>(w: A, mut x: A) -> A {
    for (x, w) in x.as_mut_slice().iter_mut().zip(w.as_slice()) {
        let (product, rounding_error) = exact_product(*w, *x);
        *x = (A::Real::from_f64(1.0) - product) - rounding_error;
    }
    x
}

/// Returns −x.
#[inline(always)]
fn negative<A: Array>(mut x: A) -> A {
    for x in x.as_mut_slice() {
        *x = -*x;
    }
    x
}

/// Returns c·x.
#[inline(always)]
pub fn scaled<A: Array>(c: A::Real, mut x: A) -> A {
    for x in x.as_mut_slice() {
        *x *= c;
    }
    x
}

/// Aligns adjacent coefficients for loads of four numbers, independent of the alignment of the stack.
#[repr(align(32))]
#[derive(Debug)]
pub struct Aligned<T>(pub T);

/// Returns the coefficients uⱼ and uₙ₋ⱼ for 0 < j < n/2, both in ascending order.
#[inline(always)]
fn halves<A, const P: usize>(u: &[A; P], n: usize) -> [&[A]; 2] {
    let pairs = (n - 1) / 2;
    [&u[1..][..pairs], &u[n / 2 + 1..][..pairs]]
}

/// Returns the coefficients uⱼ and uₙ₋ⱼ for 1 < j < n/2, both in ascending order.
#[inline(always)]
fn inner_halves<A, const P: usize>(u: &[A; P], n: usize) -> [&[A]; 2] {
    let pairs = ((n - 1) / 2).saturating_sub(1);
    [&u[2.min(P)..][..pairs], &u[n / 2 + 1..][..pairs]]
}

/// Returns the pairs (uⱼ, uₙ₋ⱼ) for 0 < j < n/2, from the middle outwards.
#[inline(always)]
fn outward<A, const P: usize>(u: &[A; P], n: usize) -> impl Iterator<Item = (&A, &A)> {
    let [low, high] = halves(u, n);
    low.iter().rev().zip(high)
}

/// Calls `take` with uⱼ, uₙ₋ⱼ and wⱼ, wₙ₋ⱼ for 0 < j < n/2, from the middle outwards.
#[inline(always)]
fn both<A: Array, const P: usize>([u, w]: [&[A; P]; 2], n: usize, mut take: impl FnMut([&A; 2], [&A; 2])) {
    if A::LEN == 1 {
        // For scalars, iterators are faster than indices.
        for ((uj, ui), (wj, wi)) in outward(u, n).zip(outward(w, n)) {
            take([uj, ui], [wj, wi]);
        }
    } else {
        // For arrays, one counter serves all four slices. Iterators in both directions would need two.
        let ([uj, ui], [wj, wi]) = (halves(u, n), halves(w, n));
        for i in 0..uj.len() {
            let j = uj.len() - 1 - i;
            take([&uj[j], &ui[i]], [&wj[j], &wi[i]]);
        }
    }
}

/// Returns Σ uⱼwₙ₋ⱼ over 0 < j < n, for one sum or several side by side.
#[inline(always)]
pub fn sum<A: Array, const P: usize>(u: &[A; P], w: &[A; P], n: usize) -> A {
    let (mut first, mut second) = (A::zero(), A::zero());
    if n.is_multiple_of(2) {
        first = times(u[n / 2], w[n / 2]);
    }
    both([u, w], n, |[uj, ui], [wj, wi]| {
        first = fused(*uj, *wi, first);
        second = fused(*ui, *wj, second);
    });
    plus(first, second)
}

/// Returns Σ uⱼwₙ₋ⱼ over 0 < j < n, for several sums side by side. Takes uₙ₋₁ and wₙ₋₁ as values just computed. Precondition: they are 0 for n = 1.
#[inline(always)]
pub fn sum_with_newest<A: Array, const P: usize>(u: &[A; P], w: &[A; P], [un, wn]: [A; 2], n: usize) -> A {
    let (mut first, mut second) = (A::zero(), A::zero());
    if n > 2 && n.is_multiple_of(2) {
        first = times(u[n / 2], w[n / 2]);
    }
    // The terms with the newest coefficients, of orders 1 and n − 1, come last.
    let ([uj, ui], [wj, wi]) = (inner_halves(u, n), inner_halves(w, n));
    for i in 0..uj.len() {
        let j = uj.len() - 1 - i;
        first = fused(uj[j], wi[i], first);
        second = fused(ui[i], wj[j], second);
    }
    if P > 1 {
        first = fused(u[1], wn, first);
        if n > 2 {
            second = fused(un, w[1], second);
        }
    }
    plus(first, second)
}

/// Returns Σ uⱼuₙ₋ⱼ over 0 < j < n and over all u.
#[inline(always)]
pub fn sum_of_squares<A: Array, const P: usize, const K: usize>(all: [&[A; P]; K], n: usize) -> A {
    // Each u has a partial sum of its own that starts in the middle. The newest coefficients then enter last in all of them.
    let mut half = A::nothing();
    for u in all {
        let mut own = A::zero();
        if n.is_multiple_of(2) {
            own = times(scaled(A::Real::from_f64(0.5), u[n / 2]), u[n / 2]);
        }
        for (uj, ui) in outward(u, n) {
            own = fused(*uj, *ui, own);
        }
        half = plus(half, own);
    }
    plus(half, half)
}

/// Returns Σ (j(α + 1) − n)uⱼyₙ₋ⱼ over 0 < j < n. `next` is α + 1.
#[inline(always)]
pub fn sum_of_power<A: Array, const P: usize>(u: &[A; P], y: &[A; P], next: A::Real, n: usize) -> A {
    let (whole, one) = (whole::<A::Real>, A::Real::from_f64(1.0));
    let factor = |j: A::Real| j.multiply_add(next, -whole(n));
    let (mut first, mut second) = (A::zero(), A::zero());
    if n.is_multiple_of(2) {
        first = scaled(factor(whole(n / 2)), times(u[n / 2], y[n / 2]));
    }
    // Orders are counted as scalars, because converting an integer takes as long as a term of the sum.
    let mut low = whole(n.div_ceil(2)) - one;
    let mut high = whole(n) - low;
    both([u, y], n, |[uj, ui], [yj, yi]| {
        first = fused(scaled(factor(low), *uj), *yi, first);
        second = fused(scaled(factor(high), *ui), *yj, second);
        low -= one;
        high += one;
    });
    plus(first, second)
}

/// Returns the coefficient of order n ≥ 1 of a + b·t, with the slope b.
#[inline(always)]
pub fn affine<R: Real>(slope: R, n: usize) -> R {
    if n == 1 { slope } else { zero() }
}

/// Returns the coefficient of order n of u·w, from u₀, w₀, uₙ, wₙ and Σ uⱼwₙ₋ⱼ.
#[inline(always)]
pub fn product<A: Array>([u, w]: [A; 2], [un, wn]: [A; 2], sum: A) -> A {
    fused(u, wn, fused(un, w, sum))
}

/// Returns the coefficient of order n of Σ u², from all u₀, all uₙ and the sum.
#[inline(always)]
pub fn squares<A: Array, const K: usize>(u: [A; K], un: [A; K], mut sum: A) -> A {
    for (u, un) in u.into_iter().zip(un) {
        sum = fused(plus(u, u), un, sum);
    }
    sum
}

/// Returns yₙ for y·w = u, from w₀, y₀, 1/w₀, uₙ, wₙ and the sum.
#[inline(always)]
pub fn quotient<A: Array>([w, y, over]: [A; 3], [un, wn]: [A; 2], sum: A) -> A {
    let low = times(over, remainder(w, over));
    let rest = fused(sum, over, times(sum, low));
    fused(un, over, fused(negative(times(y, over)), wn, negative(rest)))
}

/// Returns yₙ for y·w = 1, from w₀, y₀, wₙ and the sum.
#[inline(always)]
pub fn reciprocal<A: Array>([w, y]: [A; 2], wn: A, sum: A) -> A {
    fused(negative(times(y, y)), wn, negative(divided(sum, w)))
}

/// Returns yₙ for y² = u, from y₀, 1/(2y₀), uₙ and the sum.
#[inline(always)]
pub fn root<A: Array>([y, over]: [A; 2], un: A, sum: A) -> A {
    fused(un, over, negative(divided(sum, plus(y, y))))
}

/// Returns yₙ for y'·u = α·y·u', from u₀, α·y₀/u₀, uₙ and the sum.
#[inline(always)]
pub fn power<A: Array>([u, ratio]: [A; 2], un: A, sum: A, n: usize) -> A {
    // This reciprocal is not on the critical path, and its rounding error differs at each order.
    let mut over = scaled(whole(n), u);
    over.as_mut_slice().iter_mut().for_each(|x| *x = A::Real::from_f64(1.0) / *x);
    fused(un, ratio, times(sum, over))
}

/// Returns yₙ for y' = d·u', from d₀, uₙ and the sum with j·uⱼ.
#[inline(always)]
pub fn integral<A: Array>(d: A, un: A, sum: A, n: usize) -> A {
    fused(un, d, scaled(inverse(n), sum))
}

/// Returns yₙ for y'·d = u', from d₀, 1/d₀, uₙ and the sum with j·yⱼ.
#[inline(always)]
pub fn quadrature<A: Array>([d, over]: [A; 2], un: A, sum: A, n: usize) -> A {
    fused(un, over, negative(divided(sum, scaled(whole(n), d))))
}

/// Returns aₙ for the angle a of the point (x, y), with r²a' = x·y' − y·x'. Arguments: y₀, x₀, r₀², 1/r₀², yₙ, xₙ, and the sums of j·yⱼ with x, of
/// j·xⱼ with y and of j·aⱼ with r².
#[inline(always)]
pub fn angle<R: Real>([y, x, square, over]: [R; 4], [yn, xn]: [R; 2], [first, second, third]: [R; 3], n: usize) -> R {
    let last = yn.multiply_add(x, -(xn * y));
    last.multiply_add(over, (first - second - third) / (whole::<R>(n) * square))
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::{vec, vec::Vec};

    /// Records the orders in the sequence of the calls.
    struct Asked(Vec<usize>);

    impl Series for Asked {
        fn order(&mut self, n: usize) {
            self.0.push(n);
        }
    }

    fn asked(orders: impl FnOnce(&mut Asked)) -> Vec<usize> {
        let mut series = Asked(vec![]);
        orders(&mut series);
        series.0
    }

    #[test]
    fn every_order_comes_once_and_in_turn() {
        let first = |p: usize| (1..p).collect::<Vec<usize>>();
        // P − 1 larger than, equal to and smaller than the number of unrolled orders, and no order at all.
        assert_eq!(asked(orders::<3, 9>), first(9));
        assert_eq!(asked(orders::<3, 4>), first(4));
        assert_eq!(asked(orders::<7, 4>), first(4));
        assert_eq!(asked(orders::<7, 1>), first(1));
        assert_eq!(asked(all_orders::<3, 9>), first(9));
        assert_eq!(asked(all_orders::<3, 4>), first(4));
        assert_eq!(asked(all_orders::<7, 4>), first(4));
        assert_eq!(asked(all_orders::<0, 4>), first(4));
    }
}
