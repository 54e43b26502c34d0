//! How far does a computed population leave its closed orbit in a hundred thousand periods?
//!
//! Prey x and predators y have the integral b x − c ln x + b y − a ln y. It follows from the orbit equation dy/dx = y (b x − c) / (x (a − b y)).
//! The program has three forms of the system: a field with its integral, an energy with a structure matrix, and, in logarithms, an energy
//! T(p) + V(q). Steps that keep the integral stay on the orbit. Steps of RK4 leave it slowly: the error grows in proportion to time.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{changes, claim, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace};
use std::error::Error;

/// x = [prey, predators]. The macro proves at compile time that the integral is constant.
#[vector_field(keeps(integral = b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
fn predators(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}

/// The predator–prey system as S(x) ∇H. It has two coordinates, so `PlanarSplitting` has one plane.
#[hamiltonian(structure = [[0.0, -x[0] * x[1]], [x[0] * x[1], 0.0]])]
fn lotka_volterra(x: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()
}

/// The predator–prey system in q = ln y and p = ln x. These coordinates are canonical, and H is T(p) + V(q).
#[hamiltonian]
fn logarithms(q: f64, p: f64, a: f64, b: f64, c: f64) -> f64 {
    b * p.exp() - c * p + b * q.exp() - a * q
}

const FIELD: Predators = Predators { a: 2.0, b: 1.0, c: 1.0 };
const FLOW: LotkaVolterra = LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 };
const CANONICAL: Logarithms = Logarithms { a: 2.0, b: 1.0, c: 1.0 };
const START: [f64; 2] = [1.0, 0.5];
/// Exact period of the orbit, from the trapezoidal rule in an angle along the orbit, with both branches of Lambert's function.
const PERIOD: f64 = 5.173_375_597_582_039;
const PERIODS: u64 = 100_000;
const STEPS: u64 = 50;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Predators::REPORT);
    let start = FlowState::new(START);
    let logs = State::new(START[1].ln(), START[0].ln());
    let prey_and_predators = |x: &FlowState<[f64; 2]>| x.x;
    let runs = [
        run(FIELD, RK4, start, palette::VERMILION, prey_and_predators)?,
        run(FLOW, PlanarSplitting, start, palette::BLUE, prey_and_predators)?,
        run(FIELD, FourthOrder(DiscreteGradient), start, palette::GREEN, prey_and_predators)?,
        run(CANONICAL, BlanesMoan4, logs, palette::BLACK, |x| [x.p.exp(), x.q.exp()])?,
    ];
    println!("{PERIODS} periods of {STEPS} steps: largest change of the integral so far\n");
    println!("{}", table(["method", "1 period", "1000", "100 000"], &runs.each_ref().map(Run::row)));
    let [rk4, planar, fourth, canonical] = &runs;
    claim("PlanarSplitting and FourthOrder(DiscreteGradient) keep the integral to rounding", {
        [planar, fourth].iter().all(|run| run.after(PERIODS) < 1e-12)
    })?;
    claim("a symplectic method of order 4 has the error after 100 000 periods that it has after 1000", {
        canonical.after(PERIODS) < 1.5 * canonical.after(1000) && canonical.after(PERIODS) > 1e-9
    })?;
    claim("that of RK4 grows like time, and its orbit is another one in the end", {
        (50.0..150.0).contains(&(rk4.after(1000) / rk4.after(10))) && rk4.after(PERIODS) > 0.1
    })?;
    let outside = |run: &Run| run.last.iter().map(|x| (integral(*x) - integral(START)).abs()).fold(0.0, f64::max);
    claim("the last period of the planar steps lies on the first orbit", outside(planar) < 1e-12)?;

    let mut orbit = vec![START];
    let mut sim = FIELD.integrator(FourthOrder(DiscreteGradient), PERIOD / 400.0, start);
    for state in sim.sampled(1).take(400) {
        orbit.push(state?.x);
    }
    let mut orbits = vec![Curve::line("true orbit", palette::GREY, orbit.into_iter().map(Into::into).collect())];
    for (name, run) in [("PlanarSplitting", planar), ("RK4", rk4)] {
        orbits.push(Curve::dots(name, run.ink, run.last.iter().map(|x| (x[0], x[1])).collect()).marked(3.0));
    }
    let errors = runs.iter().map(|run| {
        let points = run.changes.iter().map(|(t, [change])| (t / PERIOD, *change)).collect();
        let curve = Curve::line(run.name.clone(), run.ink, points);
        if run.after(PERIODS) < 1e-12 { curve.rounding() } else { curve }
    });
    figure(
        "lotka_volterra.svg",
        (4, 3),
        &[
            Panel::new(
                "Prey and predators after 100 000 periods",
                "one period in steps of 1/50 of a period; a = 2, b = c = 1, dimensionless",
                [Axis::linear("prey", 0.0..4.0), Axis::linear("predators", 0.0..6.0)],
                orbits,
            ),
            Panel::new(
                "Prey and predators: change of the integral",
                "h = 1/50 of a period, dimensionless; BlanesMoan4 in logarithms",
                [Axis::decades("periods", -1.7..5.0), Axis::decades("|I − I₀|, largest so far", -16.5..1.0)],
                errors.collect(),
            ),
        ],
    )
}

fn integral(x: [f64; 2]) -> f64 {
    FIELD.integral(&FlowState::new(x))
}

/// Changes of the integral, and last points, of one method.
struct Run {
    name: String,
    ink: Ink,
    changes: Vec<(f64, [f64; 1])>,
    last: Vec<[f64; 2]>,
}

impl Run {
    fn after(&self, periods: u64) -> f64 {
        let time = periods as f64 * PERIOD * 0.999;
        self.changes.iter().find(|sample| sample.0 >= time).map_or(f64::NAN, |sample| sample.1[0])
    }

    fn row(&self) -> [String; 4] {
        let [a, b, c] = [1, 1000, PERIODS].map(|periods| format!("{:.1e}", self.after(periods)));
        [self.name.clone(), a, b, c]
    }
}

fn run<S: PhaseSpace, M: Method<S>>(
    system: S,
    method: M,
    start: StateOf<S, f64>,
    ink: Ink,
    plane: impl Fn(&StateOf<S, f64>) -> [f64; 2],
) -> Result<Run, StepError> {
    let mut sim = Integrator::new(system, method, PERIOD / STEPS as f64, start);
    let changes = changes(&mut sim, PERIODS * STEPS, |state| [integral(plane(state))])?;
    let last = sim.sampled(1).take(STEPS as usize).map(|state| state.map(|state| plane(&state)));
    Ok(Run { name: method.name().to_string(), ink, changes, last: last.collect::<Result<_, _>>()? })
}
