//! Changes by users between steps: parameters, and the time at which a frame ends.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::StateOf;

/// A motor with a load.
#[hamiltonian(force = torque)]
fn motor(q: f64, p: f64, m: f64, torque: f64) -> f64 {
    p * p / (2.0 * m) - q.cos()
}

/// Two coupled pendulums, split into kicks and drifts.
#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - q[0].cos() - q[1].cos() + k * (q[0] - q[1]).powi(2)
}

/// A planet with a perturbation, in coordinates of Jacobi.
#[hamiltonian(coordinates = jacobi)]
fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..3 {
        h += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            h -= g * m[i] * m[j] / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
        }
    }
    h
}

/// Asserts that a run whose system was replaced takes the steps of a new run from the same state, at the times of the old one.
fn is_like_a_new_run<S: PhaseSpace, M: Method<S>>(systems: [S; 2], method: M, h: f64, start: StateOf<S, f64>)
where
    StateOf<S, f64>: PartialEq + core::fmt::Debug,
{
    use geoint_runtime::space::Snapshot;
    let [first, second] = systems;
    let mut sim = first.integrator(method, h, start);
    sim.advance(37).unwrap();
    let before = sim.state();
    sim.set_system(second);
    assert_eq!(sim.state(), before);
    let mut new = second.integrator(method, h, before);
    sim.advance(41).unwrap();
    new.advance(41).unwrap();
    let [(t, z, _), (_, expected, _)] = [sim.state().parts(), new.state().parts()];
    assert!(z == expected, "{}", method.name());
    assert_eq!((t, sim.steps()), (78.0 * h, 78));
    // Control: the old system leads elsewhere.
    let mut old = first.integrator(method, h, before);
    old.advance(41).unwrap();
    assert!(old.state().parts().1 != z);
}

#[test]
fn parameters_change_in_a_run() {
    let motors = [0.3, -0.2].map(|torque| Motor { m: 1.7, torque });
    is_like_a_new_run(motors, DiscreteGradient, 0.05, State::new(0.4, 0.1));
    is_like_a_new_run(motors, Gauss::<3>, -0.05, State::new(0.4, 0.1));
    let coupled = [0.5, 0.2].map(|k| Coupled { m: 2.0, k });
    is_like_a_new_run(coupled, StormerVerlet, 0.05, State::new([0.4, -0.3], [0.1, 0.0]));
    is_like_a_new_run(coupled, BlanesMoanSrkn14a, 0.3, State::new([0.4, -0.3], [0.1, 0.0]));
    is_like_a_new_run(coupled, Projection(RK4, Energy), 0.05, State::new([0.4, -0.3], [0.1, 0.0]));
    let planets = [1e-3, 2e-3].map(|m| Planets { m: [1.0, m, 3e-4], g: 1.0 });
    let start = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 1.7]], [[0.0, 0.0], [0.0, 1e-3], [-2.3e-4, 0.0]]);
    // The state passes through the coordinates of the method, and is rounded.
    let mut sim = planets[0].integrator(WisdomHolmanProcessed, 0.05, start);
    sim.advance(37).unwrap();
    let (before, mut new) = (sim.state(), planets[1].integrator(WisdomHolmanProcessed, 0.05, sim.state()));
    sim.set_system(planets[1]);
    sim.advance(41).unwrap();
    new.advance(41).unwrap();
    let apart = (0..3).map(|i| (sim.state().q[i][0] - new.state().q[i][0]).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-13 && sim.state() != before, "{apart:.1e}");
}

/// A pendulum in Cartesian coordinates with a torque about its pivot.
#[lagrangian(constraint = (q[0] * q[0] + q[1] * q[1] - rod * rod) / 2.0)]
fn crank(q: [f64; 2], v: [f64; 2], m: f64, g: f64, rod: f64, torque: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - m * g * q[1] + torque * q[1].atan2(q[0])
}

/// Each change of the torque adds its potential to the energy. Between changes the energy stays, and the rod keeps its length.
fn keeps_the_rod<M: Method<Crank>>(method: M, energy_error: f64) {
    let system = Crank { m: 1.7, g: 9.81, rod: 0.5, torque: 0.0 };
    let start = system.state_on_constraint(&system.at([0.3, -0.4], [0.8, 0.6])).unwrap();
    let mut sim = system.integrator(method, 0.01, start);
    for k in 0..200 {
        let torque = -0.2 * f64::from(k % 3);
        sim.set_system(Crank { torque, ..*sim.system() });
        let energy = sim.energy();
        sim.advance(5).unwrap();
        assert!((sim.energy() - energy).abs() < energy_error, "{}: {:.1e}", method.name(), sim.energy() - energy);
        let [x, y] = sim.state().q;
        assert!((x.hypot(y) - 0.5).abs() < 1e-14);
    }
    // Control: a longer rod is off its constraint.
    let before = sim.state();
    sim.set_system(Crank { rod: 0.6, ..*sim.system() });
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OffConstraint { .. }, .. })));
    assert_eq!(sim.state(), before);
}

#[test]
fn parameters_of_mechanisms_change_in_a_run() {
    keeps_the_rod(DiscreteGradient, 1e-13);
    keeps_the_rod(Suzuki4.of(DiscreteGradient), 1e-13);
    keeps_the_rod(Rattle, 0.01);
}

#[test]
fn parameters_change_in_runs_that_choose_their_steps() {
    let systems = [0.3, -0.2].map(|torque| Motor { m: 1.7, torque });
    let mut reference = systems[0].integrator(Gauss::<6>, 0.01, State::new(0.4, 0.1));
    reference.advance(200).unwrap();
    reference.set_system(systems[1]);
    reference.advance(300).unwrap();

    let mut adaptive = systems[0].adaptive(DOP853, 1e-11, State::new(0.4, 0.1));
    let mut taylor = systems[0].taylor(Taylor { tolerance: 1e-13 }, State::new(0.4, 0.1));
    adaptive.advance_to(2.0).unwrap();
    taylor.advance_to(2.0).unwrap();
    adaptive.set_system(systems[1]);
    taylor.set_system(systems[1]);
    adaptive.advance_to(5.0).unwrap();
    taylor.advance_to(5.0).unwrap();
    for q in [adaptive.state().q, taylor.state().q] {
        assert!((q - reference.state().q).abs() < 1e-9, "{q}");
    }
    assert_eq!((adaptive.time(), taylor.time()), (5.0, 5.0));
}

#[test]
fn a_parameter_that_is_not_a_number_is_named() {
    let invalid = Coupled { m: 2.0, k: f64::NAN };
    let start = State::new([0.4, -0.3], [0.1, 0.0]);
    let named = Failure::InvalidParameter { name: "k" };
    let failure = |outcome: Result<(), StepError>| outcome.unwrap_err().failure;
    assert_eq!(failure(invalid.integrator(StormerVerlet, 0.1, start).step()), named);
    assert_eq!(failure(invalid.integrator(DiscreteGradient, 0.1, start).advance(3)), named);
    assert_eq!(failure(invalid.adaptive(DOP853, 1e-6, start).advance_to(1.0)), named);
    assert_eq!(failure(invalid.taylor(Taylor::default(), start).step()), named);
    assert!(named.to_string().contains("`k`"));

    // The run goes on with a parameter that is a number.
    let mut sim = Coupled { k: 0.5, ..invalid }.integrator(StormerVerlet, 0.1, start);
    sim.step().unwrap();
    let before = sim.state();
    sim.set_system(invalid);
    assert_eq!(failure(sim.step()), named);
    assert_eq!(sim.state(), before);
    sim.set_system(Coupled { k: 0.5, ..invalid });
    sim.step().unwrap();
}

/// A frame is no whole number of steps. The search ends with a shorter step, and the next frame goes on from there.
#[test]
fn a_search_without_an_event_ends_at_its_time() {
    for (h, frame) in [(0.03, 0.1), (-0.03, -0.1), (0.1, 0.1), (0.25, 0.1)] {
        let system = Coupled { m: 2.0, k: 0.5 };
        let start = State::new([0.4, -0.3], [0.1, 0.0]);
        let mut sim = system.integrator(BlanesMoanSrkn14a, h, start);
        for k in 1..=50 {
            let end = f64::from(k) * frame;
            assert_eq!(sim.until_event(end, Direction::Any, |x| x.q[0] - 5.0), Ok(None));
            assert_eq!(sim.time(), end);
        }
        assert_eq!(sim.step_size(), h);
        let mut exact = system.integrator(BlanesMoanSrkn14a, frame / 8.0, start);
        exact.advance(400).unwrap();
        let apart = (sim.state().q[0] - exact.state().q[0]).abs();
        assert!(apart < 1e-8, "h {h}: {apart:.1e}");
    }
}

/// A ball of a game, in single precision.
#[hamiltonian]
fn ball_single(q: f32, p: f32, m: f32, g: f32) -> f32 {
    p * p / (2.0 * m) + m * g * q
}

/// After minutes in single precision, the rounding error of a time is a sizeable part of a step. An impact just after the start of a frame is still found.
#[test]
fn no_impact_is_missed_in_single_precision() {
    let mut sim = BallSingle { m: 0.16, g: 9.81 }.integrator(StormerVerlet, 1.0 / 60.0, State::new(2.0_f32, 0.0));
    let mut impacts = 0;
    for frame in 1..=40_000_u16 {
        let end = f32::from(frame) / 60.0;
        while let Some(impact) = sim.until_event(end, Direction::Down, |x| x.q).unwrap() {
            impacts += 1;
            sim.set_state(State { q: 0.0, p: -impact.state.p, ..impact.state });
        }
        let q = sim.state().q;
        assert!(q > -1e-3 && q < 2.5, "frame {frame}: {q}");
    }
    // A flight takes 2 √(2 · 2/9.81) s = 1.28 s.
    assert!((500..540).contains(&impacts), "{impacts} impacts");
}

/// Bounces that are shorter and shorter, down to a few steps, long after the start.
#[test]
fn short_bounces_are_seen_after_a_long_time() {
    for t in [0.0_f32, 50.0, 1000.0] {
        let start = State { t, ..State::new(0.05_f32, 0.0) };
        let mut sim = BallSingle { m: 0.16, g: 9.81 }.integrator(StormerVerlet, 1.0 / 60.0, start);
        let mut speed = f32::INFINITY;
        for frame in 1..=600_u16 {
            let end = t + f32::from(frame) / 60.0;
            while let Some(impact) = sim.until_event(end, Direction::Down, |x| x.q).unwrap() {
                speed = impact.state.p.abs() / 0.16;
                // A bounce of two steps: the ball lies down.
                let bounced = if speed > 0.16 { -0.9 * impact.state.p } else { 0.0 };
                sim.set_state(State { q: 0.0, p: bounced, ..impact.state });
                if bounced == 0.0 {
                    break;
                }
            }
            let q = sim.state().q;
            if speed <= 0.16 {
                break;
            }
            assert!(q > -2e-3, "from t = {t}, frame {frame}: {q}, speed {speed}");
        }
        assert!(speed <= 0.16, "from t = {t}: {speed}");
    }
}

/// The search for impacts that accumulate ends. The times of impacts differ by less than rounding, and the momenta fall to the smallest numbers.
#[test]
fn bounces_below_the_smallest_normal_number_end() {
    let mut sim = Motor { m: 1.0, torque: -1.0 }.taylor(Taylor::default(), State::new(0.0, 1e-150));
    for _ in 0..200 {
        let Ok(Some(impact)) = sim.until_event(1e3, Direction::Down, |x| x.q) else { break };
        sim.set_state(State { q: 0.0, p: -0.9 * impact.state.p, ..impact.state });
    }
    assert!(sim.state().p.abs() < 1e-140);
}

/// A weight on a rotating arm.
#[lagrangian]
fn arm(q: f64, v: f64, m: f64, w: f64) -> f64 {
    m * (1.0 + q * q) * v * v / 2.0 - m * w * q * q / 2.0
}

#[test]
fn every_run_knows_its_velocity() {
    let system = Arm { m: 1.7, w: 0.6 };
    let start = system.at(0.4, 0.9);
    let mut fixed = system.integrator(Gauss::<4>, 0.01, start);
    let mut adaptive = system.adaptive(DOP853, 1e-11, start);
    let mut taylor = system.taylor(Taylor::default(), start);
    fixed.advance(100).unwrap();
    adaptive.advance_to(1.0).unwrap();
    taylor.advance_to(1.0).unwrap();
    let [a, b, c] = [fixed.velocity(), adaptive.velocity(), taylor.velocity()];
    assert!((a - b).abs() < 1e-9 && (a - c).abs() < 1e-9, "{a} {b} {c}");
    // p = m (1 + q²) v.
    let state = taylor.state();
    assert!((c - state.p / (1.7 * (1.0 + state.q * state.q))).abs() < 1e-14);
}
