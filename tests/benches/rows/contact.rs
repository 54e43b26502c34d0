//! Rows of Kepler's problem with friction: contact systems, by splitting methods.

use super::runs::contact_run;
use crate::paired::Pair;
use crate::{by_hand, systems};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::hint::black_box;

pub(crate) fn rows() -> Vec<Pair> {
    let (h, z, alpha) = (0.01, [0.6, 0.0, 0.0, 1.5, 0.0], 0.07);
    let start = ContactState::new([z[0], z[1]], [z[2], z[3]], z[4]);
    let driven = move || black_box(systems::DrivenKepler { mu: 1.0, alpha, omega: std::f64::consts::TAU });
    let damped = move || black_box(systems::DampedKepler { mu: 1.0, alpha });
    let hand =
        move || black_box(by_hand::perturbed_kepler::PerturbedKepler { mu: 1.0, alpha, omega: std::f64::consts::TAU });
    vec![
        Pair {
            name: "driven Kepler, ContactSplitting".into(),
            subject: contact_run(driven(), ContactSplitting, h, start),
            unit: Box::new(move |n| hand().driven(black_box(h), n, z).to_vec()),
        },
        Pair {
            name: "damped Kepler, ContactSplitting".into(),
            subject: contact_run(damped(), ContactSplitting, h, start),
            unit: Box::new(move |n| hand().damped(black_box(h), n, z).to_vec()),
        },
        Pair {
            name: "damped Kepler, PositionVerlet".into(),
            subject: contact_run(damped(), PositionVerlet, h, start),
            unit: Box::new(move |n| hand().damped(black_box(h), n, z).to_vec()),
        },
        Pair {
            name: "damped Kepler, Suzuki4.of(ContactSplitting)".into(),
            subject: contact_run(damped(), Suzuki4.of(ContactSplitting), h, start),
            unit: Box::new(move |n| hand().composed(Suzuki4.weights(), black_box(h), n, z).to_vec()),
        },
        Pair {
            name: "damped Kepler, KahanLi8_17a.of(ContactSplitting)".into(),
            subject: contact_run(damped(), KahanLi8_17a.of(ContactSplitting), h, start),
            unit: Box::new(move |n| hand().composed(KahanLi8_17a.weights(), black_box(h), n, z).to_vec()),
        },
    ]
}
