//! Forces beside the energy, and friction that is no quadratic form: against references, and the balance of each step.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{PhaseSpace, VectorField};

/// A pendulum that is pushed, with friction in its joint.
#[lagrangian(rayleigh = c * v * v, force = push * (rate * t).cos())]
fn pushed(q: f64, v: f64, t: f64, m: f64, g: f64, c: f64, push: f64, rate: f64) -> f64 {
    0.5 * m * v * v + m * g * q.cos()
}

/// The same as an energy.
#[hamiltonian(damping = 2.0 * c, force = push * (rate * t).cos())]
fn pushed_by_hand(q: f64, p: f64, t: f64, m: f64, g: f64, c: f64, push: f64, rate: f64) -> f64 {
    p * p / (2.0 * m) - m * g * q.cos()
}

/// A charge that turns, in air: a force that does no work, and one that takes energy.
#[hamiltonian(force = [b * v[1] - c * speed(v) * v[0], -b * v[0] - c * speed(v) * v[1]], with(speed))]
fn flying(q: [f64; 2], p: [f64; 2], m: f64, b: f64, c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2) / 4.0
}

/// |v|.
#[energy_function]
fn speed(v: [f64; 2]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

/// A pendulum in air.
#[lagrangian(rayleigh = c * v.abs().powi(3) / 3.0)]
fn in_air(q: f64, v: f64, m: f64, c: f64) -> f64 {
    0.5 * m * v * v + m * q.cos()
}

/// A spring that was written as a force.
#[lagrangian(force = -k * q * q * q)]
fn spring(q: f64, v: f64, m: f64, k: f64) -> f64 {
    0.5 * m * v * v
}

/// The same with a part of the friction as a term in the action, which adds −γp.
#[lagrangian(rayleigh = c * v * v, force = push * (rate * t).cos())]
fn pushed_and_braked(q: f64, v: f64, s: f64, t: f64, m: f64, g: f64, c: f64, gamma: f64, push: f64, rate: f64) -> f64 {
    0.5 * m * v * v + m * g * q.cos() - gamma * s
}

/// Forces that read the action, beside a mass matrix that reads it.
#[lagrangian(rayleigh = c * v[1].powi(4) * (1.0 + s * s), force = [u * q[1], 0.1 * v[0] * s, t.sin()])]
fn rubbed_and_growing(q: [f64; 3], v: [f64; 3], s: f64, t: f64, m: f64, c: f64, u: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    let kinetic = 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) * (1.0 + s * s / 20.0);
    kinetic - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]) - 0.2 * s - 0.1 * s * s
}

/// No force at all.
#[lagrangian(rayleigh = 0.0 * v, force = 0.0)]
fn unforced(q: f64, v: f64, s: f64) -> f64 {
    0.5 * v * v + q.cos() - 0.1 * s
}

const PUSHED: Pushed = Pushed { m: 1.0, g: 1.0, c: 0.1, push: 1.5, rate: 2.0 };
const M: [f64; 3] = [2.0, 1.0, 0.5];
const L: [f64; 3] = [1.0, 0.8, 0.5];

/// The end after so many steps of h.
type Run<'a> = &'a dyn Fn(f64, u64) -> State<f64>;

#[test]
fn a_pushed_pendulum_ends_where_it_should() {
    let expected = [-0.017_322_733_385_284_425, -0.115_481_938_132_368_35];
    let error = |method: &dyn Fn(f64, u64) -> State<f64>, h: f64| {
        let end = method(h, (6.0 / h).round() as u64);
        f64::max((end.q - expected[0]).abs(), (end.p - expected[1]).abs())
    };
    fn run<M: Method<Pushed>>(method: M) -> impl Fn(f64, u64) -> State<f64> {
        move |h, steps| {
            let mut sim = PUSHED.integrator(method, h, PUSHED.at(0.5, 0.0));
            sim.advance(steps).expect("steps");
            sim.state()
        }
    }
    let rows: [(Run<'_>, [f64; 3]); 3] = [
        (&run(Gauss::<1>), [1.24e-3, 3.11e-4, 7.78e-5]),
        (&run(Gauss::<2>), [5.59e-7, 3.50e-8, 2.19e-9]),
        (&run(Gauss::<3>), [3.25e-10, 5.08e-12, 8e-14]),
    ];
    for (method, published) in rows {
        for (h, published) in [0.1, 0.05, 0.025].into_iter().zip(published) {
            let found = error(method, h);
            assert!((found - published).abs() < 0.05 * published + 2e-14, "{found:.3e} {published:.3e}");
        }
    }
    let errors = [0.1, 0.05].map(|h| error(&run(DiscreteGradient), h));
    assert!(((errors[0] / errors[1]).log2() - 2.0).abs() < 0.1);
}

/// Written as an energy it is the same system.
#[test]
fn forces_are_for_energies_too() -> Result<(), StepError> {
    let by_hand = PushedByHand { m: 1.3, g: 0.9, c: 0.1, push: 1.5, rate: 2.0 };
    let system = Pushed { m: 1.3, g: 0.9, c: 0.1, push: 1.5, rate: 2.0 };
    fn ends<S: PhaseSpace<State = State<f64>>, M: Method<S>>(system: S, method: M, start: State<f64>) -> State<f64> {
        let mut sim = Integrator::new(system, method, 0.1, start);
        sim.advance(100).expect("steps");
        sim.state()
    }
    let start = system.at(0.5, 0.2);
    let same = |a: State<f64>, b: State<f64>| assert!((a.q - b.q).abs() < 1e-13 && (a.p - b.p).abs() < 1e-13);
    same(ends(system, Gauss::<2>, start), ends(by_hand, Gauss::<2>, start));
    same(ends(system, DiscreteGradient, start), ends(by_hand, DiscreteGradient, start));
    same(ends(system, DOP853, start), ends(by_hand, DOP853, start));
    Ok(())
}

/// Compares the polarised discrete gradient with its published errors, to 5 %. A step adds to the energy h times the power at the mean velocity.
#[test]
fn an_arm_is_driven_by_its_torques() -> Result<(), StepError> {
    let system = DrivenArm { m: M, l: L, g: 9.81 };
    let start = system.at([0.5, 0.4, -0.3], [0.0, 0.0, 1.0]);
    let end = |h: f64, steps: u64| -> Result<[[f64; 3]; 2], StepError> {
        let mut sim = system.integrator(DiscreteGradient, h, start);
        sim.advance(steps)?;
        Ok([sim.state().q, sim.state().p])
    };
    let mut exact = system.integrator(Gauss::<6>, 0.005, start);
    exact.advance(200)?;
    let exact = [exact.state().q, exact.state().p];
    for (h, published) in [(0.04, 9.72e-3), (0.02, 2.44e-3), (0.01, 6.09e-4), (0.005, 1.52e-4)] {
        let found = end(h, (1.0 / h).round() as u64)?;
        let error = (0..6).fold(0.0, |far, i| f64::max(far, (found[i / 3][i % 3] - exact[i / 3][i % 3]).abs()));
        assert!((error - published).abs() < 0.05 * published, "{error:.3e} in place of {published:.3e}");
    }
    let h = 0.05;
    let mut sim = system.integrator(DiscreteGradient, h, start);
    for _ in 0..100 {
        let (before, energy) = (sim.state(), sim.energy());
        sim.step()?;
        let after = sim.state();
        let (t, q, v) = middle(&before, &after, h);
        let torque = [t.sin(), 0.5 * (3.0 * t).cos(), q[0]];
        let friction =
            (1.0 + q[1] * q[1]) * (0.3 * v[0] * v[0] + 0.1 * v[0] * v[1] + 0.2 * v[1] * v[1] + 0.1 * v[2] * v[2]);
        let power = (0..3).map(|i| torque[i] * v[i]).sum::<f64>() - friction;
        assert!((sim.energy() - energy - h * power).abs() < 1e-13, "{:e}", sim.energy() - energy - h * power);
    }
    Ok(())
}

/// The middle of a step, with the mean velocity.
fn middle(before: &State<[f64; 3]>, after: &State<[f64; 3]>, h: f64) -> (f64, [f64; 3], [f64; 3]) {
    let q = std::array::from_fn(|i| 0.5 * (before.q[i] + after.q[i]));
    let v = std::array::from_fn(|i| (after.q[i] - before.q[i]) / h);
    (0.5 * (before.t + after.t), q, v)
}

/// Drag with the square of the velocity, and dry friction.
#[test]
fn friction_of_any_kind_takes_what_it_says() -> Result<(), StepError> {
    let system = ArmInAir { m: M, l: L, g: 9.81, air: 0.4, dry: 0.3 };
    let h = 0.05;
    let mut sim = system.integrator(DiscreteGradient, h, system.at([0.5, 0.4, -0.3], [0.0, 0.0, 1.0]));
    for _ in 0..200 {
        let (before, energy) = (sim.state(), sim.energy());
        sim.step()?;
        let (_, _, v) = middle(&before, &sim.state(), h);
        let dry = |v: f64| v * v / (v * v + 1e-2).sqrt();
        let power = 0.4 * v[2].abs().powi(3) + 0.3 * (dry(v[0]) + dry(v[1]));
        assert!((sim.energy() - energy + h * power).abs() < 1e-13, "{:e}", sim.energy() - energy + h * power);
        assert!(sim.energy() <= energy);
    }
    let order = |h: f64| -> Result<f64, StepError> {
        let mut sim = system.integrator(Gauss::<2>, h, system.at([0.5, 0.4, -0.3], [0.4, 0.3, 1.0]));
        sim.advance((0.5 / h).round() as u64)?;
        Ok(sim.state().q[0])
    };
    let [a, b, c] = [order(0.01)?, order(0.005)?, order(0.0025)?];
    assert!((((a - b) / (b - c)).log2() - 4.0).abs() < 0.3, "{}", ((a - b) / (b - c)).log2());
    Ok(())
}

/// d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v + F − ∂R/∂v: with ∂L/∂s = −γ it is the system without an action whose friction is c + γm/2.
#[test]
fn forces_add_to_an_action() -> Result<(), StepError> {
    let (c, gamma, m) = (0.1, 0.2, 1.3);
    let braked = PushedAndBraked { m, g: 0.9, c, gamma, push: 1.5, rate: 2.0 };
    let plain = Pushed { m, g: 0.9, c: c + 0.5 * gamma * m, push: 1.5, rate: 2.0 };
    let mut exact = plain.integrator(Gauss::<6>, 0.05, plain.at(0.5, 0.2));
    exact.advance(100)?;
    let exact = exact.state();
    fn error<M: Method<PushedAndBraked>>(system: PushedAndBraked, method: M, h: f64, exact: State<f64>) -> f64 {
        let mut sim = system.integrator(method, h, system.at(0.5, 0.2, 0.3));
        sim.advance((5.0 / h).round() as u64).expect("steps");
        f64::max((sim.state().q - exact.q).abs(), (sim.state().p - exact.p).abs())
    }
    let errors = [0.1, 0.05, 0.025].map(|h| error(braked, RK4, h, exact));
    for pair in errors.windows(2) {
        assert!(((pair[0] / pair[1]).log2() - 4.0).abs() < 0.1, "{errors:?}");
    }
    assert!(error(braked, DOP853, 0.05, exact) < 1e-13);
    assert!(error(PushedAndBraked { gamma: 0.21, ..braked }, DOP853, 0.05, exact) > 1e-3);
    // There and back, where friction feeds.
    let start = braked.at(0.5, 0.2, 0.3);
    let mut there = braked.integrator(DOP853, 0.05, start);
    there.advance(20)?;
    let mut back = braked.integrator(DOP853, -0.05, there.state());
    back.advance(20)?;
    let far = [back.state().q - start.q, back.state().p - start.p, back.state().s - start.s];
    assert!(far.iter().all(|far| far.abs() < 1e-13), "{far:?}");
    // A coefficient that feeds energy is refused. A coefficient of zero is accepted.
    let feeding = PushedAndBraked { c: -0.1, ..braked };
    let refused = feeding.integrator(RK4, 0.1, start).step().expect_err("friction that feeds");
    assert!(refused.to_string().contains("damping that is negative"), "{refused}");
    Unforced.integrator(ContactGauss::<2>, 0.1, Unforced.at(1.0, 0.0, 0.0)).step()
}

/// By two ways, with rates as they are emitted for steps and for series; and the balance p·v − L.
#[test]
fn forces_read_the_action() -> Result<(), StepError> {
    let system = RubbedAndGrowing { m: 1.3, c: 0.1, u: 0.3 };
    let start = system.at([0.5, 0.2, -0.3], [0.4, -0.1, 0.7], 0.3);
    let mut steps = system.integrator(DOP853, 0.02, start);
    steps.advance(50)?;
    let mut series = system.taylor(Taylor { tolerance: 1e-15 }, start);
    series.advance_to(1.0)?;
    let (a, b) = (steps.state(), series.state());
    assert!((0..3).all(|i| (a.q[i] - b.q[i]).abs() < 1e-12 && (a.p[i] - b.p[i]).abs() < 1e-12), "{a:?} {b:?}");
    assert!((a.s - b.s).abs() < 1e-12);
    // H' = −H ∂H/∂s + v·F − v·∂R/∂v, by a difference quotient of the energy along the flow.
    let energies = [-1.0, 1.0].map(|sign| {
        let mut run = system.integrator(DOP853, sign * 1e-3, start);
        run.step().map(|()| run.energy())
    });
    let [before, after] = energies;
    let found = (after? - before?) / 2e-3;
    let (v, q, s, energy) = (system.velocity(&start), start.q, start.s, system.energy(&start));
    let decay = {
        let growth = |s: f64| system.lagrangian(0.0, q, v, s);
        -(growth(s + 1e-5) - growth(s - 1e-5)) / 2e-5
    };
    let power = v[0] * 0.3 * q[1] + v[1] * 0.1 * v[0] * s;
    let expected = -energy * decay + power - 4.0 * 0.1 * v[1].powi(4) * (1.0 + s * s);
    assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    let report = RubbedAndGrowing::<f64>::REPORT;
    assert!(report.contains("no step is a contact map") && !report.contains("contact Gauss methods do"), "{report}");
    Ok(())
}

/// Power is v·F, of the velocity ∂H/∂p.
#[test]
fn forces_of_velocities() -> Result<(), StepError> {
    let (system, h) = (Flying { m: 1.7, b: 0.8, c: 0.3 }, 0.1);
    let mut sim = system.integrator(DiscreteGradient, h, State::new([1.0, 0.0], [0.0, 0.9]));
    for _ in 0..100 {
        let (before, energy) = (sim.state(), sim.energy());
        sim.step()?;
        let v = [0, 1].map(|i| (sim.state().q[i] - before.q[i]) / h);
        let speed = v[0].hypot(v[1]);
        assert!((sim.energy() - energy + h * 0.3 * speed.powi(3)).abs() < 1e-14);
    }
    let (mut rate, z) = ([[0.0; 2]; 2], [[1.0, 0.2], [0.3, 0.9]]);
    system.rate(0.0, &z, &mut rate);
    let v = z[1].map(|p| p / 1.7);
    let r = z[0][0] * z[0][0] + 2.0 * z[0][1] * z[0][1];
    let expected = -r * z[0][0] + 0.8 * v[1] - 0.3 * v[0].hypot(v[1]) * v[0];
    assert!((rate[1][0] - expected).abs() < 1e-15 && rate[0] == v);
    Ok(())
}

/// Friction with a negative coefficient is refused, like damping with a negative coefficient.
#[test]
fn friction_that_feeds_is_refused() {
    let run = |c: f64| {
        let system = InAir { m: 0.7, c };
        let mut sim = system.integrator(DiscreteGradient, 0.1, system.at(1.0, 0.5));
        sim.advance(10).map(|()| sim.energy())
    };
    assert!(run(0.2).is_ok());
    let refused = run(-0.2).expect_err("it would feed energy").to_string();
    assert!(refused.contains("friction that would feed energy"), "{refused}");
    #[lagrangian(rayleigh = c * v.powi(4))]
    fn with_an_action(q: f64, v: f64, s: f64, c: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q - 0.1 * s
    }
    let system = WithAnAction { c: -0.2 };
    let refused = system.integrator(DOP853, 0.1, system.at(1.0, 0.5, 0.0)).step().expect_err("the same").to_string();
    assert!(refused.contains("friction that would feed energy"), "{refused}");
    let system = ArmInAir { m: M, l: L, g: 9.81, air: -0.4, dry: 0.0 };
    let start = system.at([0.5, 0.4, -0.3], [0.0, 0.0, 1.0]);
    let mut sim = system.integrator(DiscreteGradient, 0.05, start);
    assert!(sim.step().is_err());
    assert_eq!(sim.state(), start);
}

/// A force of momenta that would have a potential if these were parameters.
#[hamiltonian(force = [-c * p[1], 0.0])]
fn dragged(q: [f64; 2], p: [f64; 2], c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0]
}

#[test]
fn reports_say_what_forces_do() {
    assert!(!Dragged::<f64>::REPORT.contains("this force has a potential"), "{}", Dragged::<f64>::REPORT);
    assert!(Spring::<f64>::REPORT.contains("this force has a potential"), "{}", Spring::<f64>::REPORT);
    assert!(!Pushed::<f64>::REPORT.contains("this force has a potential"), "{}", Pushed::<f64>::REPORT);
    assert!(Pushed::<f64>::REPORT.contains("- F = [push·cos(t·rate)]"), "{}", Pushed::<f64>::REPORT);
    assert!(ArmInAir::<f64>::REPORT.contains("friction −∂R/∂v with ∂R/∂v = ["), "{}", ArmInAir::<f64>::REPORT);
}
