//! How well do steps follow the periodic solution of a driven oscillator?
//!
//! The oscillator q'' + γ q' + q = β sin ωt has H = p²/2 + q²/2 − βq sin ωt + γs. One solution is periodic, and friction draws all others to
//! it. With little friction an error of the phase decays slowly.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::PI;

/// A mass on a spring with friction under a periodic force.
#[contact_hamiltonian]
fn driven(q: f64, p: f64, s: f64, t: f64, gamma: f64, beta: f64, omega: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 - beta * q * (omega * t).sin() + gamma * s
}

/// The periodic solution of a system at a time.
fn periodic(system: &Driven, t: f64) -> ContactState<f64> {
    let Driven { gamma, beta, omega } = *system;
    let amplitude = -beta / (gamma * omega).hypot(1.0 - omega * omega);
    let phase = omega * t + (gamma * omega).atan2(omega * omega - 1.0);
    ContactState::at(t, amplitude * phase.sin(), amplitude * omega * phase.cos(), 0.0)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Driven::REPORT);
    let (mut rows, mut orders) = (vec![], vec![]);
    for gamma in [0.01, 0.1, 1.0, 2.0] {
        let system = Driven { gamma, beta: 0.3, omega: PI / 3.0 };
        let off = |x: Vec<ContactState<f64>>| largest(x.iter().map(|x| x.q - periodic(&system, x.t).q));
        let second = |h| orbit(system, ContactSplitting, h, periodic(&system, 0.0), 50.0).map(off);
        let fourth = |h| orbit(system, Suzuki4.of(ContactSplitting), h, periodic(&system, 0.0), 50.0).map(off);
        let errors = [second(0.1)?, second(0.05)?, fourth(0.1)?, fourth(0.05)?];
        orders.push([order(errors[0], errors[1]), order(errors[2], errors[3])]);
        let [a, b, c, d] = errors.map(|x| format!("{x:.1e}"));
        rows.push([gamma.to_string(), a, b, c, d]);
    }
    println!("largest distance of q from the periodic solution, up to t = 50\n");
    println!("{}", table(["γ", "ContactSplitting, h = 0.1", "0.05", "Suzuki4 of it, h = 0.1", "0.05"], &rows));
    claim("orders are 2 and 4 although H depends on time", {
        orders.iter().all(|[two, four]| (two - 2.0).abs() < 0.05 && (four - 4.0).abs() < 0.05)
    })?;

    let system = Driven { gamma: 0.1, beta: 0.3, omega: PI / 3.0 };
    let [a, b] = [ContactState::new(3.0, 0.0, 0.0), ContactState::new(-1.0, -2.0, 0.0)];
    let far = orbit(system, ContactSplitting, 0.1, a, 150.0)?;
    let other = orbit(system, ContactSplitting, 0.1, b, 150.0)?;
    let apart = |x: &ContactState<f64>, y: &ContactState<f64>| (x.q - y.q).hypot(x.p - y.p);
    let decay = far.iter().zip(&other).map(|(x, y)| (x.t, apart(x, y)));
    let law = (0..=150).map(|t| (f64::from(t), apart(&a, &b) * (-0.05 * f64::from(t)).exp()));
    let phase = |x: &[ContactState<f64>]| x.iter().map(|x| (x.q, x.p)).collect::<Vec<_>>();
    let cycle: Vec<_> = (0..=120).map(|n| periodic(&system, 0.05 * f64::from(n))).collect();
    let orbits = vec![
        Curve::line("from (3, 0)", palette::VERMILION, phase(&far)).width(0.7).solid(),
        Curve::line("from (−1, −2)", palette::BLUE, phase(&other)).width(0.9),
        Curve::line("periodic solution", palette::BLACK, phase(&cycle)).width(2.6),
    ];
    let distance = vec![
        Curve::line("e^(−γt/2)", palette::GREY, law.collect()).width(5.0),
        Curve::line("ContactSplitting", palette::BLUE, decay.collect()),
    ];
    let orbits = Panel::new(
        "Two orbits and the periodic solution",
        "ContactSplitting, h = 0.1, up to t = 150; γ = 0.1, β = 0.3, ω = π/3; dimensionless",
        [Axis::linear("q", -3.2..3.2), Axis::linear("p", -3.2..3.2)],
        orbits,
    );
    let distance = Panel::new(
        "Two orbits approach each other",
        "distance in (q, p); ContactSplitting, h = 0.1; γ = 0.1, β = 0.3, ω = π/3; dimensionless",
        [Axis::linear("time", 0.0..150.0), Axis::decades("distance", -3.0..1.0)],
        distance,
    );
    figure("driven_oscillator.svg", (5, 4), &[orbits.equal(), distance])?;
    let last = far.iter().zip(&other).next_back().map_or(f64::NAN, |(x, y)| apart(x, y));
    let rate = (apart(&a, &b) / last).ln() / 150.0;
    claim(&format!("orbits approach each other like e^(−γt/2): rate {rate:.4}"), (rate - 0.05).abs() < 0.005)
}
