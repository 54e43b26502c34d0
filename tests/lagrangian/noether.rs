//! Noether's quantities of Lagrangians without an energy in closed form, and total derivatives that are left out of the motion.

use crate::references::DOUBLE_PENDULUM;
use crate::systems::*;
use geoint_runtime::prelude::*;

/// A chain of three rods on a table, by angles against one direction: all of them may turn together.
#[lagrangian]
fn on_a_table(q: [f64; 3], v: [f64; 3], m: [f64; 3], k: f64) -> f64 {
    let squares = m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2];
    let coupled = m[1] * v[0] * v[1] * (q[0] - q[1]).cos()
        + m[2] * (v[1] * v[2] * (q[1] - q[2]).cos() + 0.5 * v[0] * v[2] * (q[0] - q[2]).cos());
    squares + 0.4 * coupled - k * (q[1] - q[0]).powi(2) * (1.0 + (q[2] - q[1]).powi(2))
}

/// Two masses in the plane with something between them that resists being drawn out, as a mass does: all of it may turn, and move away.
#[lagrangian]
fn telescope(q: [[f64; 2]; 2], v: [[f64; 2]; 2], m: [f64; 2], c: f64) -> f64 {
    let [x, y] = [q[1][0] - q[0][0], q[1][1] - q[0][1]];
    let drawn = x * (v[1][0] - v[0][0]) + y * (v[1][1] - v[0][1]);
    0.5 * m[0] * (v[0][0] * v[0][0] + v[0][1] * v[0][1])
        + 0.5 * m[1] * (v[1][0] * v[1][0] + v[1][1] * v[1][1])
        + 0.5 * c * drawn * drawn
        - (x * x + y * y).powi(2)
}

/// The same with friction in its middle joint, and a push on the last rod: neither lets all turn freely.
#[lagrangian(force = [0.0, 0.0, 0.3])]
fn pushed_on_a_table(q: [f64; 3], v: [f64; 3], m: [f64; 3]) -> f64 {
    let squares = m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2];
    squares + 0.4 * m[1] * (v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos())
}

const TABLE: OnATable = OnATable { m: [2.0, 1.0, 0.5], k: 0.7 };
const TELESCOPE: Telescope = Telescope { m: [1.3, 0.7], c: 0.4 };

/// The largest change of a function of the state in 200 steps of 0.05.
macro_rules! change {
    ($system:expr, $method:expr, $start:expr, $of:expr) => {{
        let mut sim = $system.integrator($method, 0.05, $start);
        let before = $of(&sim.state());
        let mut change: f64 = 0.0;
        for _ in 0..200 {
            sim.step().expect("a step");
            change = change.max(($of(&sim.state()) - before).abs());
        }
        change
    }};
}

#[test]
fn sums_of_momenta_stay() {
    let report = OnATable::<f64>::REPORT;
    assert!(report.contains("- total momentum: p[0] + p[1] + p[2]"), "{report}");
    assert!(report.contains("`DiscreteGradient` keeps all of these, to rounding"), "{report}");
    let start = TABLE.at([0.5, 0.4, -0.3], [0.7, 0.2, 1.0]);
    let total = |state: &State<[f64; 3]>| state.p.iter().sum::<f64>();
    for change in [
        change!(TABLE, ImplicitMidpoint, start, total),
        change!(TABLE, Gauss::<2>, start, total),
        change!(TABLE, Gauss::<3>, start, total),
        change!(TABLE, DiscreteGradient, start, total),
        change!(TABLE, Suzuki4.of(DiscreteGradient), start, total),
    ] {
        assert!(change < 1e-12, "{change:e}");
    }
    // A force on one of the rods breaks this conservation law.
    assert!(!PushedOnATable::<f64>::REPORT.contains("total momentum"), "{}", PushedOnATable::<f64>::REPORT);
}

/// The angular momentum is bilinear in q and p, so Gauss methods keep it. If the mass matrix takes part in the rotation, the polarised discrete
/// gradient keeps it only to the order of the method. The report says so.
#[test]
fn angular_momenta_stay_under_gauss_methods() {
    let report = Telescope::<f64>::REPORT;
    for line in [
        "- total momentum along x: ",
        "- total momentum along y: ",
        "- angular momentum: ",
        "`DiscreteGradient` keeps all of these but the angular momentum, to rounding",
    ] {
        assert!(report.contains(line), "{line}: {report}");
    }
    let start = TELESCOPE.at([[0.1, 0.2], [0.9, -0.3]], [[0.2, 0.5], [-0.4, 0.1]]);
    let along_x = |state: &State<[[f64; 2]; 2]>| state.p[0][0] + state.p[1][0];
    let about = |state: &State<[[f64; 2]; 2]>| {
        (0..2).map(|i| state.q[i][0] * state.p[i][1] - state.q[i][1] * state.p[i][0]).sum::<f64>()
    };
    macro_rules! changes {
        ($($method:expr),*) => { [$([change!(TELESCOPE, $method, start, along_x), change!(TELESCOPE, $method, start, about)]),*] };
    }
    for [linear, bilinear] in changes!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>) {
        assert!(linear < 1e-12 && bilinear < 1e-12, "{linear:e} {bilinear:e}");
    }
    let [[linear, bilinear]] = changes!(DiscreteGradient);
    assert!(linear < 1e-12 && bilinear > 1e-6, "{linear:e} {bilinear:e}");
    // Explicit methods keep the linear momentum.
    let [[linear, bilinear]] = changes!(RK4);
    assert!(linear < 1e-12 && bilinear > 1e-8, "{linear:e} {bilinear:e}");
}

/// A derivative d/dt of a function of position in L changes the momenta, but not the motion.
#[test]
fn derivatives_along_the_motion_are_named() {
    #[lagrangian]
    fn plain(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        0.5 * m * (v[0] * v[0] + v[1] * v[1]) - (q[0] * q[1]).cos() - q[0].powi(4) - q[1] * q[1]
    }
    /// d/dt (q₀²q₁ + 0.3 sin q₁) more.
    #[lagrangian]
    fn gauged(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        0.5 * m * (v[0] * v[0] + v[1] * v[1]) - (q[0] * q[1]).cos() - q[0].powi(4) - q[1] * q[1]
            + 2.0 * q[0] * q[1] * v[0]
            + (q[0] * q[0] + 0.3 * q[1].cos()) * v[1]
    }
    let report = Gauged::<f64>::REPORT;
    assert!(report.contains("what is linear in velocities is d/dt f with f = "), "{report}");
    // A magnetic field is no such derivative.
    assert!(!Charge::<f64>::REPORT.contains("d/dt f"), "{}", Charge::<f64>::REPORT);
    let (plain, gauged) = (Plain { m: 0.7 }, Gauged { m: 0.7 });
    let (q, v) = ([0.5, -0.3], [0.2, 0.6]);
    let mut one = plain.integrator(Gauss::<6>, 0.02, plain.at(q, v));
    let mut other = gauged.integrator(Gauss::<6>, 0.02, gauged.at(q, v));
    for sim in [0, 1] {
        let advanced = if sim == 0 { one.advance(100) } else { other.advance(100) };
        advanced.expect("steps");
    }
    let (one, other) = (one.state(), other.state());
    let shift = [2.0 * other.q[0] * other.q[1], other.q[0].powi(2) + 0.3 * other.q[1].cos()];
    for i in 0..2 {
        assert!((one.q[i] - other.q[i]).abs() < 1e-13);
        assert!((one.p[i] + shift[i] - other.p[i]).abs() < 1e-13);
    }
    // Steps in other momenta are others.
    let mut one = plain.integrator(ImplicitMidpoint, 0.1, plain.at(q, v));
    let mut other = gauged.integrator(ImplicitMidpoint, 0.1, gauged.at(q, v));
    [one.step(), other.step()].into_iter().for_each(|step| step.expect("a step"));
    let apart = (one.state().q[0] - other.state().q[0]).abs();
    assert!((1e-8..1e-3).contains(&apart), "{apart:e}");
}

/// Two positions of the midpoint rule determine its momenta: in angles with an energy, and for three rods without an energy.
#[test]
fn two_positions_are_a_start() -> Result<(), StepError> {
    macro_rules! returns {
        ($($system:expr, $start:expr;)*) => { $(
            let (system, h) = ($system, 0.05);
            let mut sim = system.integrator(ImplicitMidpoint, h, $start);
            for _ in 0..5 {
                let before = sim.state();
                sim.step()?;
                let after = sim.state();
                let found = system.from_positions(after.t, before.q, after.q, h);
                assert_eq!((found.t, found.q), (after.t, after.q));
                assert!(found.p.iter().zip(after.p).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {after:?}");
            }
        )* };
    }
    returns! {
        DOUBLE_PENDULUM, DOUBLE_PENDULUM.at([0.0, 1.4], [0.3, 0.0]);
        TABLE, TABLE.at([0.5, 0.4, -0.3], [0.7, 0.2, 1.0]);
    }
    Ok(())
}
