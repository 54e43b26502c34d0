//! Universal variables: one set of formulas for the orbits of all energies, without branches.
//!
//! Products are ordered so that operands which are known early are combined first.

use crate::scalar::{Real, zero};
use crate::slope::{factorial, series};

/// The parameters of an orbit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orbit<R> {
    /// The distance r at the start, and 1/r.
    pub(super) r: R,
    pub(super) recip: R,
    /// q·v at the start.
    pub(super) eta: R,
    /// β = −2E with the energy E. Positive for ellipses.
    pub(super) beta: R,
    /// μ − βr.
    pub(super) zeta: R,
    pub(super) mu: R,
    pub(super) h: R,
}

/// Corrections of X.
#[derive(Clone, Copy, Debug)]
pub(super) struct Correction<R> {
    /// Newton's correction. It is small only near the solution. The other correction may vanish elsewhere.
    pub(super) newton: R,
    /// The correction of order 6.
    pub(super) change: R,
}

/// The functions G₀, …, G₃ at X: Gₖ' = Gₖ₋₁, G₁ = X − …, G₀'' = −βG₀.
#[derive(Clone, Copy, Debug)]
pub(super) struct Functions<R>(pub(super) [R; 4]);

/// The series of G₂ and G₃ are accurate to rounding for |β|X² up to this bound. On an ellipse, it is an eccentric anomaly of 2.4 rad.
pub(super) const RADIUS: f64 = 6.0;

/// Converts a number to the scalar.
#[inline(always)]
fn number<R: Real>(x: f64) -> R {
    R::from_f64(x)
}

/// Returns Σ cₖ zᵏ for k < 12 by Estrin's scheme, with a shorter chain of dependent operations than Horner's rule.
#[inline(always)]
fn polynomial<R: Real>(z: R, c: &[f64; 12]) -> R {
    let square = z * z;
    let fourth = square * square;
    let two = |k: usize| z.multiply_add(number(c[k + 1]), number(c[k]));
    let four = |k: usize| square.multiply_add(two(k + 2), two(k));
    (fourth * fourth).multiply_add(four(8), fourth.multiply_add(four(4), four(0)))
}

impl<R: Real> Orbit<R> {
    /// Computes the parameters from |q|², q·v, v², μ and h.
    #[inline(always)]
    pub(super) fn new([square, eta, speed, mu, h]: [R; 5]) -> Self {
        let r = square.sqrt();
        let recip = number::<R>(1.0) / r;
        let beta = (mu + mu).multiply_add(recip, -speed);
        Orbit { r, recip, eta, beta, zeta: (-beta).multiply_add(r, mu), mu, h }
    }

    /// Returns the functions G at X. Precondition: |β|X² ≤ [`RADIUS`].
    #[inline(always)]
    pub(super) fn functions(&self, x: R) -> Functions<R> {
        let square = x * x;
        let z = -(self.beta * square);
        // `tail` holds the rounding error of 1/6. Without it, each G₃ is too small, and the energy grows over a million steps.
        let sixth = 1.0 / 6.0;
        let tail = sixth - crate::scalar::signed(number::<R>(sixth)) + 9.25185853854297e-18;
        let rest = polynomial(z, series!(12, |k| 1.0 / factorial(2 * k + 5)));
        let c3 = number::<R>(sixth) + z.multiply_add(rest, number(tail));
        let c2 = polynomial(z, series!(12, |k| 1.0 / factorial(2 * k + 2)));
        Functions([z.multiply_add(c2, number(1.0)), (z * x).multiply_add(c3, x), square * c2, square * x * c3])
    }

    /// Returns the correction of X for a remaining time `late`, up to order 6.
    ///
    /// The arguments are 1/t', t'' and t''' of the time t(X). Each higher derivative is −β times the derivative two orders below.
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

    /// Returns the first guess of X, from the series of t(X) at the start.
    #[inline(always)]
    pub(super) fn first_guess(&self) -> R {
        self.correction_by(self.h, [self.recip, self.eta, self.zeta]).change
    }

    /// Returns the remaining time h − t(X).
    #[inline(always)]
    pub(super) fn late(&self, x: R, Functions([_, _, g2, g3]): &Functions<R>) -> R {
        let straight = (-self.r).multiply_add(x, self.h);
        (-self.zeta).multiply_add(*g3, (-self.eta).multiply_add(*g2, straight))
    }

    /// Returns the correction of X from the functions at X.
    #[inline(always)]
    pub(super) fn correction(&self, x: R, g: &Functions<R>) -> Correction<R> {
        let Functions([g0, g1, ..]) = *g;
        let late = self.late(x, g);
        let second = self.zeta.multiply_add(g1, self.eta * g0);
        let third = (-(self.beta * self.eta)).multiply_add(g1, self.zeta * g0);
        self.correction_by(late, [number::<R>(1.0) / self.distance(g), second, third])
    }

    /// Returns the distance from the centre, from the values of the functions.
    #[inline(always)]
    fn distance(&self, Functions([_, g1, g2, _]): &Functions<R>) -> R {
        self.eta.multiply_add(*g1, self.zeta.multiply_add(*g2, self.r))
    }

    /// Returns f − 1, g, ḟ and ġ − 1 with q₁ = f q + g v and v₁ = ḟ q + ġ v.
    #[inline(always)]
    pub(super) fn end(&self, g: &Functions<R>) -> [R; 4] {
        let Functions([_, g1, g2, g3]) = *g;
        let (pull, recip) = (-self.mu, number::<R>(1.0) / self.distance(g));
        let over_r = pull * self.recip;
        [over_r * g2, pull.multiply_add(g3, self.h), over_r * g1 * recip, pull * g2 * recip]
    }
}

impl<R: Real> Functions<R> {
    /// Returns the functions at X + d for a small d, by Taylor polynomials of degree 3.
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

    /// Returns the functions at 2X.
    #[inline(always)]
    pub(super) fn doubled(self, x: R, beta: R) -> Self {
        let Functions([g0, g1, g2, g3]) = self;
        let third = x.multiply_add(g2, g0 * g3);
        let (first, second) = (g0 * g1, g1 * g1);
        let second = second + second;
        Functions([number::<R>(1.0) - beta * second, first + first, second, third + third])
    }
}

/// Returns zero if the condition holds, else one.
#[inline(always)]
pub(super) fn unless<R: Real>(mask: R::Mask) -> R {
    let [value] = R::choose(mask, || [zero()], || [number(1.0)]);
    value
}
