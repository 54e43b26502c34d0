//! Estimates the range of the series of a function of the state: a condition, or an event function.
//!
//! The step length follows from the coordinates. The series of a function of them may have a smaller radius of convergence. Example: for a free body,
//! the coordinates are polynomials, but the series of its distance from a centre has a finite radius, namely the distance of the centre.

use crate::scalar::Real;

/// Returns the usable fraction of the step, for a function Σ gₖτᵏ with τ in parts of the step. `part` is the usable fraction of the radius of
/// convergence. Infinite if the whole step is usable, or if the last coefficients give no radius.
///
/// The radius is estimated by comparing the last two terms with earlier ones. The value g₀ is not used. Far from the place where a function changes,
/// it may be almost constant, with a small part that grows.
pub(crate) fn reach(g: &[f64], part: f64) -> f64 {
    let last = g.len().saturating_sub(1);
    let mut least = f64::INFINITY;
    for m in (last / 2 + 1..=last).rev() {
        // Every other term of an even or odd function is zero.
        if m + 2 <= last && least < f64::INFINITY {
            break;
        }
        least = least.min(radius(g, m, part));
    }
    if part * least < 1.0 { part * least } else { f64::INFINITY }
}

/// Estimates the radius of convergence by the term of order m. The search stops as soon as the radius is known to be at least 1/`part`.
#[inline]
fn radius(g: &[f64], m: usize, part: f64) -> f64 {
    let (earlier, last) = (1..=(m / 2).max(1).min(m - 1), g[m].abs());
    if !(last > 0.0 && last < f64::INFINITY) {
        return f64::INFINITY;
    }
    let mut needed = last;
    for j in (1..m).rev() {
        needed /= part;
        if earlier.contains(&j) && g[j].abs() >= needed {
            return 1.0 / part;
        }
    }
    let known = earlier.filter(|j| g[*j] != 0.0);
    let radius = known.map(|j| Real::exp2((Real::log2(g[j].abs()) - Real::log2(last)) / (m - j) as f64));
    radius.reduce(f64::max).unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_geometric_series() {
        // 1/(1 − τ/R): usable up to τ = R/4.
        for radius in [0.01, 0.5, 3.0] {
            let g: [f64; 20] = core::array::from_fn(|k| 7.0 * f64::powi(radius, -(k as i32)));
            assert!((reach(&g, 0.25) - 0.25 * radius).abs() < 1e-9, "{radius}");
            // The result does not depend on g₀, and odd terms may be zero.
            let even: [f64; 20] = core::array::from_fn(|k| if k == 0 { 1e30 } else { g[k] * f64::from(k % 2 == 0) });
            assert!((reach(&even, 0.25) - 0.25 * radius).abs() < 1e-9, "{radius}");
        }
        assert_eq!(reach(&[1.0, 1.0, 0.01, 1e-4], 0.25), f64::INFINITY);
    }

    #[test]
    fn polynomials_have_no_end() {
        let mut g = [0.0; 20];
        (g[0], g[1], g[2]) = (-1.0, 3.0, 1e9);
        assert_eq!(reach(&g, 0.25), f64::INFINITY);
        assert_eq!(reach(&[1.0, 2.0], 0.25), f64::INFINITY);
        assert_eq!(reach(&[1.0], 0.25), f64::INFINITY);
    }
}
