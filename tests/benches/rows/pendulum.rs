//! Rows of the pendulum.

use super::runs::generated;
use crate::paired::Pair;
use crate::{by_hand, systems};
use by_hand::Stages;
use geoint_runtime::prelude::*;
use std::hint::black_box;

/// Angle and momentum at the start.
pub(crate) const START: (f64, f64) = (2.0, 0.0);

pub(crate) fn system() -> systems::Pendulum {
    black_box(systems::Pendulum { m: 1.3, l: 0.7, g: 9.81 })
}

pub(crate) fn rows() -> Vec<Pair> {
    let (h, start) = (0.01, State::new(START.0, START.1));
    let hand = || {
        let systems::Pendulum { m, l, g } = system();
        black_box(by_hand::pendulum::Pendulum { m, l, g })
    };
    let flat = |(q, p)| vec![q, p];
    vec![
        Pair {
            name: "pendulum, StormerVerlet".into(),
            subject: generated(system(), StormerVerlet, h, start),
            unit: Box::new(move |n| flat(hand().verlet(black_box(h), n, START))),
        },
        Pair {
            name: "pendulum, BlanesMoan4".into(),
            subject: generated(system(), BlanesMoan4, h, start),
            unit: Box::new(move |n| flat(hand().kicks_first(Stages::of(&BlanesMoan4), black_box(h), n, START))),
        },
        Pair {
            name: "pendulum, DiscreteGradient".into(),
            subject: generated(system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| flat(hand().discrete_gradient::<false>(black_box(h), n, START))),
        },
        Pair {
            name: "pendulum, DiscreteGradient, same sums".into(),
            subject: generated(system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| flat(hand().discrete_gradient::<true>(black_box(h), n, START))),
        },
    ]
}
