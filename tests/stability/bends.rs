//! Energies with bends: discrete gradients keep them in long runs, or refuse a step.
//!
//! A run extrapolates its steps. When two bodies pass each other, the extrapolated increment lies on the wrong side of a bend.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::Noise;

/// Three sheets that attract each other: gravity on a line.
#[hamiltonian]
fn sheets(q: [f64; 3], p: [f64; 3], m: [f64; 3]) -> f64 {
    let mut h = (q[0] - q[1]).abs() + (q[1] - q[2]).abs() + (q[0] - q[2]).abs();
    for i in 0..3 {
        h += p[i] * p[i] / (2.0 * m[i]);
    }
    h
}

/// Two bodies that attract each other and the origin.
#[hamiltonian]
fn two_and_the_origin(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    p[0] * p[0] / (2.0 * m) + p[1] * p[1] / 2.0 + q[0].abs() + q[1].abs() + (q[0] - q[1]).abs()
}

/// Walls that `max` and `min` make.
#[hamiltonian]
fn wedge(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    p[0] * p[0] / (2.0 * m) + p[1] * p[1] / 2.0 + q[0].max(q[1]) - q[0].min(-2.0 * q[1])
        + (q[0] * q[0] + q[1] * q[1]) / 8.0
}

/// A bend in the momentum as well.
#[hamiltonian]
fn diamond(q: f64, p: f64, a: f64) -> f64 {
    a * p.abs() + q.abs()
}

/// The same forces from a Lagrangian.
#[lagrangian]
fn two_by_velocities(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
    m * v[0] * v[0] / 2.0 + v[1] * v[1] - (q[0] - q[1]).abs() - q[0].abs()
}

/// A field on the edges of a square.
#[vector_field(keeps(size = x[0].abs() + x[1].abs()))]
fn edges_of_a_square(x: [f64; 2]) -> [f64; 2] {
    [x[1].signum(), -x[0].signum()]
}

/// Steps of each run, and random starts.
const STEPS: u64 = if cfg!(debug_assertions) { 600 } else { 10_000 };
const STARTS: usize = if cfg!(debug_assertions) { 10 } else { 100 };

/// Returns the largest relative change of `value` in runs of `STEPS` steps, up to the first refusal, and the share of steps taken.
macro_rules! change {
    ($system:expr, $method:expr, $h:expr, |$noise:ident| $start:expr, |$run:ident| $value:expr) => {{
        let mut $noise = Noise::new(11);
        let (mut worst, mut taken) = (0.0_f64, 0);
        for _ in 0..STARTS {
            let mut $run = $system.integrator($method, $h, $start);
            let before: f64 = $value;
            for _ in 0..STEPS {
                if $run.step().is_err() {
                    break;
                }
                taken += 1;
                worst = worst.max((($value - before) / before).abs());
            }
        }
        (worst, taken as f64 / (STARTS as u64 * STEPS) as f64)
    }};
}

fn array<const N: usize>(noise: &mut Noise) -> [f64; N] {
    core::array::from_fn(|_| 2.0 * noise.next().expect("noise is endless"))
}

/// Asserts that discrete gradients and their compositions take most steps of a system and keep the value.
macro_rules! keeps {
    ($system:expr, |$noise:ident| $start:expr, |$run:ident| $value:expr) => {
        keeps!(@ $system, |$noise| $start, |$run| $value, DiscreteGradient, Suzuki4.of(DiscreteGradient));
    };
    (@ $system:expr, |$noise:ident| $start:expr, |$run:ident| $value:expr, $($method:expr),*) => { $(
        for h in [0.05, 0.3] {
            let (worst, taken) = change!($system, $method, h, |$noise| $start, |$run| $value);
            assert!(worst < 1e-12 && taken > 0.5, "{} {} {h}: {worst:.1e}, {taken}", stringify!($system), stringify!($method));
        }
    )* };
}

#[test]
fn discrete_gradients_keep_energies_with_bends() {
    keeps!(Sheets { m: [1.0, 1.7, 0.6] }, |noise| State::new(array(&mut noise), [0.0; 3]), |run| run.energy());
    keeps!(TwoAndTheOrigin { m: 1.7 }, |noise| State::new(array(&mut noise), array(&mut noise)), |run| run.energy());
    keeps!(Wedge { m: 0.6 }, |noise| State::new(array(&mut noise), array(&mut noise)), |run| run.energy());
    keeps!(Diamond { a: 0.7 }, |noise| State::new(array::<1>(&mut noise)[0], array::<1>(&mut noise)[0]), |run| run
        .energy());
    let system = TwoByVelocities { m: 0.8 };
    keeps!(system, |noise| system.at(array(&mut noise), array(&mut noise)), |run| run.energy());
    keeps!(EdgesOfASquare {}, |noise| FlowState::new(array(&mut noise)), |run| run.integrals()[0]);
}

/// Other means of gradients refuse more steps, but every accepted step keeps the energy.
#[test]
fn no_mean_of_gradients_loses_the_energy_at_a_bend() {
    macro_rules! rows {
        ($($method:expr),*) => { $(
            let start = |noise: &mut Noise| State::new(array(noise), [0.0; 3]);
            let (worst, taken) = change!(Sheets { m: [1.0, 1.7, 0.6] }, $method, 0.3, |noise| start(&mut noise), |run| run.energy());
            assert!(worst < 1e-11 && taken > 0.0, "{}: {worst:.1e}, {taken}", stringify!($method));
        )* };
    }
    rows!(FourthOrder(DiscreteGradient), Gonzalez, SymmetrisedItohAbe, ItohAbe, FourthOrder(Gonzalez));
}

/// Control: a method without a discrete gradient exceeds the bound.
#[test]
fn the_midpoint_loses_the_energy_at_a_bend() {
    let start = |noise: &mut Noise| State::new(array(noise), array(noise));
    let (worst, _) =
        change!(TwoAndTheOrigin { m: 1.7 }, ImplicitMidpoint, 0.3, |noise| start(&mut noise), |run| run.energy());
    assert!(worst > 1e-3, "{worst:.1e}");
}

/// Kinks of positions and momenta: a correction must not lead a projected series back over the kink at which its step ends.
#[hamiltonian]
fn both_bent(q: f64, p: f64) -> f64 {
    p.abs() + p * p / 4.0 + q.abs() + q * q / 4.0
}

/// Regression test: one run of 300 had an error above 10⁻⁶, because each longer attempt added a new correction that led back over the kink.
#[test]
fn projected_series_pass_bends_in_time() {
    let mut noise = Noise::new(1);
    let mut worst = 0.0_f64;
    for _ in 0..1000 {
        let [q, p] = [1.5, 1.0].map(|size| size * noise.next().unwrap());
        let start = State::new(q, p);
        for tolerance in [1e-8, 1e-13] {
            let mut plain = BothBent.taylor(Taylor { tolerance }, start);
            let mut projected = BothBent.taylor(Projection(Taylor { tolerance }, Energy), start);
            plain.advance_to(8.0).unwrap();
            projected.advance_to(8.0).unwrap();
            let (a, b) = (plain.state(), projected.state());
            worst = worst.max((a.q - b.q).abs()).max((a.p - b.p).abs());
        }
    }
    assert!(worst <= 1e-9, "{worst:.1e}");
}
