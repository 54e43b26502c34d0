//! Rows of the step benchmark: each generated stepper beside a hand-written one.
//!
//! The benches `step` and `ledger` time these rows.

mod body;
mod contact;
mod double_pendulum;
mod fields;
pub(crate) mod henon_heiles;
pub(crate) mod kepler;
pub(crate) mod pendulum;
pub(crate) mod planets;
pub(crate) mod runs;

use crate::paired::Pair;

/// Steps after which both trajectories are compared.
const COMPARED_STEPS: u64 = 1000;

/// Largest difference of both trajectories, relative to the largest coordinate.
const TOLERANCE: f64 = 1e-12;

/// Returns all rows. Panics where generated and hand-written trajectories differ.
pub(crate) fn all() -> Vec<Pair> {
    let rows: Vec<Pair> = [
        pendulum::rows(),
        kepler::rows(),
        contact::rows(),
        henon_heiles::rows(),
        planets::rows(),
        double_pendulum::rows(),
        fields::rows(),
        body::rows(),
    ]
    .into_iter()
    .flatten()
    .collect();
    for row in &rows {
        let difference = row.difference(COMPARED_STEPS);
        assert!(difference <= TOLERANCE, "{}: generated and hand-written differ by {difference:.1e}", row.name);
    }
    rows
}
