//! Rounding over 10⁸ steps: Brouwer's law.

use super::{Job, Section, row, short};
use crate::rounding::walks;
use geoint_tests::measure::regression;

/// Numbers of steps are powers of ten up to this one.
const MOST: u32 = 8;
const STARTS: u32 = 2;

/// The exponent a of an error Nᵃ.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let logarithms: Vec<_> = points.iter().map(|(n, error)| (n.ln(), error.max(1e-17).ln())).collect();
    regression(&logarithms).slope
}

/// How errors grow.
pub(super) fn growth() -> Section {
    let jobs = walks().into_iter().flat_map(|walk| {
        [("plain", walk.plain), ("compensated", walk.compensated)].map(|(sums, points)| -> Job {
            Box::new(move || {
                let points = points(MOST, STARTS);
                let (steps, error) = points[points.len() - 1];
                let mut cells = vec![walk.name.to_string(), sums.into()];
                cells.extend(points.iter().map(|(_, error)| short(*error)));
                cells.push(format!("{:.2}", exponent(&points)));
                row(cells, sums == "plain" || error <= 10.0 * f64::EPSILON * steps.sqrt())
            })
        })
    });
    Section {
        title: "Rounding",
        text: "Relative error of the energy after N steps, the root mean square of two starts, and the exponent of N by which it grows: 0.5 for roundings that are \
               independent (D. Brouwer, Astron. J. 46 (1937) 149), 1 for those with a bias. With compensated sums 10 ε √N at most.",
        head: &["method", "sums", "10⁴", "10⁵", "10⁶", "10⁷", "10⁸", "exponent"],
        jobs: jobs.collect(),
    }
}
