//! Rows of the double pendulum: the implicit midpoint rule and its compositions.

use super::runs::{generated, plane};
use crate::paired::Pair;
use crate::{by_hand, systems};
use geoint_runtime::prelude::*;
use std::hint::black_box;

pub(crate) fn rows() -> Vec<Pair> {
    let (m, l, g, h) = ([1.3, 0.7], [0.9, 1.1], 9.81, 0.01);
    // The motion from here is regular. Trajectories of a chaotic motion would separate.
    let start = [0.5, 0.9, 0.0, 0.0];
    let hand = move || black_box(by_hand::double_pendulum::DoublePendulum { m, l, g });
    let system = || black_box(systems::DoublePendulum { m, l, g });
    let mut pairs = vec![Pair {
        name: "double pendulum, ImplicitMidpoint".into(),
        subject: generated(system(), ImplicitMidpoint, h, plane(start)),
        unit: Box::new(move |n| hand().implicit_midpoint(black_box(h), n, start).to_vec()),
    }];
    // At the longer step the predictor uses fewer increments.
    for h in [0.01, 0.05] {
        pairs.push(Pair {
            name: format!("double pendulum, Suzuki4.of(ImplicitMidpoint), h = {h}"),
            subject: generated(system(), Suzuki4.of(ImplicitMidpoint), h, plane(start)),
            unit: Box::new(move |n| hand().composed(Suzuki4.weights(), black_box(h), n, start).to_vec()),
        });
    }
    pairs
}
