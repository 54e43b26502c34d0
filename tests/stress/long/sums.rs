//! Rounding over 10⁸ steps: Brouwer's law.

use super::{Job, Part, Section, all, row, short};
use crate::rounding::walks;
use geoint_tests::measure::regression;

/// Powers of ten: the number of steps from all starts, and from the first start.
const MOST: u32 = 6;
const FIRST: u32 = 8;
const STARTS: u32 = 8;

/// The largest exponent accepted as a random walk. For eight walks measured at three times the exponent is 0.5 ± 0.15.
const WALK: f64 = 0.8;

/// Returns the exponent a of an error Nᵃ, over the steps that all starts have taken.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let all = &points[..points.len() - (FIRST - MOST) as usize];
    let logarithms: Vec<_> = all.iter().map(|(n, error)| (n.ln(), error.max(1e-17).ln())).collect();
    regression(&logarithms).slope
}

/// Returns the section on the growth of errors.
pub(super) fn growth() -> Section {
    let jobs = walks().into_iter().flat_map(|walk| {
        [("plain", walk.plain), ("compensated", walk.compensated)].map(|(sums, points)| -> Job {
            Box::new(move || {
                let points = points((MOST, STARTS), FIRST);
                let exponent = exponent(&points);
                let mut cells = vec![walk.name.to_string(), sums.into()];
                cells.extend(points.iter().map(|(_, error)| short(*error)));
                cells.push(format!("{exponent:.2}"));
                // Plain sums may have a bias of a hundredth of the last digit in every step.
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
        text: "Error after 10⁸ steps with plain and with compensated sums. Independent rounding errors grow as √N (D. Brouwer, Astron. J. 46 \
               (1937) 149).",
        head: &["method", "sums", "10⁴", "10⁵", "10⁶", "10⁷", "10⁸", "exponent"],
        part: Part::Pivot { row: 0, by: 1, cells: &["plain", "compensated"], value: 6, chosen: all },
        jobs: jobs.collect(),
    }
}
