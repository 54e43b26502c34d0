//! By how much does general relativity turn Mercury's perihelion in a century, and which methods show it?
//!
//! The first correction to Newton's law adds −3(GM)²m/(c²r²) to the energy. It turns the ellipse by 42.98″ in a century, half a millionth of a
//! turn on each orbit. A. M. Nobili & I. W. Roxburgh, *Relativity in Celestial Mechanics and Astrometry* (1986) 105. Exact Kepler motion does
//! not turn the ellipse, so methods with an exact Kepler flow show the correction alone. Steps of Störmer and Verlet add a turn of their own.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// The Sun and a planet in a plane; q in AU, p in solar masses · AU/d, m in solar masses, g in AU³/(d² solar mass), c in AU/d.
#[hamiltonian(coordinates = jacobi)]
fn relativistic(q: [[f64; 2]; 2], p: [[f64; 2]; 2], m: [f64; 2], g: f64, c: f64) -> f64 {
    let kinetic = |i: usize| (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
    let square = (q[1][0] - q[0][0]).powi(2) + (q[1][1] - q[0][1]).powi(2);
    let newton = g * m[0] * m[1] / square.sqrt();
    kinetic(0) + kinetic(1) - newton - 3.0 * (g * m[0] / c).powi(2) * m[1] / square
}

const SYSTEM: Relativistic =
    Relativistic { m: [1.0, 1.0 / 6_023_600.0], g: 2.959_122_082_855_911e-4, c: 173.144_632_684_669_3 };

/// Semi-major axis of Mercury's orbit, in AU.
const SEMI_MAJOR_AXIS: f64 = 0.387_098_93;
const ECCENTRICITY: f64 = 0.205_630_69;

const CENTURY: f64 = 36_525.0;

/// Returns the total mass times the constant of gravity.
fn attraction() -> f64 {
    SYSTEM.g * (SYSTEM.m[0] + SYSTEM.m[1])
}

/// Returns Mercury's orbital period in days.
fn period() -> f64 {
    std::f64::consts::TAU * (SEMI_MAJOR_AXIS.powi(3) / attraction()).sqrt()
}

/// Returns the predicted rate 6πGM/(c²a(1 − e²)) per orbit, in seconds of arc a century.
fn predicted() -> f64 {
    let orbit = 6.0 * std::f64::consts::PI * SYSTEM.g * SYSTEM.m[0]
        / (SYSTEM.c.powi(2) * SEMI_MAJOR_AXIS * (1.0 - ECCENTRICITY.powi(2)));
    orbit.to_degrees() * 3600.0 * CENTURY / period()
}

/// Returns the state in the perihelion, with the centre of mass at rest.
fn start() -> State<[[f64; 2]; 2]> {
    let distance = SEMI_MAJOR_AXIS * (1.0 - ECCENTRICITY);
    let speed = (attraction() / SEMI_MAJOR_AXIS * (1.0 + ECCENTRICITY) / (1.0 - ECCENTRICITY)).sqrt();
    let [sun, planet] = SYSTEM.m;
    let momentum = speed * sun * planet / (sun + planet);
    let q = [[-distance * planet / (sun + planet), 0.0], [distance * sun / (sun + planet), 0.0]];
    State::new(q, [[0.0, -momentum], [0.0, momentum]])
}

/// Returns the direction of the Laplace vector in seconds of arc. It points to the perihelion of the osculating Kepler ellipse.
fn perihelion(state: &State<[[f64; 2]; 2]>) -> f64 {
    let relative = |i: usize| {
        let velocity = |body: usize| state.p[body][i] / SYSTEM.m[body];
        (state.q[1][i] - state.q[0][i], velocity(1) - velocity(0))
    };
    let [(x, u), (y, v)] = [relative(0), relative(1)];
    let (moment, distance) = (x * v - y * u, x.hypot(y));
    let vector = (v * moment / attraction() - x / distance, -u * moment / attraction() - y / distance);
    vector.1.atan2(vector.0).to_degrees() * 3600.0
}

/// Motion of the perihelion and energy error of one method over a century.
struct Run {
    name: String,
    steps_an_orbit: u64,
    /// Time in years and direction of the perihelion in seconds of arc, once an orbit.
    turned: Vec<(f64, f64)>,
    energy_error: f64,
}

impl Run {
    /// Returns the rate in seconds of arc a century, as the slope of the line of least squares.
    fn rate(&self) -> f64 {
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| self.turned.iter().map(of).sum::<f64>() / self.turned.len() as f64;
        let (time, angle) = (mean(&|x| x.0), mean(&|x| x.1));
        100.0 * mean(&|x| (x.0 - time) * (x.1 - angle)) / mean(&|x| (x.0 - time).powi(2))
    }
}

fn run<M: Method<Relativistic, f64>>(method: M, steps_an_orbit: u64) -> Result<Run, StepError> {
    let mut sim = SYSTEM.integrator(method, period() / steps_an_orbit as f64, start());
    let energy = sim.energy();
    let (mut turned, mut energy_error) = (vec![], 0.0_f64);
    for state in sim.sampled(steps_an_orbit).take((CENTURY / period()) as usize) {
        let state = state?;
        turned.push((state.t / 365.25, perihelion(&state)));
        energy_error = energy_error.max((SYSTEM.energy(&state) / energy - 1.0).abs());
    }
    Ok(Run { name: method.name().to_string(), steps_an_orbit, turned, energy_error })
}

fn main() -> Result<(), Box<dyn Error>> {
    let runs = [
        run(StormerVerlet, 10_000)?,
        run(BlanesMoan4, 200)?,
        run(BlanesMoanSrkn14a, 40)?,
        run(WisdomHolman, 40)?,
        run(Saba4, 4)?,
    ];
    println!("Mercury, a century; general relativity predicts {:.2}″\n", predicted());
    let rows: Vec<_> = runs
        .iter()
        .map(|run| {
            [
                run.name.clone(),
                run.steps_an_orbit.to_string(),
                format!("{:.3}″", run.rate()),
                format!("{:+.1e}", run.rate() / predicted() - 1.0),
                format!("{:.1e}", run.energy_error),
            ]
        })
        .collect();
    println!("{}", table(["method", "steps an orbit", "perihelion", "relative error", "energy error"], &rows));

    let [verlet, .., holman, saba] = &runs;
    let off = |run: &Run| (run.rate() / predicted() - 1.0).abs();
    claim("general relativity predicts 42.98″", (predicted() - 42.98).abs() < 0.01)?;
    claim("40 steps of Wisdom and Holman an orbit have them to 0.1 %", off(holman) < 1e-3)?;
    claim("and so have 4 steps of four kicks", off(saba) < 1e-3)?;
    claim("10 000 steps of Störmer and Verlet an orbit do not", off(verlet) > 1e-2)?;
    println!();
    draw(&runs)
}

fn draw(runs: &[Run]) -> Result<(), Box<dyn Error>> {
    let inks: [Ink; 5] = [palette::VERMILION, palette::ORANGE, palette::PURPLE, palette::GREEN, palette::BLUE];
    let curve = |(run, ink): (&Run, Ink)| {
        let name = format!("{}, {} steps an orbit", run.name, run.steps_an_orbit);
        let points = |first, every| run.turned.iter().skip(first).step_by(every).copied().collect();
        match inks.iter().position(|other| *other == ink) {
            // Curves that coincide have their dots at different times.
            Some(i) if (run.rate() / predicted() - 1.0).abs() < 1e-2 => {
                Curve::dots(name, ink, points(20 * i, 60)).marked(3.4)
            }
            _ => Curve::line(name, ink, points(0, 20)),
        }
    };
    let exact = Curve::line("general relativity", palette::GREY, vec![(0.0, 0.0), (100.0, predicted())]);
    let panel = Panel::new(
        "Mercury's perihelion",
        "direction since the start, with the first correction to Newton's law; the markers of three methods lie on the line",
        [Axis::linear("time (years)", 0.0..100.0), Axis::linear("angle (″)", -25.0..50.0)],
        std::iter::once(exact).chain(runs.iter().zip(inks).map(curve)).collect(),
    );
    figure("mercury.svg", (3, 2), &[panel])
}
