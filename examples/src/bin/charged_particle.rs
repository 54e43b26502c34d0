//! How fast does a charge drift across a nonuniform magnetic field, over a million gyrations?
//!
//! The charge moves in a plane across B(x) = B₀ (1 + x/L). With A = (0, ∫B dx) the energy is H = (pₓ² + (p_y − A(x))²)/2m. Positions and
//! momenta are coupled, so kick and drift do not exist. H = K + R has two pieces. K is the part of degree 2: the linear motion in a uniform
//! field. R is small if the field is nearly uniform. It depends on x and p_y only, and its flow changes neither. The brackets vanish,
//! {R, {R, {R, K}}} = 0, so tables of Runge–Kutta–Nyström type keep their order.
//!
//! The angle θ of the velocity turns by −B dt, and p_y is constant. Period and drift along y are therefore integrals over θ:
//! ∮ dθ/B and ∮ v sin θ dθ/B with B = B₀ √(1 + 2(p_y − m v sin θ)/(m B₀ L)), for unit charge and mass. A sum over 64 angles is exact to
//! rounding.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, orbit, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;
use std::f64::consts::TAU;
use std::time::Instant;

/// A charge of unit mass: `b` is its gyration frequency at x = 0, which doubles within a length `l`.
#[hamiltonian]
fn charge(q: [f64; 2], p: [f64; 2], b: f64, l: f64) -> f64 {
    let [x, _] = q;
    (p[0] * p[0] + (p[1] - b * (x + x * x / (2.0 * l))).powi(2)) / 2.0
}

type Plane = State<[f64; 2]>;

/// In rad/s and m.
const SYSTEM: Charge = Charge { b: 2.0, l: 5.0 };
const SPEED: f64 = 1.0;
const GYRATIONS: u32 = 1_000_000;

/// Returns the exact period of a gyration, and the drift along y in one gyration.
fn gyration() -> [f64; 2] {
    let mut sums = [0.0; 2];
    const ANGLES: u32 = 64;
    for i in 0..ANGLES {
        let theta = TAU * f64::from(i) / f64::from(ANGLES);
        let field = SYSTEM.b * (1.0 - 2.0 * SPEED * theta.sin() / (SYSTEM.b * SYSTEM.l)).sqrt();
        sums[0] += TAU / f64::from(ANGLES) / field;
        sums[1] += TAU / f64::from(ANGLES) * SPEED * theta.sin() / field;
    }
    sums
}

/// p_y = 0: at x = 0 the charge moves along x.
fn start() -> Plane {
    State::new([0.0, 0.0], [SPEED, 0.0])
}

/// Drift and energy error of a method over a million gyrations.
struct Run {
    name: String,
    ink: Ink,
    steps: u32,
    /// Number of gyrations, and the ratio of the computed drift to the exact drift.
    drift: Vec<(f64, f64)>,
    energy: f64,
    seconds: f64,
}

fn run<M: Method<Charge, f64>>(method: M, steps: u32, ink: Ink) -> Result<Run, StepError> {
    let [period, drift] = gyration();
    let mut sim = SYSTEM.integrator(method, period / f64::from(steps), start());
    let (energy, clock) = (sim.energy(), Instant::now());
    let (mut samples, mut done) = (vec![], 0);
    for decade in 0..6 {
        for part in 1..=9 {
            let next = part * 10_u32.pow(decade);
            sim.advance(u64::from((next - done) * steps))?;
            done = next;
            samples.push((f64::from(done), sim.state().q[1] / (f64::from(done) * drift)));
        }
    }
    sim.advance(u64::from((GYRATIONS - done) * steps))?;
    samples.push((f64::from(GYRATIONS), sim.state().q[1] / (f64::from(GYRATIONS) * drift)));
    Ok(Run {
        name: method.name().to_string(),
        ink,
        steps,
        drift: samples,
        energy: sim.energy() / energy - 1.0,
        seconds: clock.elapsed().as_secs_f64(),
    })
}

impl Run {
    fn error(&self) -> f64 {
        self.drift.last().map_or(f64::NAN, |(_, ratio)| ratio - 1.0)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Charge::REPORT);
    let [period, drift] = gyration();
    println!("a gyration takes {period:.6} s; drift along y {drift:.6} m, in leading order {:.6} m\n", {
        -period * SPEED * SPEED / (2.0 * SYSTEM.b * SYSTEM.l)
    });
    let runs = [
        run(RK4, 40, palette::VERMILION)?,
        run(PieceSplitting, 40, palette::ORANGE)?,
        run(Suzuki4.of(PieceSplitting), 16, palette::GREEN)?,
        run(BlanesMoanSrkn14a.of(PieceSplitting), 10, palette::SKY)?,
        run(BceRkn17_8.of(PieceSplitting), 12, palette::BLUE)?,
    ];
    let rows = runs.each_ref().map(|run| {
        [
            run.name.clone(),
            run.steps.to_string(),
            format!("{:.1e}", run.error()),
            format!("{:.1e}", run.energy),
            format!("{:.1}", run.seconds),
        ]
    });
    println!("{GYRATIONS} gyrations\n");
    println!("{}", table(["method", "steps a gyration", "error of the drift", "of the energy", "s"], &rows));
    let [rk4, second, fourth, sixth, eighth] = runs.each_ref();
    claim("RK4 stops the charge", rk4.energy < -0.5)?;
    claim("pieces keep the energy", [second, fourth, sixth, eighth].iter().all(|run| run.energy.abs() < 1e-3))?;
    claim("and the drift: with twelve steps a gyration to 1e-8 after a million", {
        second.error().abs() < 1e-3 && fourth.error().abs() < 1e-4 && eighth.error().abs() < 1e-8
    })?;

    let path = |states: &[Plane]| states.iter().map(|x| (x.q[1], x.q[0])).collect::<Vec<_>>();
    let duration = 12.0 * period;
    let smooth = orbit(SYSTEM, BceRkn17_8.of(PieceSplitting), period / 200.0, start(), duration)?;
    let coarse = orbit(SYSTEM, BceRkn17_8.of(PieceSplitting), period / 12.0, start(), duration)?;
    let lost = orbit(SYSTEM, RK4, period / 8.0, start(), duration)?;
    let paths = vec![
        Curve::line("reference", palette::GREY, path(&smooth)).width(0.8),
        Curve::dots("BceRkn17_8, 12 steps a gyration", palette::BLUE, path(&coarse)).marked(2.6).open(),
        Curve::line("RK4, 8 steps a gyration", palette::VERMILION, path(&lost)).width(0.8),
    ];
    let drifts = runs
        .iter()
        .map(|run| {
            let error = run.drift.iter().map(|(n, ratio)| (*n, (ratio - 1.0).abs())).collect();
            Curve::line(format!("{}, {} steps", run.name, run.steps), run.ink, error)
        })
        .collect();
    figure(
        "charged_particle.svg",
        (3, 2),
        &[
            Panel::new(
                "Gyration and drift of a charge",
                "the field grows upwards; unit charge and mass, 12 gyrations",
                [Axis::linear("y in m", -1.2..2.2), Axis::linear("x in m", -0.8..0.8)],
                paths,
            ),
            Panel::new(
                "Error of the drift",
                "relative to the exact drift; the legend gives steps per gyration",
                [Axis::decades("gyrations", 0.0..6.0), Axis::decades("error", -12.0..0.5)],
                drifts,
            ),
        ],
    )
}
