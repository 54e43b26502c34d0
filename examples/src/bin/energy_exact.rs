//! How large is the error of the energy after a million steps?
//!
//! Four methods show four kinds of growth. Explicit Euler leaves the true motion at once. The classical Runge–Kutta method has a small error
//! that grows in proportion to time. Verlet's error is bounded: it reaches its maximum within one oscillation. The error of the discrete
//! gradient is rounding.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, Separable};
use std::error::Error;

/// Planar pendulum; q in rad, p in kg m²/s.
#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// A star in a galaxy with a symmetry of three parts. M. Hénon & C. Heiles, Astron. J. 69 (1964) 73.
#[hamiltonian]
fn henon_heiles(q: [f64; 2], p: [f64; 2]) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
}

const STEPS: u64 = 1_000_000;

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = Pendulum { m: 0.7, l: 1.2, g: 9.81 };
    let motions = [
        Motion::new("Pendulum", "s; a swing takes 3 s", pendulum, 0.02, State::new(2.0, 0.0)),
        Motion::new(
            "Hénon–Heiles",
            "(dimensionless); an oscillation takes 6",
            HenonHeiles,
            0.1,
            State::new([0.1, -0.2], [0.3, 0.25]),
        ),
    ];
    for Motion { name, h, runs, .. } in &motions {
        println!("{name}, steps of {h}: largest relative error of the energy so far\n");
        let head = ["method", "10 steps", "1000", "100 000", "1 000 000"];
        println!("{}", table(head, &runs.each_ref().map(Run::row)));
    }
    let all = |holds: fn(&[Run; 4]) -> bool| motions.iter().all(|motion| holds(&motion.runs));
    claim(
        "explicit Euler is off by more than the energy itself after 1000 steps",
        all(|[euler, ..]| euler.after(1_000) > 1.0),
    )?;
    claim("the error of RK4 is ten times as large after ten times as many steps", {
        all(|[_, rk4, ..]| (9.0..11.0).contains(&(rk4.after(STEPS) / rk4.after(STEPS / 10))))
    })?;
    claim("that of Verlet is the same after a million steps as after a thousand", {
        all(|[_, _, verlet, _]| verlet.after(STEPS) < 1.01 * verlet.after(1_000))
    })?;
    claim("that of the discrete gradient is below 1e-12", all(|[.., conserving]| conserving.after(STEPS) < 1e-12))?;
    println!();
    draw(&motions)
}

/// A motion by four methods.
struct Motion {
    name: &'static str,
    units: &'static str,
    h: f64,
    runs: [Run; 4],
}

impl Motion {
    fn new<S>(name: &'static str, units: &'static str, system: S, h: f64, start: State<S::Coordinates>) -> Self
    where
        S: Hamiltonian + Separable,
        DiscreteGradient: Method<S>,
    {
        let runs = [
            run(system, ExplicitEuler, h, start),
            run(system, RK4, h, start),
            run(system, StormerVerlet, h, start),
            run(system, DiscreteGradient, h, start),
        ];
        Motion { name, units, h, runs }
    }
}

/// Energy errors of one method in one motion.
struct Run {
    name: String,
    /// Step numbers, about twenty a decade, with the largest relative energy error so far. The list ends if the motion escapes.
    errors: Vec<(u64, f64)>,
}

impl Run {
    fn after(&self, steps: u64) -> f64 {
        self.errors.iter().find(|sample| sample.0 >= steps).map_or(f64::INFINITY, |sample| sample.1)
    }

    fn row(&self) -> [String; 5] {
        let [a, b, c, d] = [10, 1_000, 100_000, STEPS].map(|steps| match self.after(steps) {
            error if error.is_finite() => format!("{error:.1e}"),
            _ => "escaped".into(),
        });
        [self.name.clone(), a, b, c, d]
    }
}

fn run<S: Hamiltonian, M: Method<S>>(system: S, method: M, h: f64, start: State<S::Coordinates>) -> Run {
    let mut sim = Integrator::new(system, method, h, start);
    let first = sim.energy();
    let (mut largest, mut errors, mut due) = (0.0_f64, Vec::new(), 0);
    for n in 1..=STEPS {
        if sim.step().is_err() {
            break;
        }
        largest = largest.max((sim.energy() / first - 1.0).abs());
        let decade = 10_u64.pow(n.ilog10());
        if n >= due || n == decade {
            errors.push((n, largest));
            due = n + n.div_ceil(9);
        }
    }
    Run { name: method.name().to_string(), errors }
}

fn draw(motions: &[Motion]) -> Result<(), Box<dyn Error>> {
    let colours = [palette::BLACK, palette::ORANGE, palette::VERMILION, palette::BLUE];
    let curve = |(Run { name, errors }, colour): (&Run, Ink)| {
        let points = errors.iter().map(|&(n, error)| (n as f64, error));
        let line = Curve::line(name.clone(), colour, points.take_while(|point| point.1 < 100.0).collect());
        if *name == "DiscreteGradient" { line.rounding() } else { line }
    };
    let panel = |motion: &Motion| {
        let axes = [Axis::decades("steps", 0.0..6.0), Axis::decades("relative error, largest so far", -16.5..2.0)];
        let note = format!("h = {} {}", motion.h, motion.units);
        let title = format!("{}: error of the energy", motion.name);
        Panel::new(title, note, axes, motion.runs.iter().zip(colours).map(curve).collect())
    };
    figure("energy_exact.svg", (3, 2), &motions.iter().map(panel).collect::<Vec<_>>())
}
