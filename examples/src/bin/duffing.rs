//! How accurate is a phase portrait with long steps?
//!
//! Duffing's oscillator x'' = −x − x³ oscillates faster at larger amplitudes. All orbits have the same step; the period of the largest orbit
//! is only seven steps long. The discrete gradient draws the true curves, but moves along them too slowly.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::{PI, TAU};

/// A mass on a spring that hardens; y is its velocity.
#[hamiltonian(q = x, p = y)]
fn duffing(x: f64, y: f64) -> f64 {
    y * y / 2.0 + x * x / 2.0 + x.powi(4) / 4.0
}

const H: f64 = 0.4;
const STEPS: usize = 10_000;
const AMPLITUDES: [f64; 5] = [0.5, 1.0, 1.5, 2.0, 2.5];

fn main() -> Result<(), Box<dyn Error>> {
    let conserving = orbits(DiscreteGradient);
    let verlet = orbits(StormerVerlet);
    let euler = orbits(ExplicitEuler);
    println!("x'' = −x − x³, {STEPS} steps of {H} from x = A at rest\n");
    let head = ["A", "period", "DiscreteGradient", "StormerVerlet", "energy: DiscreteGradient", "StormerVerlet"];
    println!("{}", table(head, &[0, 1, 2, 3, 4].map(|i| row(&conserving[i], &verlet[i]))));
    println!("period: of the flow, then of the methods; energy: largest relative error\n");

    claim("the discrete gradient keeps the energy of all orbits to 5e-14", {
        conserving.iter().all(|orbit| orbit.escape.is_none() && orbit.energy_error() < 5e-14)
    })?;
    let late = conserving.each_ref().map(|orbit| orbit.period() / period(orbit.amplitude) - 1.0);
    claim(&format!("its clock is slow by {:.1} to {:.1} %", 100.0 * late[0], 100.0 * late[4]), {
        late[0] > 0.01 && late[4] < 0.15 && late.is_sorted()
    })?;
    claim("Verlet's energy is off by 4 % on the smallest orbit and by more than 20 % on the last but one", {
        (0.04..0.05).contains(&verlet[0].energy_error()) && (0.2..0.3).contains(&verlet[3].energy_error())
    })?;
    claim("it loses the largest within 100 steps", verlet[4].escape.is_some_and(|t| t < 100.0 * H))?;
    claim("explicit Euler loses all of them", euler.iter().all(|orbit| orbit.escape.is_some()))?;

    // Check the periods of the flow. The table has them from a quadrature, and a method of order 12 confirms them.
    let same = |amplitude| -> Result<bool, StepError> {
        let end = at(Gauss::<6>, 0.1 * period(amplitude), period(amplitude), State::new(amplitude, 0.0))?;
        Ok((end.0 - amplitude).hypot(end.1) < 1e-6)
    };
    claim("after the periods of the first column orbits are closed", {
        AMPLITUDES.into_iter().map(same).collect::<Result<Vec<_>, _>>()?.into_iter().all(|same| same)
    })?;
    for (start, end) in [((1.0, 0.0), (0.79887477, -0.81126377)), ((0.01, 0.02), (-0.0192907, -0.01130507))] {
        let error = |h: f64| -> Result<f64, StepError> {
            let (x, y) = at(DiscreteGradient, h, 10.0, State::new(start.0, start.1))?;
            Ok((x - end.0).hypot(y - end.1))
        };
        let order = (error(0.1)? / error(0.05)?).log2();
        claim(&format!("smaller steps lead from {start:?} to {end:?} in t = 10 (order {order:.2})"), {
            (order - 2.0).abs() < 0.05 && error(0.001)? < 1e-5
        })?;
    }
    println!();
    draw(&[("DiscreteGradient", &conserving), ("StormerVerlet", &verlet), ("ExplicitEuler", &euler)])
}

/// Phase points (x, y) after each step.
struct Orbit {
    amplitude: f64,
    points: Vec<(f64, f64)>,
    /// Time at which the run diverged.
    escape: Option<f64>,
}

fn orbits<M: Method<Duffing, f64>>(method: M) -> [Orbit; 5] {
    AMPLITUDES.map(|amplitude| {
        let mut orbit = Orbit { amplitude, points: vec![(amplitude, 0.0)], escape: None };
        let mut sim = Duffing.integrator(method, H, State::new(amplitude, 0.0));
        for state in sim.sampled(1).take(STEPS) {
            match state {
                Ok(state) => orbit.points.push((state.q, state.p)),
                Err(_) => orbit.escape = Some(orbit.points.len() as f64 * H),
            }
        }
        orbit
    })
}

impl Orbit {
    fn energy_error(&self) -> f64 {
        let energy = |&(x, y): &(f64, f64)| Duffing.energy(&State::new(x, y));
        let first = energy(&(self.amplitude, 0.0));
        self.points.iter().map(|point| (energy(point) / first - 1.0).abs()).fold(0.0, f64::max)
    }

    /// Returns the mean period over all turns. Angles between successive points count the turns; a step is less than half a turn.
    fn period(&self) -> f64 {
        let turn = |pair: &[(f64, f64)]| {
            let [(a, b), (c, d)] = [pair[0], pair[1]];
            (b * c - a * d).atan2(a * c + b * d)
        };
        (self.points.len() - 1) as f64 * H * TAU / self.points.windows(2).map(turn).sum::<f64>()
    }
}

fn row(conserving: &Orbit, verlet: &Orbit) -> [String; 6] {
    let unless_escaped = |orbit: &Orbit, text: String| if orbit.escape.is_some() { "escaped".into() } else { text };
    [
        conserving.amplitude.to_string(),
        format!("{:.4}", period(conserving.amplitude)),
        format!("{:.4}", conserving.period()),
        unless_escaped(verlet, format!("{:.4}", verlet.period())),
        format!("{:.1e}", conserving.energy_error()),
        unless_escaped(verlet, format!("{:.1e}", verlet.energy_error())),
    ]
}

/// Returns the exact period: an elliptic integral, computed by the arithmetic-geometric mean.
fn period(amplitude: f64) -> f64 {
    let square = amplitude * amplitude;
    let (mut a, mut b) = ((1.0 + square).sqrt(), (1.0 + square / 2.0).sqrt());
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    TAU / a
}

fn at<M: Method<Duffing, f64>>(method: M, h: f64, t: f64, start: State<f64>) -> Result<(f64, f64), StepError> {
    let mut sim = Duffing.integrator(method, h, start);
    sim.advance((t / h).round() as u64)?;
    Ok((sim.state().q, sim.state().p))
}

fn draw(portraits: &[(&str, &[Orbit; 5])]) -> Result<(), Box<dyn Error>> {
    let colours = [palette::BLUE, palette::VERMILION, palette::GREEN, palette::ORANGE, palette::PURPLE];
    let inside = |point: &(f64, f64)| point.0.abs() < 3.4 && point.1.abs() < 5.6;
    let panel = |(name, orbits): &(&str, &[Orbit; 5])| {
        let mut curves = vec![];
        for (orbit, colour) in orbits.iter().zip(colours) {
            let name = if curves.is_empty() { "exact" } else { "" };
            curves.push(Curve::line(name, palette::GREY, level(orbit.amplitude)).width(1.0));
            let points: Vec<_> = orbit.points.iter().copied().take(250).filter(inside).collect();
            let name = format!("A = {}", orbit.amplitude);
            // Join the points of a short run, because few points alone do not show the motion.
            let width = if points.len() < 30 { 0.8 } else { 0.0 };
            curves.push(Curve::line(name, colour, points).width(width).solid().marked(2.0));
        }
        let axes = [Axis::linear("x", -3.4..3.4), Axis::linear("y = x'", -5.6..5.6)];
        Panel::new(format!("{name}, h = {H}"), "250 steps from (A, 0); dimensionless", axes, curves)
    };
    let panels: Vec<_> = portraits.iter().map(panel).collect();
    figure("duffing.svg", (1, 1), &panels)
}

/// The level of the energy through x = A: y² = (A² − x²)(1 + (A² + x²)/2).
fn level(amplitude: f64) -> Vec<(f64, f64)> {
    let point = |i: i32| {
        let angle = PI * f64::from(i) / 200.0;
        let x = amplitude * angle.cos();
        // A² − x² without cancellation, and with a sign.
        let y = amplitude * angle.sin();
        (x, y * (1.0 + (amplitude * amplitude + x * x) / 2.0).sqrt())
    };
    (0..=400).map(point).collect()
}
