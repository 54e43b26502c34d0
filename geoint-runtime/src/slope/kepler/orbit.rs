//! Universal variables: the orbits of every energy by one set of formulas.

use super::lanes::Lanes;
use crate::scalar::{Real, signed};
use crate::slope::{factorial, series};

/// What the motion along each of N orbits follows from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orbits<R, const N: usize> {
    /// The distance at the start, and 1 over it.
    pub(super) r: Lanes<R, N>,
    pub(super) recip: Lanes<R, N>,
    /// q·v at the start.
    pub(super) eta: Lanes<R, N>,
    /// −2 E: positive for ellipses.
    pub(super) beta: Lanes<R, N>,
    /// μ − βr.
    pub(super) zeta: Lanes<R, N>,
    pub(super) mu: Lanes<R, N>,
    pub(super) h: Lanes<R, N>,
}

/// How far X is from where it should be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Correction<R, const N: usize> {
    /// Newton's: small only where X is right, while the other one may vanish anywhere.
    pub(super) newton: Lanes<R, N>,
    /// Of order 5.
    pub(super) change: Lanes<R, N>,
}

/// The functions G₀, …, G₃ at X: Gₖ' = Gₖ₋₁, G₁ = X − …, G₀'' = −βG₀.
#[derive(Clone, Copy, Debug)]
pub(super) struct Functions<R, const N: usize>(pub(super) [Lanes<R, N>; 4]);

/// |β|X² up to which the series of G₂ and G₃ have all digits.
const RADIUS: f64 = 1.6;

/// |β|X² up to which halving X so many times leaves no more than [`RADIUS`].
pub(super) fn reach(halvings: u32) -> f64 {
    RADIUS * (1_u64 << (2 * halvings)) as f64
}

impl<R: Real, const N: usize> Orbits<R, N> {
    /// Of |q|², q·v, v², μ and h.
    #[inline(always)]
    pub(super) fn new([square, eta, speed, mu, h]: [Lanes<R, N>; 5]) -> Self {
        let r = Lanes(square.0.map(Real::sqrt));
        let recip = r.recip();
        let beta = (mu + mu).multiply_add(recip, -speed);
        Orbits { r, recip, eta, beta, zeta: mu - beta * r, mu, h }
    }

    /// The functions G at X, by their series at X/2ⁿ and formulas of the double argument.
    #[inline(always)]
    pub(super) fn functions(&self, x: Lanes<R, N>, halvings: u32) -> Functions<R, N> {
        let (beta, one) = (self.beta, Lanes::all(1.0));
        let mut y = x.times(1.0 / (1_u64 << halvings) as f64);
        let square = y * y;
        let z = -(beta * square);
        // Without the digits that 1/6 is rounded by, every G₃ is too small, and a million steps gain energy.
        let sixth = 1.0 / 6.0;
        let tail = sixth - signed(R::from_f64(sixth)) + 9.25185853854297e-18;
        let rest = z.polynomial(series!(8, |k| 1.0 / factorial(2 * k + 5)));
        let c3 = Lanes::all(sixth) + z.multiply_add(rest, Lanes::all(tail));
        let c2 = z.polynomial(series!(9, |k| 1.0 / factorial(2 * k + 2)));
        let (mut g2, mut g3) = (square * c2, square * y * c3);
        let (mut g0, mut g1) = (one - beta * g2, y - beta * g3);
        for _ in 0..halvings {
            g3 = (y.multiply_add(g2, g0 * g3)).times(2.0);
            g2 = (g1 * g1).times(2.0);
            g1 = (g0 * g1).times(2.0);
            g0 = one - beta * g2;
            y = y + y;
        }
        Functions([g0, g1, g2, g3])
    }

    /// How far X has to go for a time `late`, up to order 5, by the derivatives of time: 1 over the first one, the second, the third. The
    /// fourth is −β times the second.
    #[inline(always)]
    fn correction_by(&self, late: Lanes<R, N>, [recip, second, third]: [Lanes<R, N>; 3]) -> Correction<R, N> {
        let (w, a, b) = (late * recip, second * recip, third * recip);
        let square = a * a;
        let last = a * (b.times(5.0 / 12.0) - square.times(0.625) + self.beta.times(1.0 / 24.0));
        let inner = w.multiply_add(last, square.times(0.5) - b.times(1.0 / 6.0));
        let inner = w.multiply_add(inner, a.times(-0.5));
        Correction { newton: w, change: w * w.multiply_add(inner, Lanes::all(1.0)) }
    }

    /// X from the series of time at the start.
    #[inline(always)]
    pub(super) fn first_guess(&self) -> Lanes<R, N> {
        self.correction_by(self.h, [self.recip, self.eta, self.zeta]).change
    }

    /// The time that is left of h at X.
    #[inline(always)]
    pub(super) fn late(&self, x: Lanes<R, N>, Functions([_, _, g2, g3]): &Functions<R, N>) -> Lanes<R, N> {
        self.h - self.r.multiply_add(x, self.eta.multiply_add(*g2, self.zeta * *g3))
    }

    /// By how much X is too small, for the functions at X.
    #[inline(always)]
    pub(super) fn correction(&self, x: Lanes<R, N>, g: &Functions<R, N>) -> Correction<R, N> {
        let Functions([g0, g1, ..]) = *g;
        let late = self.late(x, g);
        let second = self.eta.multiply_add(g0, self.zeta * g1);
        let third = self.zeta.multiply_add(g0, -(self.beta * self.eta * g1));
        self.correction_by(late, [self.distance(g).recip(), second, third])
    }

    /// The distance where the functions have these values.
    #[inline(always)]
    fn distance(&self, Functions([_, g1, g2, _]): &Functions<R, N>) -> Lanes<R, N> {
        self.r + self.eta.multiply_add(*g1, self.zeta * *g2)
    }

    /// f − 1, g, ḟ, ġ − 1 of q₁ = f q + g v, v₁ = ḟ q + ġ v.
    #[inline(always)]
    pub(super) fn end(&self, g: &Functions<R, N>) -> [Lanes<R, N>; 4] {
        let Functions([_, g1, g2, g3]) = *g;
        let (pull, recip) = (-self.mu, self.distance(g).recip());
        let (by_g1, by_g2) = (pull * g1, pull * g2);
        [by_g2 * self.recip, pull.multiply_add(g3, self.h), by_g1 * self.recip * recip, by_g2 * recip]
    }
}

impl<R: Real, const N: usize> Functions<R, N> {
    /// The functions at X + d for a small d, by their Taylor polynomials.
    #[inline(always)]
    pub(super) fn shifted(self, d: Lanes<R, N>, beta: Lanes<R, N>) -> Self {
        let Functions([g0, g1, g2, g3]) = self;
        let (half, third) = (d.times(0.5), d.times(1.0 / 3.0));
        let (slope, bend) = (-(beta * g1), -(beta * g0));
        // f + d (f' + d/2 (f'' + d/3 f''')).
        let moved = |f: Lanes<R, N>, [f1, f2, f3]: [Lanes<R, N>; 3]| {
            d.multiply_add(half.multiply_add(third.multiply_add(f3, f2), f1), f)
        };
        Functions([
            moved(g0, [slope, bend, -(beta * slope)]),
            moved(g1, [g0, slope, bend]),
            moved(g2, [g1, g0, slope]),
            moved(g3, [g2, g1, g0]),
        ])
    }
}
