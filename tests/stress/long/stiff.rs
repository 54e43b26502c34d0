//! Fast vibrations, fast decay, and long steps.

use super::{Job, Part, Row, Section, all, row, short};
use crate::run::{Outcome, adapting, fixed};
use crate::systems::{MASS, spring as spring_pendulum};
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, TaylorIntegrator};

/// Relaxation oscillations.
#[vector_field]
fn relaxing(x: [f64; 2], epsilon: f64) -> [f64; 2] {
    [x[1], epsilon * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

/// An oscillator.
#[hamiltonian]
fn oscillator(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0
}

/// An oscillator that hardens.
#[hamiltonian]
fn hardening(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * (q * q / 2.0 + q * q * q * q / 4.0)
}

/// Returns the section of a spring pendulum.
pub(super) fn spring() -> Section {
    const RATIO: f64 = 1000.0;
    const END: f64 = 100.0;
    let mut jobs: Vec<Job> = vec![];
    fn told(name: String, hw: String, outcome: &Outcome<State<[f64; 2]>>, bound: f64, refusal: bool) -> Row {
        let energy = outcome.energy / MASS;
        let length = outcome.state.q[0].hypot(outcome.state.q[1]) - 1.0;
        let cells = vec![name, hw, short(energy), short(length.abs()), outcome.steps.to_string(), outcome.end()];
        row(cells, energy <= bound && (refusal || outcome.refused.is_none()))
    }
    macro_rules! rows {
        ($($method:expr, $bounds:expr, $refusal:literal;)*) => { $( for (hw, bound) in [1.0, 10.0, 100.0].into_iter().zip($bounds) {
            jobs.push(Box::new(move || {
                let (system, start) = spring_pendulum(RATIO);
                let h = hw / RATIO;
                let outcome = fixed(system.integrator($method, h, start), (END / h) as u64, 100, |_| ());
                told(stringify!($method).into(), hw.to_string(), &outcome, bound, $refusal || bound == f64::INFINITY)
            }));
        } )* };
    }
    // A step of a Gauss method has the right length of the spring at its midpoint, and ends outside by h²v²/8. With hω = 100 the energy of the spring
    // there, (hω)²(hv²)²/128, is as large as the energy of the swing. U. M. Ascher & S. Reich, SIAM J. Sci. Comput. 21 (1999) 1045.
    const NONE: f64 = f64::INFINITY;
    rows! {
        ImplicitMidpoint, [1e-3, 1e-2, NONE], false;
        Gauss::<3>, [1e-9, 1e-5, NONE], false;
        DiscreteGradient, [1e-9; 3], false;
        FourthOrder(DiscreteGradient), [1e-9; 3], true;
    }
    // A relative error of 1e-9 in a coordinate is 1e-5 of the vibration, in each of 10⁵ steps. A method that damps may lose the whole energy of the
    // vibration, and no more.
    let vibration = 0.5 * (1e-4 * RATIO).powi(2) * (1.0 + 1e-6);
    macro_rules! adaptive {
        ($($tolerance:literal, $method:expr, $bound:expr);*) => { $( jobs.push(Box::new(move || {
            let (system, start) = spring_pendulum(RATIO);
            let outcome = adapting(system.adaptive($method, $tolerance, start), END, 100, |_| ());
            told(format!("adaptive({}), {:.0e}", stringify!($method), $tolerance), "".into(), &outcome, $bound, false)
        })); )* };
    }
    adaptive!(1e-9, DOP853, vibration; 1e-12, DOP853, 1e-5; 1e-9, Gauss::<3>, 1e-7);
    jobs.push(Box::new(|| {
        let (system, start) = spring_pendulum(RATIO);
        let outcome = adapting(TaylorIntegrator::new(system, Taylor::default(), start), END, 100, |_| ());
        told("Taylor".into(), "".into(), &outcome, 1e-9, false)
    }));
    Section {
        title: "Stiff: spring pendulum",
        text: "A spring vibrates a thousand times as fast as it swings, over 100 units of time. Error over m·g·l.",
        head: &["method", "hω", "energy", "stretch", "steps", "end"],
        part: Part::Pivot { row: 0, by: 1, cells: &["1", "10", "100"], value: 2, chosen: all },
        jobs,
    }
}

/// Relaxation oscillations.
pub(super) fn van_der_pol() -> Section {
    const SYSTEM: Relaxing = Relaxing { epsilon: 100.0 };
    const END: f64 = 1000.0;
    let start = || FlowState::new([2.0, 0.0]);
    let mut jobs: Vec<Job> = vec![];
    fn told(
        name: String,
        run: impl FnOnce(&mut dyn FnMut(&FlowState<[f64; 2]>)) -> Outcome<FlowState<[f64; 2]>>,
        bound: f64,
    ) -> Row {
        let mut largest = 0.0_f64;
        let outcome = run(&mut |state| largest = largest.max(state.x[0].abs()));
        let exact = TaylorIntegrator::new(SYSTEM, Taylor::default(), FlowState::new([2.0, 0.0]));
        let error = (outcome.state.x[0] - adapting(exact, END, 1, |_| ()).state.x[0]).abs();
        let cells = vec![name, short(error), format!("{largest:.3}"), outcome.steps.to_string(), outcome.end()];
        row(cells, bound == f64::INFINITY || largest < 2.1 && outcome.refused.is_none() && error <= bound)
    }
    macro_rules! rows {
        ($($h:literal, $bound:expr, $method:expr);*) => { $( jobs.push(Box::new(move || {
            let run = SYSTEM.integrator($method, $h, start());
            told(format!("{}, h = {}", stringify!($method), $h), |see| fixed(run, (END / $h) as u64, 1000, see), $bound)
        })); )* };
    }
    // Steps of 0.1 are longer than a jump, so their error has no bound. Gauss methods have |R(∞)| = 1 and do not damp the decay in 1/300 of a unit of time.
    // With explicit methods it grows.
    rows!(1e-3, 1e-2, ImplicitMidpoint; 1e-3, 1e-6, Gauss::<3>; 1e-3, 1e-6, DOP853; 0.1, f64::INFINITY, ImplicitMidpoint; 0.1, f64::INFINITY, Gauss::<3>; 0.1, f64::INFINITY, DOP853);
    macro_rules! adaptive {
        ($($tolerance:literal, $bound:literal: $method:expr),*) => { $( jobs.push(Box::new(move || {
            let run = SYSTEM.adaptive($method, $tolerance, start());
            told(format!("adaptive({}), {:.0e}", stringify!($method), $tolerance), |see| adapting(run, END, 1000, see), $bound)
        })); )* };
    }
    adaptive!(1e-9, 1e-4: DOP853, 1e-9, 1e-4: Gauss::<3>, 1e-9, 1e-4: RK4);
    Section {
        title: "Stiff: Van der Pol",
        text: "ε = 100, six oscillations: error of x at the end against Taylor series.",
        head: &["run", "error", "largest |x|", "steps", "end"],
        part: Part::Columns(&[0, 1], |cells| !cells[0].ends_with(", h = 0.1")),
        jobs,
    }
}

/// Steps of an oscillator.
const STEPS: u64 = 1_000_000;

/// Returns the largest change of the energy of an oscillator, relative to its energy at the start, and the outcome.
fn vibrate<S, M>(system: S, method: M, hw: f64) -> (f64, Outcome<State<f64>>)
where
    S: geoint_runtime::Hamiltonian<f64, Coordinates = f64>,
    M: Method<S>,
{
    let run = system.integrator(method, hw, State::new(1.0, 0.0));
    let start = run.energy();
    let outcome = fixed(run, STEPS, 1000, |_| ());
    (outcome.energy / start, outcome)
}

/// Steps from very short to longer than any bound.
pub(super) fn frequencies() -> Section {
    let mut jobs: Vec<Job> = vec![];
    let told = |name: &str, hw: f64, (energy, outcome): (f64, Outcome<State<f64>>), holds: bool| {
        let cells = vec![name.to_string(), hw.to_string(), short(energy), outcome.steps.to_string(), outcome.end()];
        row(cells, holds)
    };
    for hw in [0.01, 0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 2.01] {
        jobs.push(Box::new(move || {
            let found = vibrate(Oscillator { m: MASS, k: MASS }, StormerVerlet, hw);
            // Verlet's method keeps p²/2m + (1 − (hω/2)²) kq²/2.
            let bound = 1.0 / (1.0 - hw * hw / 4.0) - 1.0;
            let holds = if hw < 2.0 {
                found.0 <= bound * (1.0 + 1e-6) + 1e-11 && found.1.refused.is_none()
            } else {
                found.1.refused.is_some()
            };
            told("Verlet, oscillator", hw, found, holds)
        }));
    }
    // An increment of p is h k times a mean of q, in which terms as large as q cancel. Its rounding error is hω ε times the largest p.
    let rounding = |hw: f64| f64::EPSILON * hw.max(1.0);
    // Bounds for rounding errors that walk at random, and for errors of one sign. Rounded coefficients of stages cause the latter, or a pattern of
    // roundings, as for quarter turns.
    let walks = move |hw: f64| 16.0 * rounding(hw) * (STEPS as f64).sqrt();
    let drifts = move |hw: f64| 2.0 * rounding(hw) * STEPS as f64;
    let not_lost = |_: f64| 1.0;
    macro_rules! rows {
        ($($name:literal, $bound:expr, $system:expr, $method:expr;)*) => { $( for hw in [0.01, 0.1, 1.0, 1.99, 10.0, 100.0, 1000.0] {
            jobs.push(Box::new(move || {
                let found = vibrate($system, $method, hw);
                let holds = found.0 <= $bound(hw);
                told($name, hw, found, holds)
            }));
        } )* };
    }
    rows! {
        "implicit midpoint, oscillator", drifts, Oscillator { m: MASS, k: MASS }, ImplicitMidpoint;
        "Gauss 3, oscillator", drifts, Oscillator { m: MASS, k: MASS }, Gauss::<3>;
        "discrete gradient, oscillator", walks, Oscillator { m: MASS, k: MASS }, DiscreteGradient;
        "implicit midpoint, hardening", not_lost, Hardening { m: MASS, k: MASS }, ImplicitMidpoint;
        "discrete gradient, hardening", walks, Hardening { m: MASS, k: MASS }, DiscreteGradient;
        "discrete gradient of order 4, hardening", walks, Hardening { m: MASS, k: MASS }, FourthOrder(DiscreteGradient);
    }
    Section {
        title: "Long steps",
        text: "An oscillator, and one with the potential k(q²/2 + q⁴/4), over 10⁶ steps. Verlet's method is refused for hω > 2. Implicit methods have \
               no such limit.",
        head: &["method, system", "hω", "energy", "steps", "end"],
        part: Part::Pivot { row: 0, by: 1, cells: &["0.1", "1", "10", "1000"], value: 2, chosen: all },
        jobs,
    }
}
