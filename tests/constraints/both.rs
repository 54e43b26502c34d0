//! Constraints of positions and of velocities together: a skate in a bowl, against the same skate in coordinates of the bowl.

use crate::systems::{orders, run};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A skate on the bowl z = (x² + y²)/2 that slides along its heading, q = (x, y, z, heading).
#[hamiltonian(
    constraint = [(q[0] * q[0] + q[1] * q[1]) / 2.0 - q[2]],
    rolling = [v[1] * q[3].cos() - v[0] * q[3].sin()]
)]
fn skate(q: [f64; 4], p: [f64; 4], m: f64, i: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + p[3] * p[3] / (2.0 * i) + m * g * q[2]
}

/// The same in x, y and heading.
#[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin()])]
fn skate_on_a_map(q: [f64; 3], v: [f64; 3], m: f64, i: f64, g: f64) -> f64 {
    let climb = q[0] * v[0] + q[1] * v[1];
    m * (v[0] * v[0] + v[1] * v[1] + climb * climb) / 2.0 + i * v[2] * v[2] / 2.0
        - m * g * (q[0] * q[0] + q[1] * q[1]) / 2.0
}

const SKATE: Skate = Skate { m: 1.3, i: 0.4, g: 2.0 };
const MAP: SkateOnAMap = SkateOnAMap { m: 1.3, i: 0.4, g: 2.0 };

/// At (0.6, 0.2), with the speed 0.5 along the heading 0.3, turning with 0.8.
fn started() -> (State<[f64; 4]>, State<[f64; 3]>) {
    let (x, y) = (0.6, 0.2);
    let (sin, cos) = 0.3_f64.sin_cos();
    let (u, w) = (0.5 * cos, 0.5 * sin);
    let climb = x * u + y * w;
    let p = [1.3 * u, 1.3 * w, 1.3 * climb, 0.4 * 0.8];
    (State::new([x, y, (x * x + y * y) / 2.0, 0.3], p), MAP.at([x, y, 0.3], [u, w, 0.8]))
}

#[test]
fn a_skate_in_a_bowl() -> Result<(), StepError> {
    let (start, on_map) = started();
    let mut exact = MAP.adaptive(DOP853, 1e-13, on_map);
    exact.advance_to(4.0)?;
    let (q, v) = (exact.state().q, MAP.velocity(&exact.state()));
    let z = (q[0] * q[0] + q[1] * q[1]) / 2.0;
    let place = [q[0], q[1], z, q[2]];
    let p = [1.3 * v[0], 1.3 * v[1], 1.3 * (q[0] * v[0] + q[1] * v[1]), 0.4 * v[2]];
    let error = |State { q, p: found, .. }: State<[f64; 4]>| {
        [(q, place), (found, p)].map(|(a, b)| (0..4).fold(0.0, |far, i| f64::max(far, (a[i] - b[i]).abs())))
    };
    let second = [0.04, 0.02, 0.01].map(|h| error(run(SKATE, DiscreteGradient, h, start, 4.0).state()));
    let fourth = [0.08, 0.04, 0.02].map(|h| error(run(SKATE, Suzuki4.of(DiscreteGradient), h, start, 4.0).state()));
    for k in [0, 1] {
        assert!(orders(&second.map(|error| error[k])).iter().all(|order| (order - 2.0).abs() < 0.1), "{second:?}");
        assert!(orders(&fourth.map(|error| error[k])).iter().all(|order| (order - 4.0).abs() < 0.2), "{fourth:?}");
    }
    let mut sim = SKATE.integrator(DiscreteGradient, 0.04, start);
    let energy = sim.energy();
    for _ in 0..10_000 {
        sim.step()?;
        let State { q, p, .. } = sim.state();
        let (sin, cos) = q[3].sin_cos();
        let defects = [
            sim.energy() - energy,
            (q[0] * q[0] + q[1] * q[1]) / 2.0 - q[2],
            q[0] * p[0] + q[1] * p[1] - p[2],
            p[1] * cos - p[0] * sin,
        ];
        assert!(defects.iter().all(|defect| defect.abs() < 1e-13), "{defects:?}");
    }
    // Constraints of positions have no explicit methods, and two kinds of multipliers.
    let [pressure, side] = sim.multipliers();
    assert!(pressure.is_finite() && side.is_finite());
    Ok(())
}

/// The pull of the bowl at rest at its lowest point carries the weight: −Gᵀλ with G = (x, y, −1).
#[test]
fn the_bowl_carries_the_weight() -> Result<(), StepError> {
    let rest = State::new([0.0, 0.0, 0.0, 0.3], [0.0; 4]);
    let [pressure, side] = SKATE.multipliers(&rest);
    assert!((pressure - 1.3 * 2.0).abs() < 1e-15 && side.abs() < 1e-15, "{pressure} {side}");
    let mut sim = SKATE.integrator(DiscreteGradient, 0.1, rest);
    sim.advance(10)?;
    assert_eq!(sim.state().q, rest.q);
    Ok(())
}
