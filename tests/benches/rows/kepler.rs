//! Rows of Kepler's problem.

use super::runs::{generated, plane};
use crate::paired::Pair;
use crate::{by_hand, systems};
use by_hand::Stages;
use geoint_runtime::prelude::*;
use std::hint::black_box;

/// (q₀, q₁, p₀, p₁) at the start.
pub(crate) const START: [f64; 4] = [0.4, 0.0, 0.0, 2.6];

pub(crate) fn system() -> systems::Kepler {
    black_box(systems::Kepler { m: 1.3, mu: 1.0 })
}

pub(crate) fn rows() -> Vec<Pair> {
    let (h, start) = (0.01, plane(START));
    let hand = || {
        let systems::Kepler { m, mu } = system();
        black_box(by_hand::kepler::Kepler { m, mu })
    };
    vec![
        Pair {
            name: "Kepler, StormerVerlet".into(),
            subject: generated(system(), StormerVerlet, h, start),
            unit: Box::new(move |n| hand().verlet(black_box(h), n, START).to_vec()),
        },
        Pair {
            name: "Kepler, BlanesMoan4".into(),
            subject: generated(system(), BlanesMoan4, h, start),
            unit: Box::new(move |n| hand().kicks_first(Stages::of(&BlanesMoan4), black_box(h), n, START).to_vec()),
        },
        Pair {
            name: "Kepler, DiscreteGradient".into(),
            subject: generated(system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<false>(black_box(h), n, START).to_vec()),
        },
        Pair {
            name: "Kepler, DiscreteGradient, same sums".into(),
            subject: generated(system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<true>(black_box(h), n, START).to_vec()),
        },
    ]
}
