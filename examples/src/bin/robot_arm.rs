//! Is the energy balance of a robot arm with motors and friction exact? Six links, with a Lagrangian by recursion.
//!
//! The program computes the velocities from link to link. It contains no mass matrix, no inverse and no forces: steps solve for six velocities
//! with derivatives of L. In each step the change of the energy is exactly the work of the motors minus the heat in the joints.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, shortest, table};
use geoint_runtime::prelude::*;
use std::error::Error;

/// Links along their own third axes. Joints turn about that axis and about the first one by turns; q[0] is the angle of the base about the
/// vertical.
#[lagrangian(
    rayleigh = 0.5 * friction * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3] + v[4] * v[4] + v[5] * v[5]),
    force = [torque * (0.7 * t).sin(), torque * (1.1 * t).cos(), 0.2 * torque * (1.9 * t).sin(),
             0.4 * torque * (1.3 * t).sin(), 0.02 * torque * t.cos(), 0.1 * torque * (2.3 * t).cos()]
)]
fn robot_arm(
    q: [f64; 6],
    v: [f64; 6],
    t: f64,
    m: [f64; 6],
    length: [f64; 6],
    radius: f64,
    g: f64,
    friction: f64,
    torque: f64,
) -> f64 {
    // In the frame of a link: its angular velocity, the velocity of its near end, and the direction up.
    let (mut w, mut u, mut up) = ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let (mut height, mut sum) = (0.0, 0.0);
    for i in 0..6 {
        let (sin, cos) = q[i].sin_cos();
        let turned = |x: [f64; 3]| {
            if i % 2 == 0 {
                [cos * x[0] + sin * x[1], cos * x[1] - sin * x[0], x[2]]
            } else {
                [x[0], cos * x[1] + sin * x[2], cos * x[2] - sin * x[1]]
            }
        };
        (w, u, up) = (turned(w), turned(u), turned(up));
        w[if i % 2 == 0 { 2 } else { 0 }] += v[i];
        let half = 0.5 * length[i];
        // The velocity of the middle, and of the far end.
        let middle = [u[0] + half * w[1], u[1] - half * w[0], u[2]];
        u = [u[0] + length[i] * w[1], u[1] - length[i] * w[0], u[2]];
        let [across, along] =
            [m[i] * (length[i] * length[i] / 12.0 + radius * radius / 4.0), 0.5 * m[i] * radius * radius];
        sum += 0.5 * m[i] * (middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2])
            + 0.5 * across * (w[0] * w[0] + w[1] * w[1])
            + 0.5 * along * w[2] * w[2]
            - m[i] * g * (height + half * up[2]);
        height += length[i] * up[2];
    }
    sum
}

const ARM: RobotArm = RobotArm {
    m: [6.0, 5.0, 2.5, 2.0, 0.8, 0.4],
    length: [0.4, 0.5, 0.25, 0.25, 0.1, 0.1],
    radius: 0.06,
    g: 9.81,
    friction: 0.5,
    torque: 6.0,
};
const H: f64 = 0.01;

/// Energy balance since the start: change of the energy, work of the motors, and heat in the joints, in J.
#[derive(Clone, Copy, Default)]
struct Balance {
    t: f64,
    energy: f64,
    motors: f64,
    joints: f64,
}

impl Balance {
    fn error(&self) -> f64 {
        self.energy - self.motors + self.joints
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let lines = RobotArm::<f64>::REPORT.lines();
    let told = |line: &&str| {
        ["steps are solved", "stage of a Newton", "discrete gradient, the", "they add"]
            .iter()
            .any(|part| line.contains(part))
    };
    println!("{}\n", lines.filter(told).collect::<Vec<_>>().join("\n"));
    let (balance, tip) = run(2000)?;
    let last = balance[balance.len() - 1];
    let largest = |of: fn(&Balance) -> f64| balance.iter().fold(0.0, |most, b| f64::max(most, of(b).abs()));
    let rows = [
        ["energy".into(), format!("{:.3} J", last.energy)],
        ["work of the motors".into(), format!("{:.3} J", last.motors)],
        ["heat in the joints".into(), format!("{:.3} J", last.joints)],
        ["energy − work + heat, at most".into(), format!("{:.0e} J", largest(Balance::error))],
    ];
    println!("{}", table(["since the start, after 20 s", "discrete gradient, h = 0.01"], &rows));
    for (name, time) in [("discrete gradient", time(DiscreteGradient)?), ("midpoint rule", time(ImplicitMidpoint)?)] {
        println!("{name}: {time:.1} µs a step");
    }
    println!();
    claim("the balance is closed to 1e-10 J of some hundred", {
        largest(Balance::error) < 1e-10 && largest(|b| b.motors) > 100.0
    })?;
    let ends = [0.01, 0.005, 0.0025].map(end);
    let [whole, half, quarter] = ends;
    let (whole, half, quarter) = (whole?, half?, quarter?);
    let order = (distance(whole, half) / distance(half, quarter)).log2();
    claim("its order is 2", (order - 2.0).abs() < 0.2)?;
    println!();
    draw(&balance, tip)
}

fn start() -> State<[f64; 6]> {
    ARM.at([0.0, 0.6, 0.0, 1.2, 0.0, 0.8], [0.0; 6])
}

/// Points in the plane of a figure.
type Path = Vec<(f64, f64)>;

/// Returns the balance after each step, and the path of the hand.
fn run(steps: usize) -> Result<(Vec<Balance>, Path), StepError> {
    let mut sim = ARM.integrator(DiscreteGradient, H, start());
    let before = sim.energy();
    let (mut balance, mut now) = (vec![Balance::default()], Balance::default());
    let mut tip = vec![hand(sim.state().q)];
    for _ in 0..steps {
        let last = sim.state();
        sim.step()?;
        let (t, next) = (0.5 * (last.t + sim.state().t), sim.state());
        let mean: [f64; 6] = std::array::from_fn(|i| (next.q[i] - last.q[i]) / H);
        let torques = [
            (0.7 * t).sin(),
            (1.1 * t).cos(),
            0.2 * (1.9 * t).sin(),
            0.4 * (1.3 * t).sin(),
            0.02 * t.cos(),
            0.1 * (2.3 * t).cos(),
        ];
        now.motors += H * ARM.torque * (0..6).map(|i| torques[i] * mean[i]).sum::<f64>();
        now.joints += H * ARM.friction * mean.iter().map(|v| v * v).sum::<f64>();
        (now.t, now.energy) = (next.t, sim.energy() - before);
        balance.push(now);
        tip.push(hand(next.q));
    }
    Ok((balance, tip))
}

/// Returns the far end of the last link: its distance from the axis, and its height.
fn hand(q: [f64; 6]) -> (f64, f64) {
    let mut at = [0.0, 0.0, 0.0];
    for i in (0..6).rev() {
        at[2] += ARM.length[i];
        let (sin, cos) = q[i].sin_cos();
        at = if i % 2 == 0 {
            [cos * at[0] - sin * at[1], cos * at[1] + sin * at[0], at[2]]
        } else {
            [at[0], cos * at[1] - sin * at[2], cos * at[2] + sin * at[1]]
        };
    }
    (at[0].hypot(at[1]), at[2])
}

/// Microseconds a step.
fn time<M: geoint_runtime::Method<RobotArm>>(method: M) -> Result<f64, StepError> {
    let time = shortest(|| ARM.integrator(method, 0.001, start()).advance(1000))?;
    Ok(time.as_secs_f64() * 1e3)
}

/// Angles after a second.
fn end(h: f64) -> Result<[f64; 6], StepError> {
    let mut sim = ARM.integrator(DiscreteGradient, h, start());
    sim.advance((1.0 / h).round() as u64)?;
    Ok(sim.state().q)
}

fn distance(a: [f64; 6], b: [f64; 6]) -> f64 {
    (0..6).fold(0.0, |most, i| f64::max(most, (a[i] - b[i]).abs()))
}

fn draw(balance: &[Balance], tip: Vec<(f64, f64)>) -> Result<(), Box<dyn Error>> {
    let of = |value: fn(&Balance) -> f64| balance.iter().step_by(4).map(|b| (b.t, value(b))).collect::<Vec<_>>();
    let energies = Panel::new(
        "Energy balance of an arm of six links",
        "discrete gradient, h = 0.01 s",
        [Axis::linear("time in s", 0.0..20.0), Axis::linear("since the start, in J", -150.0..350.0)],
        vec![
            Curve::line("work of motors", palette::BLUE, of(|b| b.motors)),
            Curve::line("heat in joints", palette::VERMILION, of(|b| b.joints)),
            Curve::line("energy", palette::GREEN, of(|b| b.energy)),
        ],
    );
    let error = Panel::new(
        "Error of energy − work + heat",
        "discrete gradient, h = 0.01 s; rounding of energies of some 100 J",
        [Axis::linear("time in s", 0.0..20.0), Axis::decades("|error of the balance| in J", -16.0..-8.0)],
        vec![Curve::line("discrete gradient", palette::BLACK, of(|b| b.error().abs())).rounding().width(1.0)],
    );
    let way = Panel::new(
        "Path of the hand",
        "discrete gradient, h = 0.01 s, for 20 s",
        [Axis::linear("distance from the axis in m", -0.1..1.3), Axis::linear("height in m", -1.0..1.0)],
        vec![Curve::line("hand", palette::BLUE, tip).solid().width(1.0)],
    );
    figure("robot_arm.svg", (4, 3), &[energies, error, way])
}
