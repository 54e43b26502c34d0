//! Finds all roots of a polynomial in (0, 1], in ascending order.
//!
//! In the Bernstein basis, the number of sign changes of the coefficients equals the number of roots, or exceeds it by an even number. An interval
//! with one sign change has one root, which a safeguarded Newton iteration finds. Other intervals are halved.

use crate::space::Array;

/// Maximum number of coefficients of a polynomial.
pub(crate) const MOST: usize = 33;

/// Maximum number of halvings of an interval. Two roots are then closer than 10⁻⁷.
const DEEPEST: u32 = 24;

/// Roots of a function, such as a polynomial, and its sign before the first one. `P` has room for all roots.
#[derive(Clone, Copy, Debug)]
pub struct Roots<P: Array<Real = f64> = [f64; MOST]> {
    roots: P,
    len: usize,
    /// Sign before all roots. Zero for the zero polynomial, and for coefficients that are not finite.
    pub(crate) sign: f64,
}

impl<P: Array<Real = f64>> Roots<P> {
    /// Returns no roots of a function with this sign.
    pub(crate) fn none(sign: f64) -> Self {
        Roots { roots: P::zero(), len: 0, sign }
    }

    /// Adds a root behind the others.
    pub(crate) fn push(&mut self, root: f64) {
        if self.len < P::LEN {
            self.roots.as_mut_slice()[self.len] = root;
            self.len += 1;
        }
    }

    /// Returns the roots in ascending order. The function changes sign at each of them.
    pub(crate) fn as_slice(&self) -> &[f64] {
        &self.roots.as_slice()[..self.len]
    }

    /// Returns all roots, each replaced by a number.
    pub(crate) fn map(mut self, replaced: impl Fn(f64) -> f64) -> Self {
        self.roots.as_mut_slice()[..self.len].iter_mut().for_each(|root| *root = replaced(*root));
        self
    }

    /// Removes the first root. The function has the sign after this root from the start.
    pub(crate) fn without_first(mut self) -> Self {
        self.roots.as_mut_slice().copy_within(1..self.len, 0);
        Roots { len: self.len - 1, sign: -self.sign, ..self }
    }

    /// Joins the roots to an earlier interval, at whose end the function has the sign `side`. A change of sign at 0 becomes a root. If `side` is
    /// zero, the function was zero there, and no root is added.
    pub(crate) fn behind(mut self, side: f64) -> Self {
        if self.sign * side < 0.0 && self.len < P::LEN {
            let roots = self.roots.as_mut_slice();
            roots.copy_within(..self.len, 1);
            (roots[0], self.len) = (0.0, self.len + 1);
        }
        Roots { sign: if side == 0.0 { self.sign } else { side }, ..self }
    }

    /// Removes pairs of neighbouring roots if |Σ gₖτᵏ| midway between them is at most `rounding`. A flat zero produces such pairs.
    pub(crate) fn without_pairs(mut self, g: &[f64], rounding: f64) -> Self {
        let value = |at: f64| g.iter().rev().fold(0.0, |sum, g| sum * at + g);
        let (roots, mut kept) = (self.roots.as_mut_slice(), 0);
        for i in 0..self.len {
            let root = roots[i];
            if kept > 0 && value(0.5 * (roots[kept - 1] + root)).abs() <= rounding {
                kept -= 1;
            } else {
                roots[kept] = root;
                kept += 1;
            }
        }
        Roots { len: kept, ..self }
    }

    /// Returns the roots, each with the sign after it.
    pub(crate) fn changes(&self) -> impl Iterator<Item = (f64, f64)> {
        let mut sign = self.sign;
        self.as_slice().iter().map(move |at| {
            sign = -sign;
            (*at, sign)
        })
    }

    /// Returns the sign after all roots.
    pub(crate) fn end(&self) -> f64 {
        if self.len % 2 == 1 { -self.sign } else { self.sign }
    }
}

/// Returns the roots of Σ gₖτᵏ in (0, 1].
///
/// If g₀ is not larger than the rounding of the polynomial or `noise`, it counts as a root at 0, which is not returned.
#[inline]
pub(crate) fn roots(g: &[f64], noise: f64) -> Roots {
    let rest: f64 = g[1..].iter().map(|g| g.abs()).sum();
    // Fast exit for most steps: g₀ exceeds the sum of the other terms, so there is no root.
    if g[0].abs() > rest && g[0].abs() > noise {
        return Roots::none(g[0].signum());
    }
    if !(rest > 0.0 && g[0].abs() + rest < f64::INFINITY) {
        return Roots::none(0.0);
    }
    isolate(g, (8.0 * f64::EPSILON * rest).max(noise))
}

/// An interval, and the coefficients of the polynomial on it in the Bernstein basis.
#[derive(Clone, Copy)]
struct Piece {
    from: f64,
    width: f64,
    depth: u32,
    b: [f64; MOST],
}

#[inline(never)]
fn isolate(g: &[f64], small: f64) -> Roots {
    // Divide out the roots at 0, and drop zero coefficients of the highest orders.
    let mut g = if g[0].abs() <= small { &g[1..] } else { g };
    while let [zero, later @ ..] = g
        && *zero == 0.0
    {
        g = later;
    }
    while let [earlier @ .., zero] = g
        && *zero == 0.0
    {
        g = earlier;
    }
    let mut found = Roots::none(g.first().map_or(0.0, |g| g.signum()));
    let n = g.len().min(MOST);
    if n < 2 {
        return found;
    }
    let mut pieces = [Piece { from: 0.0, width: 1.0, depth: 0, b: bernstein(&g[..n]) }; DEEPEST as usize + 2];
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let piece = pieces[open];
        let changes = changes(&piece.b[..n]);
        // Sign before the next root.
        let sign = found.end();
        let end = piece.b[n - 1];
        match changes {
            0 if end == 0.0 || end.signum() == sign => {}
            // A root at the joint of two intervals, or one hidden by rounding.
            0 => found.push(piece.from),
            1 => found.push(solve(g, piece, sign)),
            _ if piece.depth == DEEPEST => {
                if end != 0.0 && end.signum() != sign {
                    found.push(piece.from + 0.5 * piece.width);
                }
            }
            _ => {
                let [left, right] = halves(piece, n);
                (pieces[open], pieces[open + 1]) = (right, left);
                open += 2;
            }
        }
    }
    found
}

/// Returns the coefficients of Σ gₖτᵏ in the Bernstein basis on [0, 1].
fn bernstein(g: &[f64]) -> [f64; MOST] {
    let (mut b, n) = ([0.0; MOST], g.len() - 1);
    let mut binomial = 1.0;
    for (k, g) in g.iter().enumerate() {
        b[k] = g / binomial;
        binomial *= (n - k) as f64 / (k + 1) as f64;
    }
    for first in 1..=n {
        for i in (first..=n).rev() {
            b[i] += b[i - 1];
        }
    }
    b
}

/// Returns the number of sign changes. Zeros are ignored.
fn changes(b: &[f64]) -> usize {
    let (mut count, mut last) = (0, 0.0);
    for b in b.iter().filter(|b| **b != 0.0) {
        count += usize::from(last * b.signum() < 0.0);
        last = b.signum();
    }
    count
}

/// Returns both halves of an interval, by de Casteljau's algorithm.
fn halves(piece: Piece, n: usize) -> [Piece; 2] {
    let (width, depth) = (0.5 * piece.width, piece.depth + 1);
    let mut left = Piece { from: piece.from, width, depth, b: piece.b };
    let mut right = Piece { from: piece.from + width, width, depth, b: piece.b };
    for k in 1..n {
        for i in 0..n - k {
            right.b[i] = 0.5 * (right.b[i] + right.b[i + 1]);
        }
        left.b[k] = right.b[0];
    }
    // Each round overwrites one coefficient more, so the array finally holds the right half.
    [left, right]
}

/// Returns the only root in an interval. `sign`: sign of the polynomial before it.
fn solve(g: &[f64], piece: Piece, sign: f64) -> f64 {
    let (mut low, mut high) = (piece.from, piece.from + piece.width);
    let mut x = 0.5 * (low + high);
    for _ in 0..100 {
        let (mut value, mut slope) = (0.0, 0.0);
        for g in g.iter().rev() {
            slope = slope * x + value;
            value = value * x + g;
        }
        if value * sign > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= f64::EPSILON * x || value == 0.0 {
            return if value == 0.0 { x } else { next };
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use alloc::vec;
    use alloc::vec::Vec;

    use super::*;

    /// Returns q·Π (τ − root) for given roots. The factor q has no real roots.
    fn polynomial(roots: &[f64], degree: usize, noise: &mut impl FnMut() -> f64) -> Vec<f64> {
        let mut g = vec![1.0];
        let times = |g: &[f64], a: f64, b: f64, c: f64| {
            let mut product = vec![0.0; g.len() + 2];
            for (i, g) in g.iter().enumerate() {
                product[i] += a * g;
                product[i + 1] += b * g;
                product[i + 2] += c * g;
            }
            while product.last() == Some(&0.0) {
                product.pop();
            }
            product
        };
        for root in roots {
            g = times(&g, -root, 1.0, 0.0);
        }
        while g.len() + 2 <= degree + 1 {
            // A negative discriminant: no real root.
            let (a, b) = (1.0 + noise(), 0.6 * (noise() - 0.5));
            g = times(&g, a, b, 0.3 + 0.4 * noise());
        }
        g
    }

    #[test]
    fn no_root_is_missed() {
        let mut state = 7_u64;
        let mut noise = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut worst, mut worst_pair) = (0.0_f64, 0.0_f64);
        for i in 0..20_000 {
            let count = i % 4;
            let mut expected: Vec<f64> = (0..count).map(|_| 0.02 + 0.96 * noise()).collect();
            let pair = i % 8 == 6;
            if pair {
                expected[1] = expected[0] + 1e-5;
            }
            expected.sort_by(f64::total_cmp);
            if !pair && expected.windows(2).any(|w| w[1] - w[0] < 1e-3) {
                continue;
            }
            let g = polynomial(&expected, 20, &mut noise);
            let found = roots(&g, 0.0);
            assert_eq!(found.as_slice().len(), expected.len(), "{expected:?} {:?}", found.as_slice());
            for (found, expected) in found.as_slice().iter().zip(&expected) {
                let error = (found - expected).abs();
                let slope: f64 = (1..g.len()).map(|k| k as f64 * g[k] * expected.powi(k as i32 - 1)).sum();
                let scale: f64 = g.iter().enumerate().map(|(k, g)| g.abs() * expected.powi(k as i32)).sum();
                if pair {
                    worst_pair = worst_pair.max(error);
                }
                worst = worst.max(error * slope.abs() / scale);
            }
        }
        assert!(worst < 4e-15, "{worst:e}");
        assert!(worst_pair < 1e-9, "{worst_pair:e}");
    }

    #[test]
    fn roots_at_the_ends() {
        // τ(τ − 1/2): the root at 0 is not counted.
        let found = roots(&[0.0, -0.5, 1.0], 0.0);
        assert_eq!((found.as_slice(), found.sign), (&[0.5][..], -1.0));
        let found = roots(&[1e-18, -0.5, 1.0], 0.0);
        assert_eq!((found.as_slice(), found.sign), (&[0.5][..], -1.0));
        // 1 − τ has not changed sign at the end.
        assert_eq!(roots(&[1.0, -1.0], 0.0).as_slice(), []);
        assert_eq!(roots(&[1.0, -0.999], 0.0).as_slice(), []);
        assert_eq!(roots(&[0.0, 0.0, 0.0], 0.0).sign, 0.0);
        assert_eq!(roots(&[f64::NAN, 1.0], 0.0).as_slice(), []);
        let mut fall = [0.0; 20];
        (fall[1], fall[2]) = (357.0, -48612.0);
        let found = roots(&fall, 0.0);
        assert_eq!((found.as_slice().len(), found.sign), (1, 1.0));
        assert!((found.as_slice()[0] - 357.0 / 48612.0).abs() < 1e-17);
        // Changes of sign relative to an earlier interval, and pairs of roots within rounding.
        let found = roots(&fall, 0.0).behind(-1.0);
        assert_eq!((found.as_slice().len(), found.as_slice()[0], found.sign, found.end()), (2, 0.0, -1.0, -1.0));
        assert_eq!(roots(&fall, 0.0).behind(0.0).sign, 1.0);
        let near = |apart: f64| roots(&[0.09 - apart * apart, -0.6, 1.0], 0.0);
        let left = |apart: f64| near(apart).without_pairs(&[0.09 - apart * apart, -0.6, 1.0], 1e-15).len;
        assert_eq!((left(1e-6), near(2.5e-8).len, left(2.5e-8)), (2, 2, 0));
        // A double root does not change the sign.
        assert_eq!(roots(&[0.25, -1.0, 1.0], 0.0).as_slice(), []);
    }
}
