//! How far a function of the state has the series that its coefficients tell: where a condition is looked for, or an event.
//!
//! The length of a step follows from the coordinates. A function of them may have a series that ends earlier: of a body that flies freely the
//! coordinates are polynomials, of its distance from a centre the series ends as far ahead as the centre is off.

use crate::scalar::Real;

/// What part of the step in which Σ gₖτᵏ is written its series is good for, if it is good for `part` of its radius of convergence; infinite
/// where that is the whole step, or the last coefficients say nothing.
///
/// The radius is estimated by the last two terms against earlier ones. The value at the start is not among those: far from where a
/// function changes it may be constant but for little, that grows.
pub(crate) fn reach(g: &[f64], part: f64) -> f64 {
    let last = g.len().saturating_sub(1);
    let mut least = f64::INFINITY;
    for m in (last / 2 + 1..=last).rev() {
        // Every other term is zero where a function is even or odd.
        if m + 2 <= last && least < f64::INFINITY {
            break;
        }
        least = least.min(radius(g, m, part));
    }
    if part * least < 1.0 { part * least } else { f64::INFINITY }
}

/// The radius of convergence by the term of order m; one that is large enough need not be known.
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
        // 1/(1 − τ/R): good for R/4 of the step.
        for radius in [0.01, 0.5, 3.0] {
            let g: [f64; 20] = core::array::from_fn(|k| 7.0 * f64::powi(radius, -(k as i32)));
            assert!((reach(&g, 0.25) - 0.25 * radius).abs() < 1e-9, "{radius}");
            // However large the value at the start is, and without odd terms.
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
