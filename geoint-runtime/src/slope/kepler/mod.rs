//! Kepler's motion: the flow of v²/2 − μ/|q|, for all energies, forwards and backwards in time.
//!
//! Universal variables: J. Wisdom & D. M. Hernandez, Mon. Not. R. Astron. Soc. 453 (2015) 3015; H. Rein & D. Tamayo, ibid. 452 (2015) 376.

mod orbit;
mod safe;
mod together;

use crate::scalar::{Real, zero};

/// A correction of the universal anomaly X up to this part of X is the last one. The correction of X has order 6, and that of the functions G order 3.
const SMALL: f64 = 1e-4;

/// Orbits with |q×v|² ≤ `STRAIGHT` ε |q|²v² count as straight lines through the centre. The numbers q·v, |q|² and v² do not distinguish them.
const STRAIGHT: f64 = 8.0;

/// Returns f − 1, g, ḟ and ġ − 1 of N orbits. After a time h in the potential −μ/|q|, q₁ = q + (f − 1)q + g v and v₁ = v + ḟq + (ġ − 1)v.
///
/// The rows of `orbits` are |q|², q·v, v², μ and h, with one entry for each orbit. The orbits may be ellipses, parabolas, hyperbolas, repelled (μ < 0), or
/// free (μ = 0). h may have any sign, and may hold many periods. The result is NaN for an orbit that meets the centre, and for |q| = 0.
///
/// A fast method computes all orbits together. If one of them does not converge, or might meet the centre, a safe method computes all orbits.
#[inline(always)]
pub fn kepler<R: Real, const N: usize>(orbits: [[R; N]; 5]) -> [[R; N]; 4] {
    let mut ends = [[zero(); N]; 4];
    if !together::kepler(&orbits, &mut ends) {
        safely(&orbits, &mut ends);
    }
    ends
}

/// Computes all orbits by the safe method.
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
