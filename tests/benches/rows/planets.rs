//! Rows of the Sun with five planets.

use super::runs::generated;
use crate::paired::Pair;
use crate::{by_hand, systems};
use by_hand::Stages;
use geoint_runtime::prelude::*;
use geoint_runtime::space::Coordinates;
use geoint_tests::outer_planets;
use nalgebra::Vector3;
use std::hint::black_box;

/// The system, its start and a step of 50 days.
pub(crate) fn six_bodies() -> (systems::OuterSolarSystem, State<[Vector3<f64>; 6]>, f64) {
    (systems::OuterSolarSystem { m: outer_planets::MASSES, g: outer_planets::G }, outer_planets::start(), 50.0)
}

pub(crate) fn rows() -> Vec<Pair> {
    let (bodies, start, h) = six_bodies();
    let system = || black_box(bodies);
    let hand = move || black_box(by_hand::outer_solar_system::OuterSolarSystem { m: bodies.m, g: bodies.g });
    let (q, p) = (start.q.into_array(), start.p.into_array());
    let flat = |(q, p): ([[f64; 3]; 6], [[f64; 3]; 6])| [q, p].as_flattened().as_flattened().to_vec();
    vec![
        Pair {
            name: "outer solar system, StormerVerlet".into(),
            subject: generated(system(), StormerVerlet, h, start),
            unit: Box::new(move |n| flat(hand().verlet(black_box(h), n, (q, p)))),
        },
        Pair {
            name: "outer solar system, BlanesMoanSrkn14a".into(),
            subject: generated(system(), BlanesMoanSrkn14a, h, start),
            unit: Box::new(move |n| {
                flat(hand().drifts_first(Stages::of(BlanesMoanSrkn14a.table()), black_box(h), n, (q, p)))
            }),
        },
    ]
}
