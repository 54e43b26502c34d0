//! How do the outer planets move in 547 years, and how accurate is each method?
//!
//! The Sun, Jupiter, Saturn, Uranus, Neptune and Pluto attract each other; one energy function contains all of this. All explicit methods
//! evaluate the forces once in ten days: a step of a method with k stages is 10·k days long. Two more methods evaluate them less often. They
//! work in Jacobi's coordinates, with an exact Kepler flow of each planet and a kick by the rest.

use geoint_examples::outer_planets::{self, start};
use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, evaluations, output, shortest, shown, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use indicatif::{ProgressBar, ProgressStyle};
use nalgebra::Vector3;
use std::error::Error;
use std::time::Duration;

/// Bodies under their mutual gravity; q in AU, p in solar masses · AU/d, m in solar masses, g in AU³/(d² solar mass).
#[hamiltonian(coordinates = jacobi)]
fn outer_solar_system(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..6 {
        energy += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    energy
}

const NAMES: [&str; 6] = ["Sun", "Jupiter", "Saturn", "Uranus", "Neptune", "Pluto"];

const SYSTEM: OuterSolarSystem = OuterSolarSystem { m: outer_planets::MASSES, g: outer_planets::GRAVITY };

/// Positions and momenta of all bodies at a time.
type Bodies = State<[Vector3<f64>; 6]>;

const DAYS: f64 = 200_000.0;
const FORCES: u64 = 20_000;
const DAYS_BETWEEN_SAMPLES: f64 = 160.0;

fn main() -> Result<(), Box<dyn Error>> {
    let bar = progress(11);
    let runs = [
        explicit(ExplicitEuler, 1, &bar)?,
        explicit(StormerVerlet, 1, &bar)?,
        explicit(PEFRL, 4, &bar)?,
        explicit(BlanesMoan4, 6, &bar)?,
        explicit(BlanesMoanSrkn14a, 14, &bar)?,
        run(WisdomHolmanGradient, 2000, 2000, &bar)?,
        run(Aba10_6_4, 500, 4000, &bar)?,
        explicit(BceRkn17_8, 17, &bar)?,
        explicit(KahanLi8_17a.of(StormerVerlet), 17, &bar)?,
        implicit(Gauss::<4>, 500, &bar)?,
        implicit(DiscreteGradient, 2_000, &bar)?,
    ];
    bar.finish_and_clear();
    let [euler, verlet, .., processed, jacobi, order_8, _, _, conserving] = &runs;

    println!("Outer solar system, {DAYS} days\n");
    println!("{}", comparison(&runs)?);
    println!("distance: largest error of the position of a planet at the end\n");

    let jupiter = period(&order_8.samples, 1);
    claim("explicit Euler is off by more than half of the energy", euler.energy_error() > 0.5)?;
    claim("Verlet keeps it to 1e-5, in the last century as in the first", {
        let before = verlet.samples.partition_point(|state| state.t < 36_525.0);
        let (first, last) = (&verlet.samples[..before], &verlet.samples[verlet.samples.len() - before..]);
        verlet.energy_error() < 1e-5 && energy_error(last) < 1.1 * energy_error(first)
    })?;
    claim("the method of order 8 keeps it to 2e-11 for the same number of forces", order_8.energy_error() < 2e-11)?;
    claim("in Jacobi's coordinates a fifth of the forces keep it to 6e-12", {
        processed.energy_error() < 6e-12 && jacobi.energy_error() < 6e-12
    })?;
    claim("the discrete gradient keeps it to 5e-14", conserving.energy_error() < 5e-14)?;
    claim("all but explicit Euler keep the angular momentum to 5e-14", {
        euler.angular_momentum_error() > 0.1 && runs[1..].iter().all(|run| run.angular_momentum_error() < 5e-14)
    })?;
    claim(&format!("Jupiter goes round in {jupiter:.3} years; observed are 11.862"), (jupiter - 11.862).abs() < 0.01)?;

    println!();
    write_orbits(order_8)?;
    draw_orbits(euler, order_8)?;
    draw_energy_errors(&runs)
}

/// Samples and cost of one method.
struct Run {
    name: String,
    steps: u64,
    forces: u64,
    time: Duration,
    samples: Vec<Bodies>,
}

impl Run {
    fn step_size(&self) -> f64 {
        DAYS / self.steps as f64
    }

    fn energy_error(&self) -> f64 {
        energy_error(&self.samples)
    }

    /// The largest change of the angular momentum relative to its length.
    fn angular_momentum_error(&self) -> f64 {
        let of = |state: &Bodies| -> Vector3<f64> { state.q.iter().zip(&state.p).map(|(q, p)| q.cross(p)).sum() };
        let first = of(&start());
        self.samples.iter().map(|state| (of(state) - first).norm() / first.norm()).fold(0.0, f64::max)
    }
}

fn energy_error(samples: &[Bodies]) -> f64 {
    samples.iter().map(|state| (SYSTEM.energy(state) / SYSTEM.energy(&start()) - 1.0).abs()).fold(0.0, f64::max)
}

/// Runs an explicit method with `stages` forces a step. The number of steps follows from the budget [`FORCES`].
fn explicit<M: Method<OuterSolarSystem, f64>>(method: M, stages: u64, bar: &ProgressBar) -> Result<Run, StepError> {
    let steps = FORCES / stages;
    run(method, steps, steps * stages, bar)
}

/// Runs `steps` steps of an implicit method. Each point at which Newton's iterations evaluate the energy counts as a force.
fn implicit<M: Method<OuterSolarSystem, f64>>(method: M, steps: u64, bar: &ProgressBar) -> Result<Run, Box<dyn Error>> {
    let forces = evaluations(SYSTEM, method, DAYS / steps as f64, start(), steps)?;
    Ok(run(method, steps, forces, bar)?)
}

/// Runs a method twice: first without samples to measure its time, then with a sample about every 160 days.
fn run<M: Method<OuterSolarSystem, f64>>(
    method: M,
    steps: u64,
    forces: u64,
    bar: &ProgressBar,
) -> Result<Run, StepError> {
    let name = method.name().to_string();
    bar.set_message(name.clone());
    let step_size = DAYS / steps as f64;
    let time = shortest(|| SYSTEM.integrator(method, step_size, start()).advance(steps))?;

    let mut sim = SYSTEM.integrator(method, step_size, start());
    let stride = (DAYS_BETWEEN_SAMPLES / step_size).ceil() as u64;
    let mut samples = vec![start()];
    for state in sim.sampled(stride).take((steps / stride) as usize) {
        samples.push(state?);
    }
    bar.inc(1);
    Ok(Run { name, steps, forces, time, samples })
}

/// Returns a progress bar. The bar hides itself without a terminal.
fn progress(runs: u64) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}").unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(runs).with_style(style)
}

fn comparison(runs: &[Run]) -> Result<String, StepError> {
    let rows: Vec<_> = runs
        .iter()
        .map(|run| {
            let end = run.samples.last().copied().unwrap_or_else(start);
            let reference = reference(end.t)?;
            let distance = (1..6).map(|i| (from_sun(&end, i) - from_sun(&reference, i)).norm()).fold(0.0, f64::max);
            Ok([
                run.name.clone(),
                format!("{:.1}", run.step_size()),
                run.forces.to_string(),
                format!("{:.2}", run.time.as_secs_f64() * 1e3),
                format!("{:.1e}", run.energy_error()),
                format!("{:.1e}", run.angular_momentum_error()),
                format!("{distance:.1e}"),
            ])
        })
        .collect::<Result<_, StepError>>()?;
    let head = ["method", "step / d", "forces", "time / ms", "energy error", "ang. mom. error", "distance / AU"];
    Ok(table(head, &rows))
}

/// Returns the reference state at a time. Its method of order 10 is not in the table. Short steps leave rounding errors only.
fn reference(t: f64) -> Result<Bodies, StepError> {
    let steps = (t / 40.0).ceil();
    let mut sim = SYSTEM.integrator(SofroniouSpaletta10_35.of(StormerVerlet), t / steps, start());
    sim.advance(steps as u64)?;
    Ok(sim.state())
}

/// Returns the heliocentric position of body `i` in the ecliptic of J2000.
fn from_sun(state: &Bodies, i: usize) -> Vector3<f64> {
    let (sin, cos) = 23.4392911_f64.to_radians().sin_cos();
    let q = state.q[i] - state.q[0];
    Vector3::new(q.x, cos * q.y + sin * q.z, cos * q.z - sin * q.y)
}

/// Returns the mean orbital period of body `i` about the Sun, in years.
fn period(samples: &[Bodies], i: usize) -> f64 {
    let turn = |pair: &[Bodies]| {
        let (a, b) = (from_sun(&pair[0], i), from_sun(&pair[1], i));
        (a.x * b.y - a.y * b.x).atan2(a.x * b.x + a.y * b.y)
    };
    let angle: f64 = samples.windows(2).map(turn).sum();
    let days = samples.last().map_or(0.0, |state| state.t);
    days / 365.25 * std::f64::consts::TAU / angle
}

/// Writes the positions in the frame of the initial data to a CSV file.
fn write_orbits(run: &Run) -> Result<(), Box<dyn Error>> {
    let path = output("outer_solar_system.csv")?;
    let mut csv = csv::Writer::from_path(&path)?;
    csv.write_record(["t_d", "body", "x_au", "y_au", "z_au"])?;
    for state in &run.samples {
        for (name, q) in NAMES.iter().zip(&state.q) {
            csv.write_record([&state.t.to_string(), *name, &q.x.to_string(), &q.y.to_string(), &q.z.to_string()])?;
        }
    }
    csv.flush()?;
    println!("orbits      {}", shown(&path));
    Ok(())
}

fn draw_orbits(wrong: &Run, right: &Run) -> Result<(), Box<dyn Error>> {
    let colours = [palette::BLACK, palette::VERMILION, palette::ORANGE, palette::GREEN, palette::BLUE, palette::PURPLE];
    let curve = |run: &Run, i: usize| {
        let points = run.samples.iter().map(|state| from_sun(state, i)).map(|q| (q.x, q.y)).collect();
        Curve::line(NAMES[i], colours[i], points).width(0.7).solid().marked_at_end(4.0)
    };
    let panel = |run: &Run| {
        let axes = [
            Axis::linear("x in the ecliptic, towards the vernal equinox (AU)", -36.0..50.0),
            Axis::linear("y (AU)", -36.0..50.0),
        ];
        let note = format!("{} steps of {:.0} days, forces once in 10 days", run.steps, run.step_size());
        Panel::new(format!("Outer planets, {}", run.name), note, axes, (0..6).map(|i| curve(run, i)).collect()).equal()
    };
    figure("outer_solar_system_orbits.svg", (1, 1), &[panel(wrong), panel(right)])
}

fn draw_energy_errors(runs: &[Run]) -> Result<(), Box<dyn Error>> {
    let colours = [
        ("ExplicitEuler", palette::BLACK),
        ("StormerVerlet", palette::VERMILION),
        ("BlanesMoan4", palette::ORANGE),
        ("BceRkn17_8", palette::GREEN),
        ("DiscreteGradient", palette::BLUE),
    ];
    let curve = |(name, colour): (&str, Ink)| -> Option<Curve> {
        let run = runs.iter().find(|run| run.name == name)?;
        // The error vanishes now and then. The largest error in each block of 5000 days, about a period of Jupiter, gives a legible curve.
        let period = |state: &Bodies| (state.t / 5000.0 - 0.001).ceil();
        let periods = run.samples[1..].chunk_by(|a, b| period(a) == period(b));
        let points = periods.map(|period| (period[period.len() / 2].t / 365.25, energy_error(period))).collect();
        let line = Curve::line(format!("{name}, h = {:.0} d", run.step_size()), colour, points);
        Some(if run.energy_error() < 1e-12 { line.width(1.0).rounding() } else { line })
    };
    let panel = Panel::new(
        "Outer solar system: error of the energy",
        "explicit methods evaluate the forces once in 10 days",
        [Axis::linear("time (years)", 0.0..550.0), Axis::decades("relative error, largest in 5000 days", -16.0..0.0)],
        colours.into_iter().filter_map(curve).collect(),
    );
    figure("outer_solar_system_energy.svg", (3, 2), &[panel])
}
