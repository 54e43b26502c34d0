//! Chaotic motion over a long time.

use super::{Job, Part, Section, all, row, short};
use crate::run::{Outcome, adapting, fixed};
use geoint_runtime::TaylorIntegrator;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::problems::{DoublePendulum, HenonHeiles};

const LOOKS: u32 = 1000;
const TITLES: &[&str] = &["", "method", "h", "energy", "steps", "end"];
const SYSTEMS: [&str; 2] = ["Hénon–Heiles", "double pendulum"];

fn told<S>(system: &str, name: &str, h: f64, outcome: &Outcome<S>, scale: f64, bound: f64) -> super::Row {
    let energy = outcome.energy / scale;
    let h = if h > 0.0 { h.to_string() } else { "its own".into() };
    let cells = vec![system.into(), name.into(), h, short(energy), outcome.steps.to_string(), outcome.end()];
    row(cells, energy <= bound && outcome.refused.is_none())
}

/// Returns four standard deviations of a random walk of `steps` steps. Each step rounds a coordinate of size `far`.
fn walk(far: f64, steps: u64) -> f64 {
    4.0 * f64::EPSILON * (1.0 + far) * (steps as f64).sqrt()
}

/// Returns the largest coordinate of a state, or `far`.
fn farthest(far: f64, state: &State<[f64; 2]>) -> f64 {
    state.q.iter().fold(far, |far, q| far.max(q.abs()))
}

macro_rules! rows {
    ($jobs:ident, $name:expr, $system:expr, $scale:expr, $end:expr; $($start:expr, $h:literal, $law:literal: $method:expr),*; $last:expr) => {
        $( $jobs.push(Box::new(|| {
            let mut far = 0.0;
            let run = $system.integrator($method, $h, $start);
            let outcome = fixed(run, ($end / $h) as u64, LOOKS, |state| far = farthest(far, state));
            told($name, stringify!($method), $h, &outcome, $scale, $law + walk(far, outcome.steps))
        })); )*
        $jobs.push(Box::new(|| {
            let mut far = 0.0;
            let run = TaylorIntegrator::new($system, Taylor::default(), $last);
            let outcome = adapting(run, $end, LOOKS, |state| far = farthest(far, state));
            told($name, "Taylor", 0.0, &outcome, $scale, walk(far, outcome.steps))
        }));
    };
}

const ESCAPE: f64 = 1.0 / 6.0;

/// Returns a start with the given energy.
fn galactic(energy: f64) -> State<[f64; 2]> {
    let (y, p): (f64, f64) = (-0.15, 0.1);
    let potential = y * y / 2.0 - y * y * y / 3.0;
    State::new([0.0, y], [(2.0 * (energy - potential) - p * p).sqrt(), p])
}

/// Runs at the energy from which orbits may escape.
fn galaxy() -> Vec<Job> {
    const SYSTEM: HenonHeiles = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };
    // Verlet's method keeps an energy that differs from H by h²/12 times brackets below 1. A start that is lower by this margin must not escape.
    const BELOW: f64 = ESCAPE - 0.01 * 0.01;
    let mut jobs: Vec<Job> = vec![];
    rows! { jobs, SYSTEMS[0], SYSTEM, ESCAPE, 1e6;
        galactic(BELOW), 0.01, 1e-4: StormerVerlet, galactic(ESCAPE), 0.1, 1e-5: BlanesMoan4, galactic(ESCAPE), 0.1, 1e-11: BlanesMoanSrkn14a,
        galactic(ESCAPE), 0.1, 1e-7: Gauss::<3>, galactic(ESCAPE), 0.1, 0.0: DiscreteGradient,
        galactic(ESCAPE), 0.1, 0.0: FourthOrder(DiscreteGradient), galactic(ESCAPE), 0.1, 0.0: Projection(RK4, Energy);
        galactic(ESCAPE)
    }
    jobs
}

/// Runs of a double pendulum that turns over.
fn double_pendulum() -> Vec<Job> {
    const SYSTEM: DoublePendulum = DoublePendulum { m1: 1.3, m2: 0.7, l1: 1.0, l2: 0.8, g: 9.81 };
    const SCALE: f64 = 30.0;
    fn start() -> State<[f64; 2]> {
        State::new([2.5, 3.0], [3.0, 1.0])
    }
    let mut jobs: Vec<Job> = vec![];
    rows! { jobs, SYSTEMS[1], SYSTEM, SCALE, 1e6;
        start(), 0.01, 1e-2: ImplicitMidpoint, start(), 0.02, 1e-2: Gauss::<3>, start(), 0.05, 0.0: DiscreteGradient,
        start(), 0.02, 0.0: FourthOrder(DiscreteGradient);
        start()
    }
    jobs
}

/// Returns the section of both systems.
pub(super) fn chaos() -> Section {
    Section {
        title: "Chaos",
        text: "10⁶ units of time. Hénon–Heiles at E = 1/6, where orbits begin to escape, with h = 0.1 (StormerVerlet 0.01). A double pendulum that turns \
               over, with h = 0.01 to 0.05.",
        head: TITLES,
        part: Part::Pivot { row: 1, by: 0, cells: &SYSTEMS, value: 3, chosen: all },
        jobs: galaxy().into_iter().chain(double_pendulum()).collect(),
    }
}
