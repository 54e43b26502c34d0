//! Which methods integrate an energy that is not T(p) + V(q)? A double pendulum, whose arms couple q and p.
//!
//! Kick and drift do not exist here, so explicit methods such as Verlet do not compile for it. Three families of methods work: collocation,
//! the midpoint rule and the discrete gradient, alone or composed to a higher order.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, evaluations, shortest, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;
use std::time::Duration;

/// Two pendulums, the second hanging from the first; q angles from below in rad, p in kg m²/s.
#[hamiltonian]
fn double_pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
    let [a, b] = q;
    let (sin, cos) = (a - b).sin_cos();
    let u = p[0] / l1;
    let v = p[1] / l2;
    let kinetic = (m2 * u * u + (m1 + m2) * v * v - 2.0 * m2 * u * v * cos) / (2.0 * m2 * (m1 + m2 * sin * sin));
    let height = m1 * l1 * a.cos() + m2 * (l1 * a.cos() + l2 * b.cos());
    kinetic - g * height
}

const SYSTEM: DoublePendulum = DoublePendulum { m1: 1.0, m2: 0.6, l1: 1.0, l2: 0.8, g: 9.81 };
const SECONDS: f64 = 200.0;
const SECONDS_BETWEEN_SAMPLES: f64 = 0.04;

/// Positions and momenta of both arms at a time.
type Arms = State<[f64; 2]>;

/// A large but regular motion: the growth of errors is not exponential.
fn start() -> Arms {
    State::new([0.0, 1.4], [0.0, 0.0])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", DoublePendulum::REPORT);

    // With order 12 the reference has rounding errors only.
    let truth = samples(Gauss::<6>, 0.02)?;
    let conserving = DiscreteGradient;
    let runs = [
        run(ExplicitEuler, 0.001, &truth)?,
        run(ImplicitMidpoint, 0.01, &truth)?,
        run(ImplicitMidpoint, 0.005, &truth)?,
        run(conserving, 0.01, &truth)?,
        run(conserving, 0.005, &truth)?,
        run(Suzuki4.of(conserving), 0.02, &truth)?,
        run(Suzuki4.of(conserving), 0.01, &truth)?,
        run(Gauss::<3>, 0.02, &truth)?,
        run(Gauss::<3>, 0.01, &truth)?,
    ];
    println!("Double pendulum, {SECONDS} s\n");
    let head = ["method", "step / s", "evaluations", "time / ms", "energy error", "distance / m"];
    println!("{}", table(head, &runs.each_ref().map(Run::row)));
    println!(
        "evaluations: points at which the energy is evaluated; distance: largest position error of the lower bob\n"
    );

    let [euler, midpoint, midpoint_half, conserve, conserve_half, suzuki, suzuki_half, gauss, gauss_half] = &runs;
    draw_path()?;
    draw_energy_errors(&[
        (euler, palette::BLACK),
        (midpoint, palette::VERMILION),
        (gauss, palette::BLUE),
        (conserve, palette::GREEN),
    ])?;
    println!();

    claim("explicit Euler is off by more than half of the energy, with a tenth of the step", euler.energy_error > 0.5)?;
    claim("the midpoint rule keeps it to 1e-4", midpoint.energy_error < 1e-4)?;
    claim("the discrete gradient keeps it to 5e-14, composed or not", {
        [conserve, conserve_half, suzuki, suzuki_half].iter().all(|run| run.energy_error < 5e-14)
    })?;
    let order = |coarse: &Run, fine: &Run| (coarse.distance / fine.distance).log2();
    for (coarse, fine, claimed) in [
        (midpoint, midpoint_half, 2.0),
        (conserve, conserve_half, 2.0),
        (suzuki, suzuki_half, 4.0),
        (gauss, gauss_half, 6.0),
    ] {
        let (name, order) = (&coarse.name, order(coarse, fine));
        claim(&format!("{name} is of order {claimed} (observed {order:.2})"), (order - claimed).abs() < 0.15)?;
    }
    let apart = distance(&suzuki_half.samples, &gauss.samples);
    claim(&format!("two methods that share nothing agree on the path to 0.01 mm ({apart:.1e} m)"), apart < 1e-5)
}

/// Samples, cost and errors of a method with a step size.
struct Run {
    name: String,
    step_size: f64,
    evaluations: u64,
    time: Duration,
    samples: Vec<Arms>,
    energy_error: f64,
    distance: f64,
}

impl Run {
    fn row(&self) -> [String; 6] {
        [
            self.name.clone(),
            self.step_size.to_string(),
            self.evaluations.to_string(),
            format!("{:.1}", self.time.as_secs_f64() * 1e3),
            format!("{:.1e}", self.energy_error),
            format!("{:.1e}", self.distance),
        ]
    }
}

/// Runs a method and compares its samples with the reference.
fn run<M: Method<DoublePendulum, f64>>(method: M, h: f64, truth: &[Arms]) -> Result<Run, Box<dyn Error>> {
    let steps = (SECONDS / h).round() as u64;
    let evaluations = evaluations(SYSTEM, method, h, start(), steps)?;
    let time = shortest(|| SYSTEM.integrator(method, h, start()).advance(steps))?;
    let samples = samples(method, h)?;
    let distance = distance(&samples, truth);
    Ok(Run {
        name: method.name().to_string(),
        step_size: h,
        evaluations,
        time,
        energy_error: energy_error(&samples),
        samples,
        distance,
    })
}

fn samples<M: Method<DoublePendulum, f64>>(method: M, h: f64) -> Result<Vec<Arms>, StepError> {
    let stride = (SECONDS_BETWEEN_SAMPLES / h).round() as u64;
    let samples = (SECONDS / SECONDS_BETWEEN_SAMPLES).round() as usize;
    SYSTEM.integrator(method, h, start()).sampled(stride).take(samples).collect()
}

/// The largest change of the energy relative to its start.
fn energy_error(samples: &[Arms]) -> f64 {
    let first = SYSTEM.energy(&start());
    samples.iter().map(|state| (SYSTEM.energy(state) / first - 1.0).abs()).fold(0.0, f64::max)
}

/// Returns the largest distance of the lower bobs at equal times, in m.
fn distance(samples: &[Arms], others: &[Arms]) -> f64 {
    let apart = |(a, b): (&Arms, &Arms)| {
        let ([_, a], [_, b]) = (bobs(a), bobs(b));
        (a.0 - b.0).hypot(a.1 - b.1)
    };
    samples.iter().zip(others).map(apart).fold(0.0, f64::max)
}

/// Positions of the upper and the lower bob, in m.
fn bobs(state: &Arms) -> [(f64, f64); 2] {
    let ([a, b], DoublePendulum { l1, l2, .. }) = (state.q, SYSTEM);
    let upper = (l1 * a.sin(), -l1 * a.cos());
    [upper, (upper.0 + l2 * b.sin(), upper.1 - l2 * b.cos())]
}

fn draw_path() -> Result<(), Box<dyn Error>> {
    let mut sim = SYSTEM.integrator(Gauss::<3>, 0.01, start());
    let samples: Vec<_> = sim.until(20.0).collect::<Result<_, _>>()?;
    let end = sim.state();
    let path = |bob: usize| samples.iter().map(|state| bobs(state)[bob]).collect();
    let [upper, lower] = bobs(&end);
    let panel = Panel::new(
        format!("Double pendulum, the first {:.0} seconds", end.t),
        "Gauss::<3>, h = 0.01 s; masses 1 and 0.6 kg, arms 1 and 0.8 m",
        [Axis::linear("x (m)", -1.1..1.1), Axis::linear("height (m)", -1.9..0.1)],
        vec![
            Curve::line("lower bob", palette::BLUE, path(1)).width(0.9),
            Curve::line("upper bob", palette::VERMILION, path(0)).width(1.4).solid(),
            Curve::line("arms at the end", palette::BLACK, vec![(0.0, 0.0), upper, lower])
                .width(2.0)
                .solid()
                .marked(4.0),
        ],
    );
    figure("double_pendulum_path.svg", (5, 4), &[panel.equal()])
}

fn draw_energy_errors(runs: &[(&Run, Ink)]) -> Result<(), Box<dyn Error>> {
    let curve = |&(run, colour): &(&Run, Ink)| {
        // The error vanishes now and then. The largest error of each 100 samples gives a legible curve.
        let points = run.samples.chunks(100).map(|seconds| (seconds[50].t, energy_error(seconds)));
        let line = Curve::line(format!("{}, h = {} s", run.name, run.step_size), colour, points.collect());
        // Below this limit the curve shows rounding errors.
        if run.energy_error < 1e-12 { line.width(1.0).rounding() } else { line }
    };
    let panel = Panel::new(
        "Double pendulum: error of the energy",
        "from rest at angles of 0 and 1.4 rad; masses 1 and 0.6 kg, arms 1 and 0.8 m",
        [Axis::linear("time (s)", 0.0..SECONDS), Axis::decades("relative error, largest in 4 s", -16.0..2.0)],
        runs.iter().map(curve).collect(),
    );
    figure("double_pendulum_energy.svg", (3, 2), &[panel])
}
