//! Kepler's motion: the flow of v²/2 − μ/|q|, of all energies and in all directions of time.
//!
//! Universal variables: J. Wisdom & D. M. Hernandez, Mon. Not. R. Astron. Soc. 453 (2015) 3015; H. Rein & D. Tamayo, ibid. 452 (2015) 376.

mod lanes;
mod orbit;
mod safe;

use crate::scalar::Real;
use core::array::from_fn;
use lanes::Lanes;
use orbit::{Correction, Orbits, reach};

/// Halvings of X on the fast path: steps up to 2.5 rad.
const HALVINGS: u32 = 1;

/// Evaluations of the functions G on the fast path.
const EVALUATIONS: usize = 3;

/// Changes of X up to this part of it are the last: of X by a formula of order 5, of the functions G by one of order 3.
const SMALL: f64 = 1e-4;

/// Orbits so straight, |q×v|² ≤ `STRAIGHT` ε |q|²v², go through the centre: q·v and the squares do not tell them from those that do.
const STRAIGHT: f64 = 8.0;

/// (f − 1, g, ḟ, ġ − 1) of q₁ = q + (f − 1)q + g v and v₁ = v + ḟq + (ġ − 1)v after a time h in the field −μ/|q|, for each of N orbits given
/// by (|q|², q·v, v², μ, h).
///
/// Ellipses, parabolas, hyperbolas, repulsion (μ < 0) and straight lines (μ = 0); h of any sign, of many periods too. An orbit that meets the
/// centre ends there: its numbers are not numbers, as for |q| = 0.
///
/// All orbits go one fast way together, and where that does not lead to rounding, or might lead through the centre, all go a safe one.
#[inline]
pub fn kepler<R: Real, const N: usize>(orbits: [[R; 5]; N]) -> [[R; 4]; N] {
    let of = |k: usize| Lanes::<R, N>(from_fn(|i| orbits[i][k]));
    let given @ [square, eta, speed, _, _] = [0, 1, 2, 3, 4].map(of);
    let all = Orbits::new(given);
    // Above zero where an orbit may be straight; at rest it is.
    let straight =
        eta.multiply_add(eta, -(square * speed).times(1.0 - STRAIGHT * R::epsilon())) + Lanes::all(R::smallest());
    let curved = straight.0.iter().fold(true, |all, x| all & not_above_zero(*x));
    if curved {
        let mut x = all.first_guess();
        for _ in 0..EVALUATIONS {
            let g = all.functions(x, HALVINGS);
            let Correction { newton, change } = all.correction(x, &g);
            let known = (0..N).fold(true, |known, i| {
                let (x, beta) = (x.0[i], all.beta.0[i]);
                let far = newton.0[i].abs() - x.abs() * R::from_f64(SMALL);
                let beyond = (beta * x * x).abs() - R::from_f64(reach(HALVINGS));
                known & not_above_zero(far) & not_above_zero(beyond)
            });
            if known {
                let end = all.end(&g.shifted(change, all.beta));
                return from_fn(|i| end.each_ref().map(|lanes| lanes.0[i]));
            }
            x = x + change;
        }
    }
    orbits.map(safe::kepler)
}

/// Whether all components are numbers that are not above zero.
#[inline(always)]
fn not_above_zero<R: Real>(x: R) -> bool {
    x.magnitude() < f64::INFINITY && !x.any_above(0.0)
}

macro_rules! single {
    ($($(#[$doc:meta])* $name:ident $index:literal;)*) => { $(
        $(#[$doc])*
        #[inline]
        pub fn $name<R: Real>(square: R, eta: R, speed: R, mu: R, h: R) -> R {
            let [of_one] = kepler([[square, eta, speed, mu, h]]);
            of_one[$index]
        }
    )* };
}

single! {
    /// f − 1 of [`kepler`].
    kepler_f 0;
    /// g of [`kepler`].
    kepler_g 1;
    /// ḟ of [`kepler`].
    kepler_f_rate 2;
    /// ġ − 1 of [`kepler`].
    kepler_g_rate 3;
}
