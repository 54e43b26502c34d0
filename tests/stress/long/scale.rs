//! Extreme units, large coordinates, short numbers.

use super::{Job, Part, Row, Section, all, row, short};
use crate::run::{Outcome, fixed};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Claims, Method};
use geoint_tests::problems::{Kepler, Pendulum, ShortPendulum};
use std::f64::consts::TAU;

const CASES: [&str; 5] = ["units", "q = 1e8", "q = 1e9", "swing 1e-8", "`f32`"];

/// Adds a row for each method of these sections, and for additional methods.
macro_rules! methods {
    ($jobs:ident, $row:expr $(, $more:expr)*) => {
        methods!(@ $jobs, $row, StormerVerlet, BlanesMoanSrkn14a, ImplicitMidpoint, Gauss::<3>, DiscreteGradient,
            FourthOrder(DiscreteGradient), Projection(RK4, Energy) $(, $more)*)
    };
    (@ $jobs:ident, $row:expr, $($method:expr),*) => { $( $jobs.push(Box::new(|| $row($method))); )* };
}

/// Returns a bound on the relative change of the energy: 2hᵖ for steps of h radians, and 0 for methods that keep the energy.
fn law(claims: Claims, h: f64) -> f64 {
    if claims.conserves_energy { 0.0 } else { 2.0 * h.powi(claims.order as i32) }
}

/// Returns four standard deviations of a random walk over `steps` steps. Each step makes one rounding error of size `epsilon`, or one in every flow.
fn walk(claims: Claims, epsilon: f64, steps: u64) -> f64 {
    let roundings = if claims.symplectic { claims.forces.unwrap_or(1) } else { 1 };
    4.0 * epsilon * (steps as f64 * f64::from(roundings)).sqrt()
}

/// Returns the mean motion of the orbit below, in radians per unit of time, in units 1. It follows from the semi-major axis.
fn mean_motion(start: &State<[f64; 2]>) -> f64 {
    let ([x, y], [u, v]) = (start.q, start.p);
    (2.0 / x.hypot(y) - (u * u + v * v)).powf(1.5)
}

/// One orbit in 25 units, with masses and lengths from 1e-30 to 1e30.
fn units() -> Vec<Job> {
    const STEPS: u64 = 100_000;
    const H: f64 = 0.05;
    const EACH: [f64; 5] = [1e-30, 1e-10, 1.0, 1e10, 1e30];
    fn start(mass: f64, length: f64) -> State<[f64; 2]> {
        State::new([0.9 * length, 0.2 * length], [-0.3 * mass, 0.9 * mass])
    }
    fn ran<M: Method<Kepler>>(method: M, mass: f64, length: f64) -> Outcome<State<[f64; 2]>> {
        // The unit of time is the time scale of the orbit in units of its mass and length.
        let system = Kepler { mass, mu: mass * length };
        fixed(system.integrator(method, H * length, start(mass, length)), STEPS, 100, |_| ())
    }
    fn told<M: Method<Kepler>>(method: M) -> Row {
        let plain = ran(method, 1.0, 1.0);
        let (mut worst, mut energy, mut refused) = (0.0_f64, 0.0_f64, None);
        for mass in EACH {
            for length in EACH {
                let other = ran(method, mass, length);
                let gap = (0..2).map(|i| {
                    (other.state.q[i] / length - plain.state.q[i])
                        .abs()
                        .max((other.state.p[i] / mass - plain.state.p[i]).abs())
                });
                worst = gap.fold(worst, f64::max);
                energy = energy.max(other.energy / mass);
                refused = refused.or(other.refused);
            }
        }
        let end = refused.map_or("reached".into(), |error| format!("refused: {error}"));
        let claims = method.claims();
        // If a method keeps no energy, coefficients that are rounded separately in each unit change the energy by a few ε per radian.
        let turned = mean_motion(&start(1.0, 1.0)) * H * STEPS as f64;
        let drift = if claims.symplectic || claims.conserves_energy { 0.0 } else { 2.0 * f64::EPSILON * turned };
        let rounding = walk(claims, f64::EPSILON, STEPS);
        // Energy errors that grow like √N, and errors that grow like N, change the phase of the orbit by this amount.
        let allowed = turned * (1.5 / 3_f64.sqrt() * rounding + 0.75 * drift);
        let holds = worst <= allowed && end == "reached" && (energy - plain.energy).abs() <= rounding + drift;
        let end = format!("{end}; energy errors {}, and {} in units 1", short(energy), short(plain.energy));
        let steps = STEPS.to_string();
        row(vec![CASES[0].into(), method.name().to_string(), short(worst), short(allowed), steps, end], holds)
    }
    let mut jobs: Vec<Job> = vec![];
    methods!(jobs, told, DOP853);
    jobs
}

/// A pendulum whose small swings have an angular frequency of 1.
const SYSTEM: Pendulum = Pendulum { m: 1.3, l: 1.0, g: 1.0 };
const SCALE: f64 = 1.3;

/// Coordinates that are large relative to their increments, and energies that are small relative to their terms.
fn places() -> Vec<Job> {
    const STEPS: u64 = 1_000_000;
    const SMALL: f64 = 1e-8;
    fn told<M: Method<Pendulum>>(what: &str, method: M, outcome: &Outcome<State<f64>>, energy: f64, bound: f64) -> Row {
        let cells = vec![
            what.into(),
            method.name().to_string(),
            short(energy),
            short(bound),
            outcome.steps.to_string(),
            outcome.end(),
        ];
        row(cells, energy <= bound && outcome.refused.is_none())
    }
    /// A rounding of q changes cos q by the same amount.
    fn far<M: Method<Pendulum>>(what: &str, method: M, h: f64, start: State<f64>) -> Row {
        let outcome = fixed(SYSTEM.integrator(method, h, start), STEPS, 1000, |_| ());
        let bound = law(method.claims(), h) + walk(method.claims(), start.q * f64::EPSILON, STEPS);
        told(what, method, &outcome, outcome.energy / SCALE, bound)
    }
    fn swings<M: Method<Pendulum>>(method: M) -> Row {
        let start = State::new(TAU * (1e8 / TAU).round() + 0.8, 0.3);
        far(CASES[1], method, 0.05, start)
    }
    fn turns<M: Method<Pendulum>>(method: M) -> Row {
        far(CASES[2], method, 0.025, State::new(1e9 - 5e4, 1.3 * 2.5))
    }
    /// The energy above the energy at rest, as a sum of squares.
    fn small<M: Method<Pendulum>>(method: M) -> Row {
        let energy = |x: &State<f64>| x.p * x.p / (2.0 * SCALE) + SCALE * 2.0 * (x.q / 2.0).sin().powi(2);
        let (start, mut worst) = (State::new(SMALL, 0.0), 0.0_f64);
        let outcome = fixed(SYSTEM.integrator(method, 0.05, start), STEPS, 1000, |x| {
            worst = worst.max((energy(x) / energy(&start) - 1.0).abs())
        });
        let bound = law(method.claims(), 0.05) + walk(method.claims(), f64::EPSILON, STEPS);
        told(CASES[3], method, &outcome, worst, bound)
    }
    let mut jobs: Vec<Job> = vec![];
    methods!(jobs, swings);
    methods!(jobs, turns);
    methods!(jobs, small);
    jobs
}

/// Runs with numbers of 24 bits.
fn single() -> Vec<Job> {
    const STEPS: u64 = 10_000_000;
    const H: f32 = 0.02;
    fn told<M: Method<ShortPendulum, f32>>(method: M) -> Row {
        let system = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
        let outcome = fixed(system.integrator(method, H, State::new(0.8, 0.1)), STEPS, 1000, |_| ());
        let energy = outcome.energy / (1.3 * 0.7 * 9.81);
        // Angle by which small swings turn in a step.
        let turned = f64::from(H) * (9.81_f64 / 0.7).sqrt();
        let bound = law(method.claims(), turned) + walk(method.claims(), f32::EPSILON.into(), STEPS);
        let cells = vec![
            CASES[4].into(),
            method.name().to_string(),
            short(energy),
            short(bound),
            outcome.steps.to_string(),
            outcome.end(),
        ];
        row(cells, energy <= bound && outcome.refused.is_none())
    }
    let mut jobs: Vec<Job> = vec![];
    methods!(jobs, told);
    jobs
}

/// Returns the section of all cases.
pub(super) fn scale() -> Section {
    Section {
        title: "Scale",
        text: "Units: largest gap between final states of an orbit in 25 systems of units, with masses and lengths from 1e-30 to 1e30. Others: error of a \
               pendulum over m·g·l, or over the energy of the small swing.",
        head: &["", "method", "error", "allowed", "steps", "end"],
        part: Part::Pivot { row: 1, by: 0, cells: &CASES, value: 2, chosen: all },
        jobs: units().into_iter().chain(places()).chain(single()).collect(),
    }
}
