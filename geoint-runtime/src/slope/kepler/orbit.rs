//! Universal variables: the orbits of every energy by one set of formulas, without branches.
//!
//! Operations wait for each other: what is known early is combined first.

use crate::scalar::{Real, zero};
use crate::slope::{factorial, series};

/// What the motion along an orbit follows from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orbit<R> {
    /// The distance at the start, and 1 over it.
    pub(super) r: R,
    pub(super) recip: R,
    /// q·v at the start.
    pub(super) eta: R,
    /// −2 E: positive for ellipses.
    pub(super) beta: R,
    /// μ − βr.
    pub(super) zeta: R,
    pub(super) mu: R,
    pub(super) h: R,
}

/// How far X is from where it should be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Correction<R> {
    /// Newton's: small only where X is right, while the other one may vanish anywhere.
    pub(super) newton: R,
    /// Of order 6.
    pub(super) change: R,
}

/// The functions G₀, …, G₃ at X: Gₖ' = Gₖ₋₁, G₁ = X − …, G₀'' = −βG₀.
#[derive(Clone, Copy, Debug)]
pub(super) struct Functions<R>(pub(super) [R; 4]);

/// |β|X² up to which the series of G₂ and G₃ have all digits: 2.4 rad of an ellipse.
pub(super) const RADIUS: f64 = 6.0;

/// Plain numbers.
#[inline(always)]
fn number<R: Real>(x: f64) -> R {
    R::from_f64(x)
}

/// Σ cₖ zᵏ for k < 12 by halves of halves: less operations wait for each other than in Horner's rule.
#[inline(always)]
fn polynomial<R: Real>(z: R, c: &[f64; 12]) -> R {
    let square = z * z;
    let fourth = square * square;
    let two = |k: usize| z.multiply_add(number(c[k + 1]), number(c[k]));
    let four = |k: usize| square.multiply_add(two(k + 2), two(k));
    (fourth * fourth).multiply_add(four(8), fourth.multiply_add(four(4), four(0)))
}

impl<R: Real> Orbit<R> {
    /// Of |q|², q·v, v², μ and h.
    #[inline(always)]
    pub(super) fn new([square, eta, speed, mu, h]: [R; 5]) -> Self {
        let r = square.sqrt();
        let recip = number::<R>(1.0) / r;
        let beta = (mu + mu).multiply_add(recip, -speed);
        Orbit { r, recip, eta, beta, zeta: (-beta).multiply_add(r, mu), mu, h }
    }

    /// The functions G at X, for |β|X² up to [`RADIUS`].
    #[inline(always)]
    pub(super) fn functions(&self, x: R) -> Functions<R> {
        let square = x * x;
        let z = -(self.beta * square);
        // Without the digits that 1/6 is rounded by, every G₃ is too small, and a million steps gain energy.
        let sixth = 1.0 / 6.0;
        let tail = sixth - crate::scalar::signed(number::<R>(sixth)) + 9.25185853854297e-18;
        let rest = polynomial(z, series!(12, |k| 1.0 / factorial(2 * k + 5)));
        let c3 = number::<R>(sixth) + z.multiply_add(rest, number(tail));
        let c2 = polynomial(z, series!(12, |k| 1.0 / factorial(2 * k + 2)));
        Functions([z.multiply_add(c2, number(1.0)), (z * x).multiply_add(c3, x), square * c2, square * x * c3])
    }

    /// How far X has to go for a time `late`, up to order 6, by the derivatives of time: 1 over the first one, the second, the third. Each
    /// later one is −β times the one two before.
    #[inline(always)]
    fn correction_by(&self, late: R, [recip, second, third]: [R; 3]) -> Correction<R> {
        let (w, a, b) = (late * recip, second * recip, third * recip);
        let (square, by_a, by_w) = (a * a, w * a, w * w);
        // The coefficients of w¹ … w⁵ in the inverse of w = d + a d²/2 + b d³/6 − βa d⁴/24 − βb d⁵/120, without powers of a in front.
        let first = by_a.multiply_add(number(-0.5), number(1.0));
        let third = square.multiply_add(number(0.5), b * number(-1.0 / 6.0));
        let beta = self.beta * number(1.0 / 24.0);
        let fourth = square.multiply_add(number(-0.625), b.multiply_add(number(5.0 / 12.0), beta));
        let fifth = square.multiply_add(
            (square - b).multiply_add(number(0.875), self.beta * number(-0.125)),
            b * b.multiply_add(number(1.0 / 12.0), beta * number(0.2)),
        );
        let later = by_w.multiply_add(fifth, by_a.multiply_add(fourth, third));
        Correction { newton: w, change: w * by_w.multiply_add(later, first) }
    }

    /// X from the series of time at the start.
    #[inline(always)]
    pub(super) fn first_guess(&self) -> R {
        self.correction_by(self.h, [self.recip, self.eta, self.zeta]).change
    }

    /// The time that is left of h at X.
    #[inline(always)]
    pub(super) fn late(&self, x: R, Functions([_, _, g2, g3]): &Functions<R>) -> R {
        let straight = (-self.r).multiply_add(x, self.h);
        (-self.zeta).multiply_add(*g3, (-self.eta).multiply_add(*g2, straight))
    }

    /// By how much X is too small, for the functions at X.
    #[inline(always)]
    pub(super) fn correction(&self, x: R, g: &Functions<R>) -> Correction<R> {
        let Functions([g0, g1, ..]) = *g;
        let late = self.late(x, g);
        let second = self.zeta.multiply_add(g1, self.eta * g0);
        let third = (-(self.beta * self.eta)).multiply_add(g1, self.zeta * g0);
        self.correction_by(late, [number::<R>(1.0) / self.distance(g), second, third])
    }

    /// The distance where the functions have these values.
    #[inline(always)]
    fn distance(&self, Functions([_, g1, g2, _]): &Functions<R>) -> R {
        self.eta.multiply_add(*g1, self.zeta.multiply_add(*g2, self.r))
    }

    /// f − 1, g, ḟ, ġ − 1 of q₁ = f q + g v, v₁ = ḟ q + ġ v.
    #[inline(always)]
    pub(super) fn end(&self, g: &Functions<R>) -> [R; 4] {
        let Functions([_, g1, g2, g3]) = *g;
        let (pull, recip) = (-self.mu, number::<R>(1.0) / self.distance(g));
        let over_r = pull * self.recip;
        [over_r * g2, pull.multiply_add(g3, self.h), over_r * g1 * recip, pull * g2 * recip]
    }
}

impl<R: Real> Functions<R> {
    /// The functions at X + d for a small d, by their Taylor polynomials.
    #[inline(always)]
    pub(super) fn shifted(self, d: R, beta: R) -> Self {
        let Functions([g0, g1, g2, g3]) = self;
        let half = d * number(0.5);
        let (slope, bend) = (-(beta * g1), -(beta * g0));
        // f + d (f' + d/2 (f'' + d f'''/3)).
        let moved = |f: R, [f1, f2, f3]: [R; 3]| {
            d.multiply_add(half.multiply_add(d.multiply_add(f3 * number(1.0 / 3.0), f2), f1), f)
        };
        Functions([
            moved(g0, [slope, bend, -(beta * slope)]),
            moved(g1, [g0, slope, bend]),
            moved(g2, [g1, g0, slope]),
            moved(g3, [g2, g1, g0]),
        ])
    }

    /// The functions at 2X.
    #[inline(always)]
    pub(super) fn doubled(self, x: R, beta: R) -> Self {
        let Functions([g0, g1, g2, g3]) = self;
        let third = x.multiply_add(g2, g0 * g3);
        let (first, second) = (g0 * g1, g1 * g1);
        let second = second + second;
        Functions([number::<R>(1.0) - beta * second, first + first, second, third + third])
    }
}

/// Zero where a condition holds, else one.
#[inline(always)]
pub(super) fn unless<R: Real>(mask: R::Mask) -> R {
    let [value] = R::choose(mask, || [zero()], || [number(1.0)]);
    value
}
