//! Coefficients of order n ≥ 1 of a series from those of its operands, for the kernels that are emitted.
//!
//! Coefficients are normalised: u⁽ⁿ⁾/n!. Sums Σ uⱼwₙ₋ⱼ begin in the middle, with coefficients that are known for long, in two chains,
//! and those of order n come last: then each operation adds one multiplication to what a next coefficient waits for. With j from 0 on
//! the double pendulum takes four times as long.
//!
//! What is divided by at every order is divided by: the rounding of a reciprocal, made once, would count n times. It may be multiplied with
//! the coefficient of order n, which is smaller and must not wait.
//!
//! R. E. Moore, *Interval Analysis* (1966) ch. 11; À. Jorba & M. Zou, Exp. Math. 14 (2005) 99; for powers see also R. D. Neidinger,
//! SIAM Rev. 52 (2010) 545.

use crate::scalar::{Real, zero};
use crate::space::Array;

/// Series whose coefficients follow from those of lower orders.
pub trait Series {
    /// The coefficients of order n ≥ 1, from all before.
    fn order(&mut self, n: usize);
}

/// The coefficients of the orders 1 ≤ n < P; those up to `UNROLLED` each in code of its own, where sums have a known length.
///
/// Here and not in what is emitted, where rustc would check every call of every system, whether Taylor series are used or not.
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

/// An order as a scalar. Processors convert numbers with a sign in one operation.
#[inline(always)]
pub fn whole<R: Real>(n: usize) -> R {
    R::from_f64(f64::from(n as i32))
}

/// One over an order.
#[inline(always)]
pub fn inverse<R: Real>(n: usize) -> R {
    R::from_f64(1.0 / f64::from(n as i32))
}

/// a·b + c, entry by entry.
#[inline(always)]
fn fused<A: Array>(a: A, b: A, mut c: A) -> A {
    for (c, (a, b)) in c.as_mut_slice().iter_mut().zip(a.as_slice().iter().zip(b.as_slice())) {
        *c = a.multiply_add(*b, *c);
    }
    c
}

/// x·y, entry by entry.
#[inline(always)]
fn times<A: Array>(mut x: A, y: A) -> A {
    for (x, y) in x.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *x *= *y;
    }
    x
}

/// x + y.
#[inline(always)]
fn plus<A: Array>(mut x: A, y: A) -> A {
    for (x, y) in x.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *x += *y;
    }
    x
}

/// c·x.
#[inline(always)]
fn scaled<A: Array>(c: A::Real, mut x: A) -> A {
    for x in x.as_mut_slice() {
        *x *= c;
    }
    x
}

/// Coefficients that are side by side begin where four numbers are read at once, wherever the stack begins.
#[repr(align(32))]
#[derive(Debug)]
pub struct Aligned<T>(pub T);

/// The pairs uⱼ, uₙ₋ⱼ for 0 < j < n/2 from the middle on; without indices that would be checked.
#[inline(always)]
fn outward<A, const P: usize>(u: &[A; P], n: usize) -> impl Iterator<Item = (&A, &A)> {
    let (low, high) = u[1..n].split_at(n.div_ceil(2) - 1);
    let middle = high.len() - low.len();
    low.iter().rev().zip(&high[middle..])
}

/// Σ uⱼwₙ₋ⱼ over 0 < j < n, of one sum or of many side by side.
#[inline(always)]
pub fn sum<A: Array, const P: usize>(u: &[A; P], w: &[A; P], n: usize) -> A {
    let (mut first, mut second) = (A::zero(), A::zero());
    if n.is_multiple_of(2) {
        first = times(u[n / 2], w[n / 2]);
    }
    for ((uj, ui), (wj, wi)) in outward(u, n).zip(outward(w, n)) {
        first = fused(*uj, *wi, first);
        second = fused(*ui, *wj, second);
    }
    plus(first, second)
}

/// Σ uⱼuₙ₋ⱼ over 0 < j < n and over all u.
#[inline(always)]
pub fn sum_of_squares<A: Array, const P: usize, const K: usize>(all: [&[A; P]; K], n: usize) -> A {
    // Each begins in its own middle: what is known last comes last in all of them.
    let mut half = A::nothing();
    for u in all {
        let mut own = A::zero();
        for (uj, ui) in outward(u, n) {
            own = fused(*uj, *ui, own);
        }
        half = plus(half, own);
    }
    let mut double = plus(half, half);
    if n.is_multiple_of(2) {
        for u in all {
            double = fused(u[n / 2], u[n / 2], double);
        }
    }
    double
}

/// Σ (j(α + 1) − n)uⱼyₙ₋ⱼ over 0 < j < n, from α + 1.
#[inline(always)]
pub fn sum_of_power<A: Array, const P: usize>(u: &[A; P], y: &[A; P], next: A::Real, n: usize) -> A {
    let (whole, one) = (whole::<A::Real>, A::Real::from_f64(1.0));
    let factor = |j: A::Real| j.multiply_add(next, -whole(n));
    let (mut first, mut second) = (A::zero(), A::zero());
    if n.is_multiple_of(2) {
        first = scaled(factor(whole(n / 2)), times(u[n / 2], y[n / 2]));
    }
    // Orders are counted as scalars: each conversion would take as long as what it is for.
    let mut low = whole(n.div_ceil(2)) - one;
    let mut high = whole(n) - low;
    for ((uj, ui), (yj, yi)) in outward(u, n).zip(outward(y, n)) {
        first = fused(scaled(factor(low), *uj), *yi, first);
        second = fused(scaled(factor(high), *ui), *yj, second);
        low -= one;
        high += one;
    }
    plus(first, second)
}

/// Of a function a + b·t.
#[inline(always)]
pub fn affine<R: Real>(slope: R, n: usize) -> R {
    if n == 1 { slope } else { zero() }
}

/// u·w, from u₀, w₀, uₙ, wₙ and the sum.
#[inline(always)]
pub fn product<R: Real>([u, w]: [R; 2], [un, wn]: [R; 2], sum: R) -> R {
    u.multiply_add(wn, un.multiply_add(w, sum))
}

/// Σ u², from all u₀, all uₙ and the sum.
#[inline(always)]
pub fn squares<R: Real, const K: usize>(u: [R; K], un: [R; K], mut sum: R) -> R {
    for (u, un) in u.into_iter().zip(un) {
        sum = (u + u).multiply_add(un, sum);
    }
    sum
}

/// y with y·w = u, from w₀, y₀, 1/w₀, uₙ, wₙ and the sum.
#[inline(always)]
pub fn quotient<R: Real>([w, y, over]: [R; 3], [un, wn]: [R; 2], sum: R) -> R {
    un.multiply_add(over, (-(y * over)).multiply_add(wn, -(sum / w)))
}

/// y with y·w = 1, from w₀, y₀, wₙ and the sum.
#[inline(always)]
pub fn reciprocal<R: Real>([w, y]: [R; 2], wn: R, sum: R) -> R {
    (-(y * y)).multiply_add(wn, -(sum / w))
}

/// y with y² = u, from y₀, 1/(2y₀), uₙ and the sum.
#[inline(always)]
pub fn root<R: Real>([y, over]: [R; 2], un: R, sum: R) -> R {
    un.multiply_add(over, -(sum / (y + y)))
}

/// y with y'·u = α·y·u', from u₀, α·y₀/u₀, uₙ and the sum.
#[inline(always)]
pub fn power<R: Real>([u, ratio]: [R; 2], un: R, sum: R, n: usize) -> R {
    un.multiply_add(ratio, sum / (whole::<R>(n) * u))
}

/// y with y' = d·u', from d₀, uₙ and the sum with j·uⱼ.
#[inline(always)]
pub fn integral<R: Real>(d: R, un: R, sum: R, n: usize) -> R {
    un.multiply_add(d, sum * inverse(n))
}

/// y with y'·d = u', from d₀, 1/d₀, uₙ and the sum with j·yⱼ.
#[inline(always)]
pub fn quadrature<R: Real>([d, over]: [R; 2], un: R, sum: R, n: usize) -> R {
    un.multiply_add(over, -(sum / (whole::<R>(n) * d)))
}

/// The angle a of the point (x, y), with r²a' = x·y' − y·x', from y₀, x₀, r₀², 1/r₀², yₙ, xₙ and the sums of j·yⱼ with x, of j·xⱼ with y and of
/// j·aⱼ with r².
#[inline(always)]
pub fn angle<R: Real>([y, x, square, over]: [R; 4], [yn, xn]: [R; 2], [first, second, third]: [R; 3], n: usize) -> R {
    let last = yn.multiply_add(x, -(xn * y));
    last.multiply_add(over, (first - second - third) / (whole::<R>(n) * square))
}
