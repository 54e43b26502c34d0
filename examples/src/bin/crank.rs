//! Which forces act in the bars of a driven linkage, and which torque must its motor give? Both follow from the multipliers.
//!
//! The crank's angle is a given function of time. Its end therefore has no coordinates, and the first constraint, the length of the coupler, reads time. The
//! bars have no mass. The joint C of coupler and rocker carries one, and a pendulum hangs from C. The path of C is known from geometry, an independent check.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Joint C and the mass P of the pendulum. The crank has the angle 0.3 + 2t. `bars` are crank, coupler and rocker; the rocker turns about (d, 0), and the
/// pendulum has the length l. Each constraint is (distance² − length²)/2, so its multiplier is a force divided by a length.
#[hamiltonian(constraint = [
    ((q[0] - bars[0] * (0.3 + 2.0 * t).cos()).powi(2) + (q[1] - bars[0] * (0.3 + 2.0 * t).sin()).powi(2)
        - bars[1] * bars[1]) / 2.0,
    ((q[0] - d).powi(2) + q[1].powi(2) - bars[2] * bars[2]) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - l * l) / 2.0
])]
fn crank(q: [f64; 4], p: [f64; 4], t: f64, m: [f64; 2], bars: [f64; 3], d: f64, l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0])
        + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1])
        + g * (m[0] * q[1] + m[1] * q[3])
}

const LINKAGE: Crank = Crank { m: [0.8, 0.5], bars: [0.4, 1.5, 1.0], d: 1.2, l: 0.7, g: 9.81 };
const H: f64 = 0.01;
const TIME: f64 = 20.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Crank::<f64>::REPORT);
    let path = run(DiscreteGradient, H, TIME)?;
    let off = largest(path.iter().map(|e| e.off));
    let error = |h: f64| -> Result<f64, StepError> {
        // The constraints alone determine C. The pendulum is compared with a run of order 8.
        let [end, reference] = [run(DiscreteGradient, h, 2.0)?, run(KahanLi8_17a.of(Rattle), 0.01, 2.0)?]
            .map(|run| run.last().map_or([0.0; 4], |end| end.q));
        Ok((end[2] - reference[2]).hypot(end[3] - reference[3]))
    };
    let (work, gained) = balance(&path);
    let rows = [
        ["largest distance of C from its path".into(), format!("{off:.1e}")],
        ["largest force in the coupler, in N".into(), format!("{:.2}", largest(path.iter().map(|e| e.coupler.abs())))],
        ["largest force in the rocker, in N".into(), format!("{:.2}", largest(path.iter().map(|e| e.rocker.abs())))],
        ["largest torque of the motor, in N m".into(), format!("{:.2}", largest(path.iter().map(|e| e.torque.abs())))],
        ["work of the motor in 20 s, in J".into(), format!("{work:.4}")],
        ["energy gained in 20 s, in J".into(), format!("{gained:.4}")],
    ];
    println!("{}", table(["", "DiscreteGradient, h = 0.01 s"], &rows));

    claim("the joint stays on its path to 1e-14", off < 1e-14)?;
    claim("the pendulum has order 2", (order(error(0.02)?, error(0.01)?) - 2.0).abs() < 0.1)?;
    // The torque is known at the ends of steps only: the trapezoidal rule sets the error.
    claim("the motor's work is the gain of energy to 1 %", (work / gained - 1.0).abs() < 1e-2)?;
    println!();
    draw(&path)
}

/// A state with its forces.
struct Sample {
    t: f64,
    q: [f64; 4],
    /// Distance of C from the intersection of two circles.
    off: f64,
    /// Forces in bars; a pull is positive.
    coupler: f64,
    rocker: f64,
    /// Torque of the motor on the crank.
    torque: f64,
    energy: f64,
}

/// Returns the states of a run, and the forces in each of them. The pendulum starts 0.5 rad from below, and moves with C.
fn run<M: Method<Crank>>(method: M, h: f64, time: f64) -> Result<Vec<Sample>, StepError> {
    let [x, y] = joint(0.0);
    let (sin, cos) = 0.5_f64.sin_cos();
    // The velocity of C, to 1e-8. The state is then moved onto the constraints.
    let [u, w] = [0, 1].map(|i| (joint(1e-4)[i] - joint(-1e-4)[i]) / 2e-4);
    let [first, second] = LINKAGE.m;
    let near = State::new([x, y, x + 0.7 * sin, y - 0.7 * cos], [first * u, first * w, second * u, second * w]);
    let mut sim = Integrator::new(LINKAGE, method, h, LINKAGE.state_on_constraint(&near)?);
    let mut samples = vec![];
    for _ in 0..=(time / h).round() as u32 {
        let (State { t, q, .. }, [coupler, rocker, _]) = (sim.state(), sim.multipliers());
        let (on_path, crank) = (joint(t), crank_end(t));
        // The coupler pulls the crank's end towards C, and the motor holds against the torque of this pull.
        let pull = [0, 1].map(|i| coupler * (q[i] - crank[i]));
        samples.push(Sample {
            t,
            q,
            off: (q[0] - on_path[0]).hypot(q[1] - on_path[1]),
            coupler: coupler * LINKAGE.bars[1],
            rocker: rocker * LINKAGE.bars[2],
            torque: crank[1] * pull[0] - crank[0] * pull[1],
            energy: sim.energy(),
        });
        sim.step()?;
    }
    Ok(samples)
}

/// The work of the motor by the trapezoidal rule, ½ (τ₀ + τ₁) ω per unit of time with the rate ω = 2 rad/s of the crank, and the gain of energy.
fn balance(path: &[Sample]) -> (f64, f64) {
    let work = path.windows(2).map(|pair| (pair[1].t - pair[0].t) * (pair[0].torque + pair[1].torque));
    let [first, last] = [path.first(), path.last()].map(|sample| sample.map_or(0.0, |sample| sample.energy));
    (work.sum(), last - first)
}

fn crank_end(t: f64) -> [f64; 2] {
    let (sin, cos) = (0.3 + 2.0 * t).sin_cos();
    [LINKAGE.bars[0] * cos, LINKAGE.bars[0] * sin]
}

/// The joint C: the upper intersection of the circles of coupler and rocker.
fn joint(t: f64) -> [f64; 2] {
    let [_, coupler, rocker] = LINKAGE.bars;
    let b = crank_end(t);
    let e = [LINKAGE.d - b[0], -b[1]];
    let square = e[0] * e[0] + e[1] * e[1];
    let along = ((coupler * coupler - rocker * rocker) / square + 1.0) / 2.0;
    let across = (coupler * coupler / square - along * along).sqrt();
    [b[0] + along * e[0] - across * e[1], b[1] + along * e[1] + across * e[0]]
}

fn draw(path: &[Sample]) -> Result<(), Box<dyn Error>> {
    let turns = &path[..1000.min(path.len())];
    let mut curves = vec![
        Curve::line("joint C", palette::GREEN, turns.iter().map(|e| (e.q[0], e.q[1])).collect()).width(2.4).solid(),
        Curve::line("pendulum", palette::BLUE, turns.iter().map(|e| (e.q[2], e.q[3])).collect()).width(1.0).solid(),
    ];
    let (q, [x, y]) = (path[0].q, crank_end(0.0));
    let bars = vec![(0.0, 0.0), (x, y), (q[0], q[1]), (LINKAGE.d, 0.0)];
    curves.push(Curve::line("bars", palette::BLACK, bars.clone()).solid());
    curves.push(Curve::line("", palette::BLACK, vec![(q[0], q[1]), (q[2], q[3])]).solid());
    curves.push(Curve::dots("", palette::BLACK, bars));
    let linkage = Panel::new(
        "A linkage with a motor",
        "DiscreteGradient, h = 0.01 s, for 10 s",
        [Axis::linear("x in m", -0.5..2.1), Axis::linear("y in m", -0.5..1.45)],
        curves,
    )
    .equal();
    let forces = vec![
        Curve::line("coupler", palette::VERMILION, path.iter().map(|e| (e.t, e.coupler)).collect()).solid(),
        Curve::line("rocker", palette::BLUE, path.iter().map(|e| (e.t, e.rocker)).collect()).solid(),
    ];
    let range = |of: fn(&Sample) -> f64| largest(path.iter().map(|e| of(e).abs())).ceil();
    let most = range(|e| e.coupler).max(range(|e| e.rocker));
    let bearings = Panel::new(
        "Forces in the bars",
        "from the multipliers of each state; a pull is positive",
        [Axis::linear("time in s", 0.0..TIME), Axis::linear("force in N", -most..most)],
        forces,
    );
    figure("crank.svg", (4, 3), &[linkage, bearings])
}
