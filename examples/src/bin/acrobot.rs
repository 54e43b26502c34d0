//! Does the energy of an acrobot stay constant at the step size of its simulator?
//!
//! The acrobot has two links that swing freely. The data are those of Gymnasium's Acrobot: masses, lengths and moments of inertia are 1, and
//! centres of mass are in the middle. A step is 0.2 s. Gymnasium applies RK4 to angles and rates; this program applies it to angles and
//! momenta. The step is too long for an accurate path. The discrete gradient still keeps the energy to rounding.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, order, table};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use std::error::Error;

/// `q[0]`: angle of the first link from hanging. `q[1]`: angle of the second link from the direction of the first. L is T − V of each link.
#[lagrangian]
fn acrobot(q: [f64; 2], v: [f64; 2], g: f64) -> f64 {
    let (a, b) = (q[0], q[0] + q[1]);
    let (u, w) = (v[0], v[0] + v[1]);
    let first = 0.5 * (0.25 + 1.0) * u * u + 0.5 * g * a.cos();
    let second = 0.5 * (u * u + 0.25 * w * w + u * w * q[1].cos()) + 0.5 * w * w + g * (a.cos() + 0.5 * b.cos());
    first + second
}

const SYSTEM: Acrobot = Acrobot { g: 9.8 };
/// In s, as in Gymnasium.
const STEP: f64 = 0.2;
const STARTS: [[f64; 2]; 2] = [[1.0, 0.0], [2.0, 0.5]];

fn main() -> Result<(), Box<dyn Error>> {
    let rest = SYSTEM.energy(&SYSTEM.at([0.0; 2], [0.0; 2]));
    let mut rows = vec![];
    let mut errors_by_start = vec![];
    for start in STARTS {
        let above = SYSTEM.energy(&SYSTEM.at(start, [0.0; 2])) - rest;
        let errors = [largest(&run(RK4, start)?), largest(&run(DiscreteGradient, start)?)];
        rows.push([
            format!("{start:?}"),
            format!("{above:.2}"),
            format!("{:.1e}", errors[0]),
            format!("{:.1e}", errors[1]),
        ]);
        errors_by_start.push((above, errors));
    }
    println!("{}", table(["start", "energy above rest", "RK4 is off by", "discrete gradient"], &rows));

    let path_errors =
        [0.1, 0.05, 0.025].map(|h| end(DiscreteGradient, h).and_then(|q| Ok(distance(q, end(Gauss::<4>, 0.01)?))));
    let [whole, half, quarter] = path_errors;
    let orders = [order(whole?, half?), order(half?, quarter?)];
    let [(low, [slow, _]), (high, [fast, _])] = errors_by_start[..] else { return Err("two starts".into()) };
    // The second motion is chaotic: its path and the error of RK4 depend on rounding.
    claim("RK4 is off by 0.7 of 9.0, and by a quarter to a half of 29.6, within 100 s", {
        (slow - 0.7).abs() < 0.05
            && fast > 0.25 * high
            && fast < 0.5 * high
            && (low - 9.0).abs() < 0.05
            && (high - 29.6).abs() < 0.1
    })?;
    claim("the discrete gradient keeps the energy to 1e-12 and 1e-11", {
        errors_by_start[0].1[1] < 1e-12 && errors_by_start[1].1[1] < 1e-11
    })?;
    claim("its path is of order 2", orders.iter().all(|order| (order - 2.0).abs() < 0.1))?;
    println!();
    draw()
}

/// Returns times up to 100 s, each with the change of the energy since the start.
fn run<M: Method<Acrobot>>(method: M, start: [f64; 2]) -> Result<Vec<(f64, f64)>, StepError> {
    let mut sim = SYSTEM.integrator(method, STEP, SYSTEM.at(start, [0.0; 2]));
    let before = sim.energy();
    let mut samples = vec![];
    for _ in 0..500 {
        sim.step()?;
        samples.push((sim.state().t, sim.energy() - before));
    }
    Ok(samples)
}

fn largest(samples: &[(f64, f64)]) -> f64 {
    samples.iter().fold(0.0, |most, (_, error)| f64::max(most, error.abs()))
}

/// Angles after 2 s.
fn end<M: Method<Acrobot>>(method: M, h: f64) -> Result<[f64; 2], StepError> {
    let mut sim = SYSTEM.integrator(method, h, SYSTEM.at(STARTS[0], [0.0; 2]));
    sim.advance((2.0 / h).round() as u64)?;
    Ok(sim.state().q)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    f64::max((a[0] - b[0]).abs(), (a[1] - b[1]).abs())
}

/// The path of a method from a start.
type Path = fn([f64; 2]) -> Result<Vec<(f64, f64)>, StepError>;

fn draw() -> Result<(), Box<dyn Error>> {
    let methods: [(&str, Ink, Path); 3] = [
        ("RK4", palette::BLACK, |start| run(RK4, start)),
        ("midpoint rule", palette::VERMILION, |start| run(ImplicitMidpoint, start)),
        ("discrete gradient", palette::GREEN, |start| run(DiscreteGradient, start)),
    ];
    let mut panels = vec![];
    for (start, note) in STARTS.into_iter().zip(["from angles of (1, 0) rad", "from angles of (2, ½) rad"]) {
        let mut curves = vec![];
        for (name, ink, run) in methods {
            let errors = run(start)?.into_iter().map(|(t, error)| (t, error.abs())).collect();
            curves.push(Curve::line(name, ink, errors).rounding().width(1.1));
        }
        let axes = [Axis::linear("time in s", 0.0..100.0), Axis::decades("|E − E₀| in J", -16.0..2.0)];
        panels.push(Panel::new(
            "Acrobot: error of the energy",
            format!("{note} at rest, links of 1 kg and 1 m, h = 0.2 s; differences of 0 are not drawn"),
            axes,
            curves,
        ));
    }
    figure("acrobot.svg", (3, 2), &panels)
}
