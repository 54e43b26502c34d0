//! Which forces act in the bars of a driven linkage, and which torque must its motor give? Both follow from the multipliers.
//!
//! A motor turns the crank about (0, 0). The coupler joins the end of the crank to the joint C, and the rocker joins C to a fixed point. The bars have no
//! mass. C carries one, and a pendulum hangs from C.
//!
//! The crank's angle is a given function of time. The end of the crank therefore has no coordinates, and the first constraint, the length of the coupler,
//! depends on time. Two constraints determine the two coordinates of C. The path of C thus follows from geometry. This is an independent check.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// q is the joint C, then the mass P of the pendulum; m are their masses. The crank has the angle 0.3 + 2t. `bars` are the lengths of crank, coupler and
/// rocker. The rocker turns about (d, 0). The pendulum has the length l.
///
/// Each constraint is (distance² − length²)/2. Its gradient is as long as its bar, so a multiplier is the force in the bar divided by the bar's length.
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
    let deviation = largest(path.iter().map(|x| x.deviation));
    let error = |h: f64| -> Result<f64, StepError> {
        // The constraints alone determine C, so only P has an error of order 2. The reference is a run of order 8.
        let [end, reference] = [run(DiscreteGradient, h, 2.0)?, run(KahanLi8_17a.of(Rattle), 0.01, 2.0)?]
            .map(|run| run.last().map_or([0.0; 4], |end| end.q));
        Ok((end[2] - reference[2]).hypot(end[3] - reference[3]))
    };
    let (work, gained) = balance(&path);
    let rows = [
        ["largest distance of C from its path".into(), format!("{deviation:.1e}")],
        ["largest force in the coupler, in N".into(), format!("{:.2}", largest(path.iter().map(|x| x.coupler.abs())))],
        ["largest force in the rocker, in N".into(), format!("{:.2}", largest(path.iter().map(|x| x.rocker.abs())))],
        ["largest torque of the motor, in N m".into(), format!("{:.2}", largest(path.iter().map(|x| x.torque.abs())))],
        ["work of the motor in 20 s, in J".into(), format!("{work:.4}")],
        ["energy gained in 20 s, in J".into(), format!("{gained:.4}")],
    ];
    println!("{}", table(["", "DiscreteGradient, h = 0.01 s"], &rows));

    // The step solves the constraints to rounding, and they determine C.
    claim("the joint stays on its path to 1e-14", deviation < 1e-14)?;
    claim("the pendulum has order 2", (order(error(0.02)?, error(0.01)?) - 2.0).abs() < 0.1)?;
    // The torque is known at the ends of steps only. Torques and trapezoidal rule have errors of order h², for which 1 % leaves room.
    claim("the motor's work is the gain of energy to 1 %", (work / gained - 1.0).abs() < 1e-2)?;
    println!();
    draw(&path)
}

/// A state with its forces.
struct Sample {
    t: f64,
    q: [f64; 4],
    /// Distance of C from its path, known from geometry.
    deviation: f64,
    /// Force in the coupler. A pull is positive.
    coupler: f64,
    /// Force in the rocker. A pull is positive.
    rocker: f64,
    /// Torque of the motor on the crank, positive against the clock.
    torque: f64,
    /// Energy of both masses. The motor changes it.
    energy: f64,
}

/// Returns the states of a run from 0 to `time`, with their forces. The pendulum starts 0.5 rad from its lowest position, with the velocity of C.
fn run<M: Method<Crank>>(method: M, h: f64, time: f64) -> Result<Vec<Sample>, StepError> {
    let [x, y] = joint(0.0);
    let (sin, cos) = 0.5_f64.sin_cos();
    // The velocity (u, w) of C by central differences, with an error near 1e-8. `state_on_constraint` removes it.
    let [u, w] = [0, 1].map(|i| (joint(1e-4)[i] - joint(-1e-4)[i]) / 2e-4);
    let [first, second] = LINKAGE.m;
    let near = State::new([x, y, x + 0.7 * sin, y - 0.7 * cos], [first * u, first * w, second * u, second * w]);
    let mut sim = Integrator::new(LINKAGE, method, h, LINKAGE.state_on_constraint(&near)?);
    let mut samples = vec![];
    for _ in 0..=(time / h).round() as u32 {
        let (State { t, q, .. }, [coupler, rocker, _]) = (sim.state(), sim.multipliers());
        let (on_path, crank) = (joint(t), crank_end(t));
        // The coupler pulls the crank's end towards C. The crank has no mass, so the torques of this pull and of the motor add up to 0.
        let pull = [0, 1].map(|i| coupler * (q[i] - crank[i]));
        samples.push(Sample {
            t,
            q,
            deviation: (q[0] - on_path[0]).hypot(q[1] - on_path[1]),
            coupler: coupler * LINKAGE.bars[1],
            rocker: rocker * LINKAGE.bars[2],
            torque: crank[1] * pull[0] - crank[0] * pull[1],
            energy: sim.energy(),
        });
        sim.step()?;
    }
    Ok(samples)
}

/// Returns the work of the motor and the gain of energy. A step adds h ω (τ₀ + τ₁)/2 to the work, by the trapezoidal rule. The crank turns with ω = 2 rad/s,
/// so the factors ω and 1/2 cancel.
fn balance(path: &[Sample]) -> (f64, f64) {
    let work = path.windows(2).map(|pair| (pair[1].t - pair[0].t) * (pair[0].torque + pair[1].torque));
    let [first, last] = [path.first(), path.last()].map(|sample| sample.map_or(0.0, |sample| sample.energy));
    (work.sum(), last - first)
}

/// Returns the end of the crank.
fn crank_end(t: f64) -> [f64; 2] {
    let (sin, cos) = (0.3 + 2.0 * t).sin_cos();
    [LINKAGE.bars[0] * cos, LINKAGE.bars[0] * sin]
}

/// Returns the joint C: the upper intersection of two circles, about the end of the crank with the length of the coupler, and about (d, 0) with the length
/// of the rocker.
fn joint(t: f64) -> [f64; 2] {
    let [_, coupler, rocker] = LINKAGE.bars;
    let end = crank_end(t);
    // From the centre of the first circle to that of the second. C has the components `along` and `across` in units of this vector.
    let base = [LINKAGE.d - end[0], -end[1]];
    let square = base[0] * base[0] + base[1] * base[1];
    let along = ((coupler * coupler - rocker * rocker) / square + 1.0) / 2.0;
    let across = (coupler * coupler / square - along * along).sqrt();
    [end[0] + along * base[0] - across * base[1], end[1] + along * base[1] + across * base[0]]
}

fn draw(path: &[Sample]) -> Result<(), Box<dyn Error>> {
    // 1000 steps of 0.01 s are 10 s, about three turns of the crank.
    let turns = &path[..1000.min(path.len())];
    let mut curves = vec![
        Curve::line("joint C", palette::GREEN, turns.iter().map(|x| (x.q[0], x.q[1])).collect()).width(2.4).solid(),
        Curve::line("pendulum", palette::BLUE, turns.iter().map(|x| (x.q[2], x.q[3])).collect()).width(1.0).solid(),
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
        Curve::line("coupler", palette::VERMILION, path.iter().map(|x| (x.t, x.coupler)).collect()).solid(),
        Curve::line("rocker", palette::BLUE, path.iter().map(|x| (x.t, x.rocker)).collect()).solid(),
    ];
    let range = |of: fn(&Sample) -> f64| largest(path.iter().map(|x| of(x).abs())).ceil();
    let most = range(|x| x.coupler).max(range(|x| x.rocker));
    let forces = Panel::new(
        "Forces in the bars",
        "from the multipliers of each state; a pull is positive",
        [Axis::linear("time in s", 0.0..TIME), Axis::linear("force in N", -most..most)],
        forces,
    );
    figure("crank.svg", (4, 3), &[linkage, forces])
}
