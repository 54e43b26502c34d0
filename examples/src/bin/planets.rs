//! How long may a step be if the Kepler motion of each planet is exact?
//!
//! The problem is the outer planets over 547 years. The energy is a sum of Kepler motions A and a rest B, which is a thousandth of A. Steps
//! are long because B is small. In Jacobi's coordinates each planet moves about the centre of mass of the planets before it. In heliocentric
//! coordinates each planet moves about the Sun, and the motion of the Sun is part of B.

use geoint_examples::outer_planets::{self, start};
use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, shortest, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, Method};
use nalgebra::Vector3;
use std::error::Error;

/// Bodies under their mutual gravity; q in AU, p in solar masses · AU/d, m in solar masses, g in AU³/(d² solar mass).
#[hamiltonian(coordinates = jacobi)]
fn jacobi(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..6 {
        energy += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    energy
}

/// The same energy.
#[hamiltonian(coordinates = heliocentric)]
fn heliocentric(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..6 {
        energy += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    energy
}

type Bodies = State<[Vector3<f64>; 6]>;

const JACOBI: Jacobi = Jacobi { m: outer_planets::MASSES, g: outer_planets::GRAVITY };
const HELIOCENTRIC: Heliocentric = Heliocentric { m: outer_planets::MASSES, g: outer_planets::GRAVITY };

const DAYS: f64 = 200_000.0;

/// Smaller errors are rounding errors.
const ROUNDING: f64 = 3e-12;

/// The figure omits smaller errors, because rounding dominates them.
const DRAWN: f64 = 1e-11;

fn main() -> Result<(), Box<dyn Error>> {
    let exact = reference()?;
    let runs = [
        run(JACOBI, "", BlanesMoanSrkn14a, 14, &exact)?,
        run(JACOBI, "", BceRkn17_8, 17, &exact)?,
        run(JACOBI, "", WisdomHolman, 1, &exact)?,
        run(JACOBI, "", WisdomHolmanProcessed, 1, &exact)?,
        run(JACOBI, "", WisdomHolmanGradient, 1, &exact)?,
        run(JACOBI, "", Aba10_6_4, 8, &exact)?,
        run(HELIOCENTRIC, ", heliocentric", Aba10_6_4, 8, &exact)?,
    ];
    println!("Outer planets, {DAYS} days: the shortest run with an error of position and velocity below …\n");
    println!("{}", cheapest(&runs)?);

    let [srkn, _, holman, processed, gradient, jacobi, heliocentric] = &runs;
    let forces =
        |run: &Run, error: f64| run.steps_for(error).map_or(f64::INFINITY, |steps| (steps * run.stages) as f64);
    claim("to 1e-6 a processed step needs a tenth of the forces of the best table for kicks and drifts", {
        forces(processed, 1e-6) < 0.1 * forces(srkn, 1e-6)
    })?;
    claim(
        "to 1e-9 a step with a force gradient needs a twentieth",
        forces(gradient, 1e-9) < 0.05 * forces(srkn, 1e-9),
    )?;
    claim("the steps of the map of Wisdom and Holman are as long as an eighth of Jupiter's year", {
        holman.steps_for(1e-3).is_some_and(|steps| DAYS / steps as f64 > 4332.6 / 8.5)
    })?;
    claim("of order (10, 6, 4), heliocentric coordinates are as good as those of Jacobi", {
        forces(heliocentric, 1e-9) <= 1.2 * forces(jacobi, 1e-9)
    })?;
    println!();
    draw(&runs)
}

/// Errors and times of one method, by the number of its steps.
struct Run {
    name: String,
    stages: u64,
    errors: Vec<(u64, f64)>,
    times: Vec<f64>,
}

impl Run {
    /// Returns the smallest number of steps from which on all errors are below a bound.
    fn steps_for(&self, bound: f64) -> Option<u64> {
        let last = self.errors.iter().rposition(|(_, error)| *error > bound).map_or(0, |i| i + 1);
        self.errors.get(last).map(|(steps, _)| *steps)
    }
}

/// Runs a method with more and more steps, 15 % more each time, until only rounding errors remain.
fn run<S: Hamiltonian<Coordinates = [Vector3<f64>; 6]>, M: Method<S, f64>>(
    system: S,
    coordinates: &str,
    method: M,
    stages: u64,
    exact: &Bodies,
) -> Result<Run, StepError> {
    let mut run = Run { name: format!("{}{coordinates}", method.name()), stages, errors: vec![], times: vec![] };
    let mut steps = 60.0_f64;
    while run.errors.last().is_none_or(|(_, error)| *error > ROUNDING) && steps < 10_000.0 {
        let count = steps.round() as u64;
        let end = || -> Result<Bodies, StepError> {
            let mut sim = geoint_runtime::Integrator::new(system, method, DAYS / count as f64, start());
            sim.advance(count)?;
            Ok(sim.state())
        };
        // A step that is too long may fail. Its error counts as infinite.
        run.errors.push((count, end().map_or(f64::INFINITY, |state| error(&state, exact))));
        run.times.push(shortest(end).map_or(f64::INFINITY, |time| time.as_secs_f64()));
        steps *= 1.15;
    }
    Ok(run)
}

/// The relative error of positions and velocities of all bodies.
fn error(found: &Bodies, exact: &Bodies) -> f64 {
    let velocity = |state: &Bodies, i: usize| state.p[i] / JACOBI.m[i];
    let sum = |of: &dyn Fn(usize) -> f64| (0..6).map(of).sum::<f64>();
    let squares =
        sum(&|i| (found.q[i] - exact.q[i]).norm_squared() + (velocity(found, i) - velocity(exact, i)).norm_squared());
    (squares / sum(&|i| exact.q[i].norm_squared() + velocity(exact, i).norm_squared())).sqrt()
}

/// Returns the reference state, by a method of order 10 without Jacobi or heliocentric coordinates. Short steps leave rounding errors only.
fn reference() -> Result<Bodies, StepError> {
    let mut sim = JACOBI.integrator(SofroniouSpaletta10_35.of(StormerVerlet), 40.0, start());
    sim.advance((DAYS / 40.0) as u64)?;
    Ok(sim.state())
}

fn cheapest(runs: &[Run]) -> Result<String, Box<dyn Error>> {
    let bounds = [1e-3, 1e-6, 1e-9, 1e-11];
    let rows: Vec<[String; 5]> = runs
        .iter()
        .map(|run| {
            let cell = |bound: f64| {
                let steps = run.steps_for(bound)?;
                let time = run.errors.iter().zip(&run.times).find(|((count, _), _)| *count == steps)?.1;
                Some(format!("{:.0} µs ({steps} steps)", time * 1e6))
            };
            let [a, b, c, d] = bounds.map(|bound| cell(bound).unwrap_or_else(|| "–".into()));
            [run.name.clone(), a, b, c, d]
        })
        .collect();
    Ok(table(["method", "1e-3", "1e-6", "1e-9", "1e-11"], &rows))
}

fn draw(runs: &[Run]) -> Result<(), Box<dyn Error>> {
    let inks: [Ink; 7] = [
        palette::GREY,
        palette::BLACK,
        palette::BLUE,
        palette::VERMILION,
        palette::GREEN,
        palette::PURPLE,
        palette::ORANGE,
    ];
    let curve = |(run, ink): (&Run, Ink)| {
        let seen = run.errors.iter().filter(|(_, error)| (DRAWN..1.0).contains(error));
        let points = seen.map(|(steps, error)| ((steps * run.stages) as f64, *error)).collect();
        Curve::line(&run.name, ink, points).marked(2.2)
    };
    let panel = Panel::new(
        "Outer planets after 547 years",
        "each marker is a run; a kick with a force gradient counts as one force",
        [Axis::decades("forces", 1.5..5.2), Axis::decades("relative error of positions and velocities", -11.0..0.0)],
        runs.iter().zip(inks).map(curve).collect(),
    );
    figure("planets.svg", (4, 3), &[panel])
}
