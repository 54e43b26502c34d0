//! A short version of each section, in every run of the tests.

use crate::rounding::walks;
use crate::run::{adapting, fixed};
use crate::systems::{MASS, comet, spring};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Integrator, Method, TaylorIntegrator};
use geoint_tests::problems::{Pendulum, Problem};
use geoint_tests::scalars::{Tallied, Tally};

/// Rounding errors grow at most like a random walk, so after 10⁴ steps they are far below N ε. With removal of drift they do not grow.
#[test]
fn rounding_does_not_grow_like_the_number_of_steps() {
    for walk in walks() {
        // Plain sums may have a bias.
        for (sums, growth, most) in [("plain", walk.plain, 100.0), ("compensated", walk.compensated, 10.0)] {
            let points = growth((4, 1), 4);
            let (steps, error) = points[points.len() - 1];
            let most = if walk.settled { 10.0 } else { most * steps.sqrt() };
            assert!(error <= most * f64::EPSILON, "{}, {sums}: {error:.1e} after {steps:.0}", walk.name);
        }
    }
}

/// A comet whose pericentre is at a hundredth of its semi-major axis.
#[test]
fn close_encounters() {
    let (system, start, period) = comet(0.99);
    let scale = system.mu / 2.0;
    let adaptive = adapting(system.adaptive(DOP853, 1e-12, start), 3.0 * period, 3, |_| ());
    assert!(adaptive.refused.is_none() && adaptive.energy <= 1e-10 * scale, "{:.1e}", adaptive.energy);
    let series = adapting(TaylorIntegrator::new(system, Taylor::default(), start), 3.0 * period, 3, |_| ());
    assert!(series.refused.is_none() && series.energy <= 1e-12 * scale, "{:.1e}", series.energy);
    // Control: steps far longer than the encounter.
    let coarse = fixed(system.integrator(StormerVerlet, period / 300.0, start), 900, 3, |_| ());
    assert!(coarse.energy > 1e-2 * scale, "{:.1e}", coarse.energy);
}

/// Fast vibrations with steps of 50 radians.
#[test]
fn stiff_springs() {
    let (system, start) = spring(1000.0);
    let outcome = fixed(system.integrator(DiscreteGradient, 0.05, start), 500, 10, |_| ());
    assert!(outcome.energy <= 1e-10, "{:.1e}, {}", outcome.energy, outcome.end());
}

/// The rounding of an angle of many turns exceeds the tolerance of a correction. This is no reason to refuse a step. The distances are irregular, because
/// the last digits of large coordinates come in patterns.
#[test]
fn angles_of_many_turns() {
    fn check<M: Method<Pendulum>>(name: &str, method: M) {
        let system = Pendulum { m: MASS, l: 1.0, g: 1.0 };
        let turns = |q: f64| std::f64::consts::TAU * (q / std::f64::consts::TAU).round();
        for (h, q, p) in [
            (0.2, turns(1e6) + 2.8, 0.3),
            (0.05, turns(1e7) + 0.8, 0.3),
            (0.025, 1e9 - 100.0, 3.0),
            (0.05, turns(1e10) + 0.8, 0.3),
        ] {
            let outcome = fixed(system.integrator(method, h, State::new(q, p)), 1000, 10, |_| ());
            assert!(outcome.refused.is_none(), "{name}, q = {q:e}: {} after {}", outcome.end(), outcome.steps);
            let law = if method.claims().conserves_energy { 0.0 } else { 2.0 * h * h };
            let bound = MASS * (law + q * f64::EPSILON * (outcome.steps as f64).sqrt());
            assert!(outcome.energy <= bound, "{name}, q = {q:e}: {:.1e}, at most {bound:.1e}", outcome.energy);
        }
    }
    check("ImplicitMidpoint", ImplicitMidpoint);
    check("Gauss 3", Gauss::<3>);
    check("DiscreteGradient", DiscreteGradient);
    check("FourthOrder", FourthOrder(DiscreteGradient));
    check("Projection", Projection(RK4, Energy));
}

/// If a gradient vanishes at the end of a step, the rounding of an angle appears at its start.
#[test]
fn angles_of_many_turns_where_forces_vanish() {
    let system = Pendulum { m: MASS, l: 1.0, g: 1.0 };
    let start = State::new(1e9 - 5e4, MASS * 2.5);
    let outcome = fixed(system.integrator(Projection(RK4, Energy), 0.025, start), 60_000, 10, |_| ());
    let bound = MASS * start.q * f64::EPSILON * (outcome.steps as f64).sqrt();
    assert!(outcome.refused.is_none(), "{} after {}", outcome.end(), outcome.steps);
    assert!(outcome.energy <= bound, "{:.1e}, at most {bound:.1e}", outcome.energy);
}

/// A step of `DOP853` takes twelve evaluations. Its own estimate of the error needs no further evaluation.
#[test]
fn estimates_cost_no_evaluations() {
    let start = State::new(Tallied::from(0.8), Tallied::from(0.1));
    let mut sim = Pendulum::system::<Tallied>().adaptive(DOP853, 1e-9, start);
    sim.advance(50).expect("steps");
    let before = sim.rejections();
    let Tally { functions, .. } = Tally::during(|| sim.advance(100).expect("steps"));
    // A few more evaluations occur when a step is longer than all earlier steps: they measure the propagation of errors between coordinates.
    let steps = 12 * (100 + sim.rejections() - before);
    assert!((steps..steps + 12).contains(&functions), "{functions}");
}

/// Compensation adds three operations for each coordinate to a plain sum in a step of Verlet's method.
#[test]
fn sums_of_kicks_and_drifts_take_four_operations() {
    fn arithmetic<C: geoint_runtime::space::Summation<[[Tallied; 1]; 2]>>(
        mut sim: Integrator<geoint_tests::problems::Pendulum<Tallied>, geoint_runtime::Splitting<1>, Tallied, C>,
    ) -> u64 {
        sim.advance(10).expect("steps");
        Tally::during(|| sim.advance(1000).expect("steps")).arithmetic
    }
    let run = || {
        let start = State::new(Tallied::from(0.8), Tallied::from(0.1));
        Pendulum::system::<Tallied>().integrator(StormerVerlet, Tallied::from(0.01), start)
    };
    let more = arithmetic(run().compensated()) - arithmetic(run());
    // A plain kick is a fused sum. If it stands alone, its product is an operation of its own. The last kick of a call is added twice: to the state, and to
    // the starting point of the next step.
    assert!(more <= 2 * 4 * 1002, "{more} in 1000 steps");
}
