//! Rows of vector fields with integrals: Lotka and Volterra's equations, Euler's top.

use super::runs::flow;
use crate::paired::Pair;
use crate::{by_hand, systems};
use geoint_runtime::methods::*;
use std::hint::black_box;

pub(crate) fn rows() -> Vec<Pair> {
    let (h, start) = (0.02, [1.0, 0.5]);
    let predators = || black_box(systems::LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 });
    let hand = move || {
        let systems::LotkaVolterra { a, b, c } = predators();
        black_box(by_hand::lotka_volterra::LotkaVolterra { a, b, c })
    };
    let (inertia, velocity) = ([1.0, 2.0, 3.0], [0.5, 0.8, -0.4]);
    let momentum = [0, 1, 2].map(|i| inertia[i] * velocity[i]);
    let body = move || black_box(by_hand::free_body::FreeBody { inertia });
    let (momenta, velocities) = (systems::FreeMomentum { inertia }, systems::FreeVelocity { inertia });
    vec![
        Pair {
            name: "Lotka–Volterra, DiscreteGradient".into(),
            subject: flow(predators(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<false>(black_box(h), n, start).to_vec()),
        },
        Pair {
            name: "Lotka–Volterra, DiscreteGradient, same sums".into(),
            subject: flow(predators(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<true>(black_box(h), n, start).to_vec()),
        },
        Pair {
            name: "Euler's top, DiscreteGradient".into(),
            subject: flow(momenta, DiscreteGradient, h, momentum),
            unit: Box::new(move |n| body().discrete_gradient::<false>(black_box(h), n, momentum).to_vec()),
        },
        Pair {
            name: "Euler's top, DiscreteGradient, same sums".into(),
            subject: flow(momenta, DiscreteGradient, h, momentum),
            unit: Box::new(move |n| body().discrete_gradient::<true>(black_box(h), n, momentum).to_vec()),
        },
        Pair {
            name: "Euler's top, PlanarSplitting".into(),
            subject: flow(velocities, PlanarSplitting, h, velocity),
            unit: Box::new(move |n| body().rotations(black_box(h), n, velocity).to_vec()),
        },
    ]
}
