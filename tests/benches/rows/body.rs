//! Rows of a heavy rigid body in its attitude.

use crate::paired::Pair;
use crate::{by_hand, systems};
use geoint_runtime::prelude::*;
use nalgebra::{UnitQuaternion, Vector3};
use std::hint::black_box;

pub(crate) fn rows() -> Vec<Pair> {
    let (h, inertia, c) = (0.05, [1.0, 2.0, 3.0], [0.3, -0.2, 0.7]);
    let momentum = [0.5, 1.6, -1.2];
    let hand = move || black_box(by_hand::heavy_body::HeavyBody { inertia, c });
    vec![Pair {
        name: "heavy body, StormerVerlet".into(),
        subject: Box::new(move |n| {
            let system = black_box(systems::HeavyBody { inertia, c: Vector3::from(c) });
            let start = BodyState::new(UnitQuaternion::identity(), Vector3::from(momentum));
            let mut sim = system.integrator(StormerVerlet, black_box(h), start);
            sim.advance(n).expect("a regular problem");
            let BodyState { r, m, .. } = sim.state();
            [r.coords.as_slice(), m.as_slice()].concat()
        }),
        unit: Box::new(move |n| {
            let (r, m) = hand().verlet(black_box(h), n, [0.0, 0.0, 0.0, 1.0], momentum);
            [&r[..], &m].concat()
        }),
    }]
}
