//! Kepler's motion: the flow of v²/2 − μ/|q|, of all energies and in all directions of time.
//!
//! Universal variables: J. Wisdom & D. M. Hernandez, Mon. Not. R. Astron. Soc. 453 (2015) 3015; H. Rein & D. Tamayo, ibid. 452 (2015) 376.

mod orbit;
mod safe;
mod together;

use crate::scalar::{Real, zero};

/// Changes of X up to this part of it are the last: of X by a formula of order 6, of the functions G by one of order 3.
const SMALL: f64 = 1e-4;

/// Orbits so straight, |q×v|² ≤ `STRAIGHT` ε |q|²v², go through the centre: q·v and the squares do not tell them from those that do.
const STRAIGHT: f64 = 8.0;

/// (f − 1, g, ḟ, ġ − 1) of q₁ = q + (f − 1)q + g v and v₁ = v + ḟq + (ġ − 1)v after a time h in the field −μ/|q|, for each of N orbits given
/// by (|q|², q·v, v², μ, h): one row a kind, of one number an orbit.
///
/// Ellipses, parabolas, hyperbolas, repulsion (μ < 0) and straight lines (μ = 0); h of any sign, of many periods too. An orbit that meets the
/// centre ends there: its numbers are not numbers, as for |q| = 0.
///
/// All orbits go one fast way together, and where that does not lead to rounding, or might lead through the centre, all go a safe one.
#[inline(always)]
pub fn kepler<R: Real, const N: usize>(orbits: [[R; N]; 5]) -> [[R; N]; 4] {
    let mut ends = [[zero(); N]; 4];
    if !together::kepler(&orbits, &mut ends) {
        safely(&orbits, &mut ends);
    }
    ends
}

/// All the safe way.
#[cold]
#[inline(never)]
fn safely<R: Real, const N: usize>(orbits: &[[R; N]; 5], ends: &mut [[R; N]; 4]) {
    for i in 0..N {
        let end = safe::kepler(orbits.map(|numbers| numbers[i]));
        ends.iter_mut().zip(end).for_each(|(ends, end)| ends[i] = end);
    }
}

macro_rules! single {
    ($($(#[$doc:meta])* $name:ident $index:literal;)*) => { $(
        $(#[$doc])*
        #[inline]
        pub fn $name<R: Real>(square: R, eta: R, speed: R, mu: R, h: R) -> R {
            let [of_one] = kepler([[square], [eta], [speed], [mu], [h]])[$index];
            of_one
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
