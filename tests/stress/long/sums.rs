//! Rounding over 10⁸ steps: Brouwer's law.

use super::{Job, Section, row, short};
use crate::rounding::walks;
use geoint_tests::measure::regression;

/// Steps, a power of ten, from all starts, and from the first one.
const MOST: u32 = 6;
const FIRST: u32 = 8;
const STARTS: u32 = 8;

/// The largest exponent of a walk: of eight walks that are looked at three times it is 0.5 ± 0.15.
const WALK: f64 = 0.8;

/// The exponent a of an error Nᵃ, over the steps that all starts have taken.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let all = &points[..points.len() - (FIRST - MOST) as usize];
    let logarithms: Vec<_> = all.iter().map(|(n, error)| (n.ln(), error.max(1e-17).ln())).collect();
    regression(&logarithms).slope
}

/// How errors grow.
pub(super) fn growth() -> Section {
    let jobs = walks().into_iter().flat_map(|walk| {
        [("plain", walk.plain), ("compensated", walk.compensated)].map(|(sums, points)| -> Job {
            Box::new(move || {
                let points = points((MOST, STARTS), FIRST);
                let exponent = exponent(&points);
                let mut cells = vec![walk.name.to_string(), sums.into()];
                cells.extend(points.iter().map(|(_, error)| short(*error)));
                cells.push(format!("{exponent:.2}"));
                // A bias of a hundredth of the last digit in every step, or none.
                let bound = |(n, error): &(f64, f64)| match sums {
                    _ if walk.settled => *error <= 10.0 * f64::EPSILON,
                    "plain" => *error <= f64::EPSILON * (10.0 * n.sqrt() + 0.01 * n),
                    _ => *error <= 10.0 * f64::EPSILON * n.sqrt(),
                };
                row(cells, points.iter().all(bound) && (sums == "plain" || exponent <= WALK))
            })
        })
    });
    Section {
        title: "Rounding",
        text: "Relative error of the energy after N steps, the root mean square of eight starts, after 10⁷ and 10⁸ of one, and the exponent of N by which it grows up to 10⁶: 0.5 \
               for roundings that are independent (D. Brouwer, Astron. J. 46 (1937) 149), 1 for those with a bias. With compensated sums 10 ε √N at most, with \
               plain ones a hundredth of ε a step more; 10 ε where roundings are taken away.",
        head: &["method", "sums", "10⁴", "10⁵", "10⁶", "10⁷", "10⁸", "exponent"],
        jobs: jobs.collect(),
    }
}
