//! At which angle does a bead on a turning hoop rest?
//!
//! The hoop turns about its vertical diameter at the rate Ω; q is the angle of the bead from below. The Lagrangian gives an energy function
//! that is not kinetic plus potential energy. Beyond Ω² = g/r the lowest point is unstable, and two stable angles exist with
//! cos q = g/(rΩ²).

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;

/// A bead of mass 1 on a hoop of radius 1, with friction or without.
#[lagrangian(rayleigh = c * v * v / 2.0)]
fn hoop(q: f64, v: f64, omega: f64, g: f64, c: f64) -> f64 {
    let [along, around, height] = [v, omega * q.sin(), -q.cos()];
    (along * along + around * around) / 2.0 - g * height
}

const G: f64 = 9.81;
const FAST: Hoop = Hoop { omega: 4.0, g: G, c: 0.0 };
const SLOW: Hoop = Hoop { omega: 3.0, g: G, c: 0.0 };

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Hoop::<f64>::REPORT.lines().take(8).collect::<Vec<_>>().join("\n"));
    println!();
    let rest = angle_of_rest(4.0);
    let swing = run(FAST, 0.5, 0.01, 400)?;
    let [kept, swinging] = [|e: &Sample| e.energy, |e: &Sample| e.mechanical].map(|of| spread(&swing, of));
    let period = period(&run(FAST, rest + 0.01, 0.001, 4000)?, rest);
    let expected = TAU / (16.0 - G * G / 16.0).sqrt();
    let rows = [
        ["spread of p·v − L in 4 s".into(), format!("{kept:.1e}")],
        ["spread of T + V in 4 s".into(), format!("{swinging:.2}")],
        [format!("period about q = {rest:.4}"), format!("{period:.4}")],
        ["the same by linearisation".into(), format!("{expected:.4}")],
    ];
    println!("{}", table(["", "discrete gradient, Ω = 4"], &rows));

    claim("the energy function is kept to 1e-13, and T + V swings by more than 5", kept < 1e-13 && swinging > 5.0)?;
    claim("it rests at cos q = g/Ω²", run(FAST, rest, 0.01, 1000)?.iter().all(|e| (e.q - rest).abs() < 1e-12))?;
    claim("about there it swings with the period of the linearised equation", (period / expected - 1.0).abs() < 1e-4)?;
    let most = |system, start| {
        run(system, start, 0.01, 1000).map(|run| run.iter().fold(0.0, |most, e| f64::max(most, e.q.abs())))
    };
    claim("a slow hoop holds a bead at its lowest point, a fast one does not", {
        most(SLOW, 0.01)? < 0.011 && most(FAST, 0.01)? > 1.2
    })?;
    let settled = settled()?;
    let furthest = settled.iter().fold(0.0, |most, &(omega, q)| f64::max(most, (q.abs() - angle_of_rest(omega)).abs()));
    claim("with friction it comes to rest there to 1e-6, or at q = 0 where Ω² < g/r", furthest < 1e-6)?;
    println!();
    draw(rest, &swing, settled)
}

/// Returns the stable angle of rest.
fn angle_of_rest(omega: f64) -> f64 {
    (G / (omega * omega)).min(1.0).acos()
}

/// Returns rates of the hoop, each with an angle at which friction brings a bead to rest. Runs start on both sides of the lowest point.
fn settled() -> Result<Vec<(f64, f64)>, StepError> {
    let mut ends = vec![];
    for tenths in (5..=70).step_by(5) {
        for start in [0.1, -0.1] {
            let omega = f64::from(tenths) / 10.0;
            let run = run(Hoop { omega, g: G, c: 1.0 }, start, 0.01, 6000)?;
            ends.push((omega, run[6000].q));
        }
    }
    Ok(ends)
}

/// State and energies after a step.
struct Sample {
    t: f64,
    q: f64,
    v: f64,
    energy: f64,
    mechanical: f64,
}

fn run(system: Hoop, start: f64, h: f64, steps: usize) -> Result<Vec<Sample>, StepError> {
    let mut sim = system.integrator(DiscreteGradient, h, system.at(start, 0.0));
    let mut samples = vec![];
    for _ in 0..=steps {
        let (State { t, q, .. }, v) = (sim.state(), sim.velocity());
        let mechanical = (v * v + (system.omega * q.sin()).powi(2)) / 2.0 - G * q.cos();
        samples.push(Sample { t, q, v, energy: sim.energy(), mechanical });
        sim.step()?;
    }
    Ok(samples)
}

fn spread(samples: &[Sample], of: fn(&Sample) -> f64) -> f64 {
    let ends = samples.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    ends.1 - ends.0
}

/// Returns the period between upward crossings of an angle.
fn period(samples: &[Sample], angle: f64) -> f64 {
    let crossing = |pair: &[Sample]| {
        let [a, b] = [pair[0].q - angle, pair[1].q - angle];
        (a < 0.0 && b >= 0.0).then(|| pair[0].t - a / (b - a) * (pair[1].t - pair[0].t))
    };
    let times: Vec<f64> = samples.windows(2).filter_map(crossing).collect();
    (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64
}

fn draw(rest: f64, swing: &[Sample], settled: Vec<(f64, f64)>) -> Result<(), Box<dyn Error>> {
    let mut orbits = vec![];
    for (name, start, colour) in [
        ("one side", 0.3, palette::BLUE),
        ("", 0.6, palette::BLUE),
        ("both sides", 1.5, palette::GREEN),
        ("", 1.9, palette::GREEN),
    ] {
        for side in [1.0, -1.0] {
            let points = run(FAST, side * start, 0.01, 400)?.iter().map(|e| (e.q, e.v)).collect();
            let name = if side > 0.0 { name } else { "" };
            orbits.push(Curve::line(name, colour, points).width(1.2).solid());
        }
    }
    orbits.push(Curve::dots("rest", palette::VERMILION, vec![(rest, 0.0), (-rest, 0.0)]));
    let of = |value: fn(&Sample) -> f64| swing.iter().map(|e| (e.t, value(e))).collect::<Vec<_>>();
    let energies = vec![
        Curve::line("T + V", palette::VERMILION, of(|e| e.mechanical)),
        Curve::line("p·v − L", palette::BLUE, of(|e| e.energy)),
    ];
    let portrait = Panel::new(
        "Bead on a turning hoop, Ω = 4 rad/s",
        "discrete gradient, h = 0.01 s; g = 9.81 m/s², r = 1 m",
        [Axis::linear("angle q in rad", -2.4..2.4), Axis::linear("v in rad/s", -4.5..4.5)],
        orbits,
    );
    let energy = Panel::new(
        "Energy of the bead, from q = 0.5 rad at rest",
        "discrete gradient, h = 0.01 s; Ω = 4 rad/s, unit mass",
        [Axis::linear("time in s", 0.0..4.0), Axis::linear("energy in J", -11.0..8.0)],
        energies,
    );
    let turning = Panel::new(
        "Angles of rest of the bead with friction",
        "discrete gradient, h = 0.01 s, c = 1/s, 60 s from ±0.1 rad",
        [Axis::linear("Ω in rad/s", 0.0..7.0), Axis::linear("angle q in rad", -1.6..1.6)],
        branches(settled),
    );
    let panels = [portrait, energy, turning];
    figure("rotating_hoop.svg", (4, 3), &panels)
}

/// Angles of rest by the rate of the hoop; two branch off at Ω² = g/r.
fn branches(settled: Vec<(f64, f64)>) -> Vec<Curve> {
    let critical = G.sqrt();
    let branch = |side: f64| {
        let point = |part: f64| {
            // The points are denser near the branch point, because the curve is steep there.
            let omega = critical + (7.0 - critical) * part * part;
            (omega, side * angle_of_rest(omega))
        };
        (0..=100).map(|n| point(f64::from(n) / 100.0)).collect()
    };
    vec![
        Curve::line("unstable", palette::VERMILION, vec![(critical, 0.0), (7.0, 0.0)]),
        Curve::line("stable", palette::BLUE, vec![(0.0, 0.0), (critical, 0.0)]).solid(),
        Curve::line("", palette::BLUE, branch(1.0)).solid(),
        Curve::line("", palette::BLUE, branch(-1.0)).solid(),
        Curve::dots("end of a run", palette::GREEN, settled),
    ]
}
