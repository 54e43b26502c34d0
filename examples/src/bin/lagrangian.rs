//! How does one simulate a double pendulum from its Lagrangian?
//!
//! The attribute derives the momenta, the mass matrix and the energy from L; `REPORT` lists them. The steps integrate the energy.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Two pendulums, the second hanging from the first; q angles from below, v their rates.
#[lagrangian]
fn double_pendulum(q: [f64; 2], v: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let (mut x, mut y, mut height, mut sum) = (0.0, 0.0, 0.0, 0.0);
    for i in 0..2 {
        let (sin, cos) = q[i].sin_cos();
        // The velocity and the height of a bob.
        x += l[i] * v[i] * cos;
        y += l[i] * v[i] * sin;
        height -= l[i] * cos;
        sum += 0.5 * m[i] * (x * x + y * y) - m[i] * g * height;
    }
    sum
}

const SYSTEM: DoublePendulum = DoublePendulum { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81 };
const H: f64 = 0.02;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", DoublePendulum::REPORT);
    let runs = [
        ("RK4", palette::BLACK, energies(RK4)?),
        ("midpoint rule", palette::VERMILION, energies(ImplicitMidpoint)?),
        ("Gauss, 3 stages", palette::BLUE, energies(Gauss::<3>)?),
        ("discrete gradient", palette::GREEN, energies(DiscreteGradient)?),
    ];
    let largest = |run: &[(f64, f64)]| run.iter().fold(0.0, |most, (_, error)| f64::max(most, *error));
    let rows = runs.each_ref().map(|(name, _, run)| [(*name).into(), format!("{:.1e}", largest(run))]);
    println!("{}", table(["method, h = 0.02", "largest error of the energy in 200 s"], &rows));

    let [rk4, midpoint, gauss, gradient] = runs.each_ref().map(|(_, _, run)| largest(run));
    claim("the discrete gradient keeps the energy to 1e-12", gradient < 1e-12)?;
    claim("the symplectic methods keep it to their order, RK4 loses it", {
        gauss < 1e-6 && midpoint < 5e-2 && rk4 > 1e3 * gauss
    })?;
    let (q, p) = {
        let mut sim = SYSTEM.integrator(Gauss::<3>, 0.002, start());
        sim.advance(1000)?;
        (sim.state().q, sim.state().p)
    };
    let known = [0.448_335_338_590_095_9, -0.395_189_239_437_110_2, 2.517_121_302_332_408_6, 0.406_266_779_011_219_94];
    claim("after 2 s it is where twenty published digits say", {
        [q[0] - known[0], q[1] - known[1], p[1] - known[3]].iter().all(|error| error.abs() < 1e-11)
    })?;
    println!();
    draw(runs)
}

fn start() -> State<[f64; 2]> {
    SYSTEM.at([0.0, 1.4], [0.0, 0.0])
}

/// The error of the energy over time.
fn energies<M: Method<DoublePendulum>>(method: M) -> Result<Vec<(f64, f64)>, StepError> {
    let mut sim = SYSTEM.integrator(method, H, start());
    let before = sim.energy();
    let mut errors = vec![];
    for _ in 0..500 {
        sim.advance(20)?;
        errors.push((sim.state().t, (sim.energy() - before).abs()));
    }
    Ok(errors)
}

/// A name, its colour, and points of a figure.
type Named = (&'static str, Ink, Vec<(f64, f64)>);

fn draw(runs: [Named; 4]) -> Result<(), Box<dyn Error>> {
    let mut sim = SYSTEM.integrator(DiscreteGradient, 0.01, start());
    let mut ways = [vec![], vec![]];
    for _ in 0..1500 {
        let ([a, b], l) = (sim.state().q, SYSTEM.l);
        let elbow = (l[0] * a.sin(), -l[0] * a.cos());
        ways[0].push(elbow);
        ways[1].push((elbow.0 + l[1] * b.sin(), elbow.1 - l[1] * b.cos()));
        sim.step()?;
    }
    let [upper, lower] = ways;
    let path = Panel::new(
        "Double pendulum: paths of both bobs in 15 s",
        "discrete gradient, h = 0.01 s",
        [Axis::linear("x in m", -1.4..1.4), Axis::linear("y in m", -1.9..-0.3)],
        vec![
            Curve::line("lower bob", palette::BLUE, lower).width(1.0).solid(),
            Curve::line("upper bob", palette::VERMILION, upper).width(1.6).solid(),
        ],
    );
    let curves = runs.into_iter().map(|(name, ink, run)| Curve::line(name, ink, run).rounding().width(1.2)).collect();
    let energy = Panel::new(
        "Double pendulum: error of the energy",
        "h = 0.02 s; differences of 0 are not drawn",
        [Axis::linear("time in s", 0.0..200.0), Axis::decades("|E − E₀| in J", -16.0..1.0)],
        curves,
    );
    figure("lagrangian.svg", (4, 3), &[path, energy])
}
