//! An `if` in an energy, for scalars that stand for two trajectories: each takes its own side.

use geoint_runtime::prelude::*;
use geoint_tests::scalars::Lanes;

/// A spring that is harder on one side, and hardest beyond a distance.
#[hamiltonian]
fn bumper(q: f64, p: f64, m: f64, k: f64) -> f64 {
    let side = if q < 0.0 { k * q * q } else { 3.0 * k * q * q };
    let far = if q >= 0.8 && q * q < 100.0 { (q - 0.8).powi(4) } else { 0.0 };
    p * p / (2.0 * m) + side + far
}

fn over_lanes(start: [f64; 2]) -> (Bumper<Lanes>, State<Lanes>) {
    (Bumper { m: 1.3.into(), k: 0.7.into() }, State::at(0.0.into(), Lanes(start), Lanes([0.9, -1.1])))
}

/// The trajectory of one lane on its own.
fn alone<M: Method<Bumper>>(method: M, h: f64, q: f64, p: f64, steps: u64) -> State<f64> {
    let mut sim = Bumper { m: 1.3, k: 0.7 }.integrator(method, h, State::new(q, p));
    sim.advance(steps).unwrap();
    sim.state()
}

/// The lanes pass the switch at different times: at some steps both sides are computed, and blended.
#[test]
fn each_lane_takes_its_side() {
    let start = [0.4, -0.3];
    let (system, state) = over_lanes(start);
    let mut sim = Integrator::new(system, BlanesMoan4, 0.05.into(), state);
    sim.advance(400).unwrap();
    let found = sim.state();
    for (lane, p) in [(0, 0.9), (1, -1.1)] {
        let expected = alone(BlanesMoan4, 0.05, start[lane], p, 400);
        assert_eq!((found.q.0[lane], found.p.0[lane]), (expected.q, expected.p), "lane {lane}");
    }
    assert!((found.q.0[0] < 0.0) != (found.q.0[1] < 0.0), "the lanes end on different sides: {found:?}");
}

/// Newton's iteration goes on until both lanes are solved: a lane may be iterated once more than on its own.
#[test]
fn implicit_steps_of_lanes() {
    let start = [0.4, -0.3];
    let (system, state) = over_lanes(start);
    let mut sim = Integrator::new(system, DiscreteGradient, 0.05.into(), state);
    sim.advance(100).unwrap();
    let found = sim.state();
    for (lane, p) in [(0, 0.9), (1, -1.1)] {
        let expected = alone(DiscreteGradient, 0.05, start[lane], p, 100);
        let error = (found.q.0[lane] - expected.q).abs() + (found.p.0[lane] - expected.p).abs();
        assert!(error < 1e-12, "lane {lane}: {error:.1e}");
    }
}

/// A constant torque about the centre: the angle comes round.
#[hamiltonian]
fn torque(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + k * q[1].atan2(q[0])
}

/// On the way round the energy jumps by a turn times the factor of the angle. The motion does not: the angular momentum loses k t.
#[test]
fn an_energy_turns_with_its_angle() {
    let system = Torque { k: 0.1 };
    assert!(Torque::REPORT.contains("Turns\n- k·atan2(q[1], q[0]): the term jumps"), "{}", Torque::REPORT);
    let start = State::new([1.0, 0.0], [0.0, 1.0]);
    let mut sim = system.taylor(Taylor::default(), start);
    sim.advance_to(4.0).unwrap_or_else(|error| panic!("{error}"));
    let (before, end) = (system.energy(&start), sim.state());
    let turn = 2.0 * std::f64::consts::PI * system.k;
    assert!((system.energy(&end) - before + turn).abs() < 1e-12, "{}", system.energy(&end) - before);
    let angular = end.q[0] * end.p[1] - end.q[1] * end.p[0];
    assert!((angular - 1.0 + 4.0 * system.k).abs() < 1e-12, "{angular}");
}
