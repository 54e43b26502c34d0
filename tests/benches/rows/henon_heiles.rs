//! Rows of the problem of Hénon and Heiles.

use super::runs::{generated, plane};
use crate::paired::Pair;
use crate::{by_hand, systems};
use by_hand::Stages;
use geoint_runtime::prelude::*;
use std::hint::black_box;

/// (q₀, q₁, p₀, p₁) at the start.
pub(crate) const START: [f64; 4] = [0.1, 0.2, 0.3, 0.1];

pub(crate) fn system() -> systems::HenonHeiles {
    black_box(systems::HenonHeiles { lambda: 0.9 })
}

pub(crate) fn rows() -> Vec<Pair> {
    let (h, start) = (0.05, plane(START));
    let hand = || black_box(by_hand::henon_heiles::HenonHeiles { lambda: system().lambda });
    let verlet =
        |name: &str, unit| Pair { name: name.into(), subject: generated(system(), StormerVerlet, h, start), unit };
    let blanes_moan_4 =
        |name: &str, unit| Pair { name: name.into(), subject: generated(system(), BlanesMoan4, h, start), unit };
    vec![
        verlet(
            "Hénon–Heiles, StormerVerlet",
            Box::new(move |n| hand().verlet::<false>(black_box(h), n, START).to_vec()),
        ),
        verlet(
            "Hénon–Heiles, StormerVerlet, by terms",
            Box::new(move |n| hand().verlet::<true>(black_box(h), n, START).to_vec()),
        ),
        blanes_moan_4(
            "Hénon–Heiles, BlanesMoan4",
            Box::new(move |n| {
                hand().kicks_first::<false, 6>(Stages::of(&BlanesMoan4), black_box(h), n, START).to_vec()
            }),
        ),
        blanes_moan_4(
            "Hénon–Heiles, BlanesMoan4, by terms",
            Box::new(move |n| hand().kicks_first::<true, 6>(Stages::of(&BlanesMoan4), black_box(h), n, START).to_vec()),
        ),
        Pair {
            name: "Hénon–Heiles, DiscreteGradient".into(),
            subject: generated(system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<false>(black_box(h), n, START).to_vec()),
        },
        Pair {
            name: "Hénon–Heiles, DiscreteGradient, same sums".into(),
            subject: generated(system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<true>(black_box(h), n, START).to_vec()),
        },
    ]
}
