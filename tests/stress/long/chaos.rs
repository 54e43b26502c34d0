//! Chaotic motion over a million units of time.

use super::{Job, Section, row, short};
use crate::run::{Outcome, adapting, fixed};
use geoint_runtime::TaylorIntegrator;
use geoint_runtime::prelude::*;
use geoint_tests::problems::{DoublePendulum, HenonHeiles};

const END: f64 = 1e6;
const LOOKS: u32 = 1000;
/// Errors of the energy with which an orbit may leave.
const MAY_LEAVE: f64 = 1e-4;
const TITLES: &[&str] = &["method", "h", "energy", "steps", "end"];

fn told<S>(name: &str, h: f64, outcome: &Outcome<S>, scale: f64, bound: f64) -> super::Row {
    let energy = outcome.energy / scale;
    let h = if h > 0.0 { h.to_string() } else { "its own".into() };
    let cells = vec![name.into(), h, short(energy), outcome.steps.to_string(), outcome.end()];
    // An orbit above the energy of the way out, by the error of its steps, leaves.
    let left = bound == MAY_LEAVE && outcome.refused.is_some();
    row(cells, left || energy <= bound && outcome.refused.is_none())
}

macro_rules! rows {
    ($jobs:ident, $system:expr, $start:expr, $scale:expr; $($h:literal, $bound:literal: $method:expr),* $(,)?) => {
        $( $jobs.push(Box::new(|| {
            let run = $system.integrator($method, $h, $start);
            told(stringify!($method), $h, &fixed(run, (END / $h) as u64, LOOKS, |_| ()), $scale, $bound)
        })); )*
        $jobs.push(Box::new(|| {
            let run = TaylorIntegrator::new($system, Taylor::default(), $start);
            told("Taylor", 0.0, &adapting(run, END, LOOKS, |_| ()), $scale, 1e-11)
        }));
    };
}

const ESCAPE: f64 = 1.0 / 6.0;

fn at_the_edge() -> State<[f64; 2]> {
    let (y, p): (f64, f64) = (-0.15, 0.1);
    let potential = y * y / 2.0 - y * y * y / 3.0;
    State::new([0.0, y], [(2.0 * (ESCAPE - potential) - p * p).sqrt(), p])
}

/// At the energy from which on orbits may escape.
pub(super) fn galaxy() -> Section {
    const SYSTEM: HenonHeiles = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };
    let mut jobs: Vec<Job> = vec![];
    rows! { jobs, SYSTEM, at_the_edge(), ESCAPE;
        0.01, 1e-4: StormerVerlet, 0.1, 1e-5: BlanesMoan4, 0.1, 1e-11: BlanesMoanSrkn14a, 0.1, 1e-7: Gauss::<3>, 0.1, 1e-11: DiscreteGradient,
        0.1, 1e-11: FourthOrder(DiscreteGradient), 0.1, 1e-11: Projection(RK4, Energy),
    }
    Section {
        title: "Chaos: Hénon–Heiles",
        text: "E = 1/6, where the way out opens, over 10⁶ units of time: the largest relative error of the energy at a thousand times. Only orbits whose error \
               lifts them above it, by Verlet's method, leave.",
        head: TITLES,
        jobs,
    }
}

/// A double pendulum that turns over.
pub(super) fn double_pendulum() -> Section {
    const SYSTEM: DoublePendulum = DoublePendulum { m1: 1.3, m2: 0.7, l1: 1.0, l2: 0.8, g: 9.81 };
    const SCALE: f64 = 30.0;
    let mut jobs: Vec<Job> = vec![];
    rows! { jobs, SYSTEM, State::new([2.5, 3.0], [3.0, 1.0]), SCALE;
        0.005, 1e-2: ImplicitMidpoint, 0.01, 1e-5: Gauss::<3>, 0.01, 1e-11: DiscreteGradient, 0.01, 1e-11: FourthOrder(DiscreteGradient),
    }
    Section {
        title: "Chaos: double pendulum",
        text: "Masses 1.3 and 0.7 that turn over, over 10⁶ units of time: the largest error of the energy at a thousand times, over 30, about its two \
               parts.",
        head: TITLES,
        jobs,
    }
}
