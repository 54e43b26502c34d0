//! Extreme units, large coordinates, short numbers.

use super::{Job, Row, Section, row, short};
use crate::run::{Outcome, fixed};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use geoint_tests::problems::{Kepler, Pendulum, ShortPendulum};

/// The same orbit with masses and lengths from 1e-30 to 1e30.
pub(super) fn units() -> Section {
    const STEPS: u64 = 100_000;
    const EACH: [f64; 5] = [1e-30, 1e-10, 1.0, 1e10, 1e30];
    fn ran<M: Method<Kepler>>(method: M, mass: f64, length: f64) -> Outcome<State<[f64; 2]>> {
        // The unit of time is that of the orbit in units of its mass and length.
        let system = Kepler { mass, mu: mass * length };
        let (unit, p) = (length, mass);
        let start = State::new([0.9 * unit, 0.2 * unit], [-0.3 * p, 0.9 * p]);
        fixed(system.integrator(method, 0.05 * length, start), STEPS, 100, |_| ())
    }
    fn told<M: Method<Kepler>>(name: &str, method: M) -> Row {
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
        let holds = worst <= 1e-7 && end == "reached" && (energy - plain.energy).abs() <= 1e-11;
        row(vec![name.into(), short(worst), short(energy), short(plain.energy), end], holds)
    }
    let mut jobs: Vec<Job> = vec![];
    macro_rules! rows {
        ($($method:expr),*) => { $( jobs.push(Box::new(|| told(stringify!($method), $method))); )* };
    }
    rows!(
        StormerVerlet,
        BlanesMoanSrkn14a,
        ImplicitMidpoint,
        Gauss::<3>,
        DiscreteGradient,
        FourthOrder(DiscreteGradient),
        Projection(RK4, Energy),
        DOP853
    );
    Section {
        title: "Scale: units",
        text: "An orbit in 25 systems of units, masses and lengths 1e-30, 1e-10, 1, 1e10 and 1e30 each, over 10⁵ steps: the largest gap between states at the end, \
               in units of each, and the largest error of the energy beside that with masses and lengths 1. Gaps are rounding, which grows along \
               the orbit like t². (In units by powers of two there is no gap: `tests/stability/units.rs`.)",
        head: &["method", "gap", "energy", "energy, units 1", "end"],
        jobs,
    }
}

fn swings<M: Method<Pendulum>>(method: M, h: f64, q: f64, p: f64, steps: u64) -> (Outcome<State<f64>>, f64) {
    let system = Pendulum { m: 1.3, l: 1.0, g: 1.0 };
    let outcome = fixed(system.integrator(method, h, State::new(q, p)), steps, 1000, |_| ());
    let energy = outcome.energy;
    (outcome, energy)
}

/// Coordinates that are large beside their increments, and energies that are small beside their parts.
pub(super) fn places() -> Section {
    let mut jobs: Vec<Job> = vec![];
    const STEPS: u64 = 1_000_000;
    const TURN: f64 = std::f64::consts::TAU;
    let told = |what: &str, name: &str, (outcome, energy): (Outcome<State<f64>>, f64), scale: f64, bound: f64| -> Row {
        let cells = vec![
            what.into(),
            name.into(),
            short(energy / scale),
            short(bound / scale),
            outcome.steps.to_string(),
            outcome.end(),
        ];
        row(cells, energy <= bound && outcome.refused.is_none())
    };
    macro_rules! rows {
        ($($method:expr),*) => { $(
            // 1.3 cos q changes by this where q is rounded.
            jobs.push(Box::new(move || {
                let bound = 1.3 * 1e8 * f64::EPSILON * (STEPS as f64).sqrt() + order_error(0.05, stringify!($method));
                told("swing about q = 1e8", stringify!($method), swings($method, 0.05, TURN * (1e8 / TURN).round() + 0.8, 0.3, STEPS), 1.3, bound)
            }));
            jobs.push(Box::new(move || {
                let bound = 1.3 * 1e9 * f64::EPSILON * (STEPS as f64).sqrt() + order_error(0.05, stringify!($method));
                told("turns up to 10⁹ radians", stringify!($method), swings($method, 0.025, 1e9 - 5e4, 1.3 * 2.5, STEPS), 1.3, bound)
            }));
            jobs.push(Box::new(move || {
                let bound = 1.3 * 1e-16 * 1e-9;
                told("small swing, energy 1e-16", stringify!($method), swings_near_zero($method, 1e-8, STEPS), 1.3 * 1e-16, if order_error(0.05, stringify!($method)) > 0.0 { 1.3e-16 * 1e-2 } else { bound })
            }));
        )* };
    }
    rows!(
        StormerVerlet,
        BlanesMoanSrkn14a,
        ImplicitMidpoint,
        Gauss::<3>,
        DiscreteGradient,
        FourthOrder(DiscreteGradient)
    );
    Section {
        title: "Scale: places",
        text: "A pendulum over 10⁶ steps far from q = 0, where q is rounded by more than it is near to it, and with swings of 1e-8, whose energy above that at \
               rest is 1e-16: the largest error of the energy, over m·g·l, or over that of the small swing, and what is allowed.",
        head: &["", "method", "energy", "allowed", "steps", "end"],
        jobs,
    }
}

/// What methods that do not keep the energy may lose at steps of this length: some h².
fn order_error(h: f64, name: &str) -> f64 {
    match name {
        "StormerVerlet" | "ImplicitMidpoint" => 2.0 * h * h,
        _ => 0.0,
    }
}

/// The energy above that at rest, as a sum of squares.
fn swings_near_zero<M: Method<Pendulum>>(method: M, q: f64, steps: u64) -> (Outcome<State<f64>>, f64) {
    let system = Pendulum { m: 1.3, l: 1.0, g: 1.0 };
    let energy = |x: &State<f64>| x.p * x.p / 2.6 + 1.3 * 2.0 * (x.q / 2.0).sin().powi(2);
    let (start, mut worst) = (State::new(q, 0.0), 0.0_f64);
    let outcome = fixed(system.integrator(method, 0.05, start), steps, 1000, |x| {
        worst = worst.max((energy(x) - energy(&start)).abs())
    });
    (outcome, worst)
}

/// Numbers of 24 bits.
pub(super) fn single() -> Section {
    const STEPS: u64 = 10_000_000;
    let mut jobs: Vec<Job> = vec![];
    macro_rules! rows {
        ($($h:literal, $law:literal: $method:expr),*) => { $( jobs.push(Box::new(|| {
            let system = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
            let outcome = fixed(system.integrator($method, $h, State::new(0.8, 0.1)), STEPS, 1000, |_| ());
            let energy = outcome.energy / (1.3 * 0.7 * 9.81);
            let bound = $law + 4.0 * f64::from(f32::EPSILON) * (STEPS as f64).sqrt();
            let cells = vec![stringify!($method).into(), $h.to_string(), short(energy), short(bound), outcome.steps.to_string(), outcome.end()];
            row(cells, energy <= bound && outcome.refused.is_none())
        })); )* };
    }
    rows!(0.02, 4e-3: StormerVerlet, 0.02, 0.0: BlanesMoanSrkn14a, 0.02, 4e-3: ImplicitMidpoint, 0.02, 0.0: Gauss::<3>, 0.02, 0.0: DiscreteGradient,
        0.02, 0.0: FourthOrder(DiscreteGradient), 0.02, 0.0: Projection(RK4, Energy));
    Section {
        title: "Scale: single precision",
        text: "A pendulum in `f32` over 10⁷ steps: the largest error of the energy over m·g·l, and what is allowed, the error of the method and four standard deviations of a \
               random walk of roundings. All methods over 10⁵ steps: `tests/builds/single.rs`.",
        head: &["method", "h", "energy", "allowed", "steps", "end"],
        jobs,
    }
}
