//! How many pieces does the splitting of an oscillator with friction need? One, with rounding errors only at any step size.
//!
//! The oscillator q'' + γ q' + q = 0 has H = p²/2 + q²/2 + γs. The macro finds that the whole H has a flow in closed form. The splitting into
//! motion, force and friction, as in A. Bravetti et al., Celest. Mech. Dyn. Astr. 132 (2020) 7, has order 2.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, table};
use geoint_runtime::prelude::*;
use std::error::Error;

/// A mass on a spring with friction; q and p in units in which both are 1.
#[contact_hamiltonian]
fn damped(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

/// The damped oscillator, split by hand into motion, friction and force.
#[contact_hamiltonian(split = "p * p / 2.0 | gamma * s | q * q / 2.0")]
fn three_pieces(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

const START: [f64; 2] = [-0.25, 0.75];
const FRICTION: [f64; 4] = [0.01, 0.1, 1.0, 2.0];

/// Returns the exact q from [`START`]. At γ = 2 both roots of λ² + γλ + 1 are −1, so the sine becomes t.
fn exact(gamma: f64, t: f64) -> f64 {
    let [q, p] = START;
    let rate = p + gamma * q / 2.0;
    let omega = (1.0 - gamma * gamma / 4.0).sqrt();
    let sine = if omega == 0.0 { t } else { (omega * t).sin() / omega };
    (-gamma * t / 2.0).exp() * (q * (omega * t).cos() + rate * sine)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Damped::REPORT);
    let duration = |gamma: f64| if gamma > 0.5 { 15.0 } else { 50.0 };
    let start = ContactState::new(START[0], START[1], 0.0);
    let error = |states: Vec<ContactState<f64>>, gamma| largest(states.iter().map(|x| x.q - exact(gamma, x.t)));

    let (mut rows, mut one_piece, mut halved) = (vec![], vec![], vec![]);
    for gamma in FRICTION {
        let one = |h| orbit(Damped { gamma }, ContactSplitting, h, start, duration(gamma)).map(|x| error(x, gamma));
        let three =
            |h| orbit(ThreePieces { gamma }, ContactSplitting, h, start, duration(gamma)).map(|x| error(x, gamma));
        let numbers = [one(1.0)?, one(0.1)?, three(0.1)?, three(0.05)?];
        one_piece.extend([numbers[0], numbers[1]]);
        halved.push(numbers[2] / numbers[3]);
        let [a, b, c, d] = numbers.map(|x| format!("{x:.1e}"));
        rows.push([gamma.to_string(), a, b, c, d]);
    }
    println!("largest error of q, up to t = 50, or 15 for γ ≥ 1\n");
    println!("{}", table(["γ", "one piece, h = 1", "0.1", "three pieces, h = 0.1", "0.05"], &rows));
    claim("one piece errs by rounding, at both steps", one_piece.iter().all(|error| *error < 2e-14))?;
    claim("three pieces are of order 2", halved.iter().all(|ratio| (ratio - 4.0).abs() < 0.1))?;

    let gamma = 0.1;
    let errors = |name, colour, states: Vec<ContactState<f64>>| {
        let points = states.iter().skip(1).map(|x| (x.t, (x.q - exact(gamma, x.t)).abs()));
        Curve::line(name, colour, points.collect())
    };
    let positions = |name, colour, states: Vec<ContactState<f64>>| {
        Curve::dots(name, colour, states.iter().map(|x| (x.t, x.q)).collect())
    };
    let truth = (0..=500).map(|n| (0.1 * f64::from(n), exact(gamma, 0.1 * f64::from(n)))).collect();
    let one = |h| orbit(Damped { gamma }, ContactSplitting, h, start, 50.0);
    let three = |h| orbit(ThreePieces { gamma }, ContactSplitting, h, start, 50.0);
    let motion = vec![
        Curve::line("exact", palette::GREY, truth).width(1.4),
        positions("one piece", palette::BLUE, one(1.0)?),
        positions("three pieces", palette::VERMILION, three(1.0)?),
    ];
    let accuracy = vec![
        errors("three pieces", palette::VERMILION, three(0.1)?).solid().width(1.2),
        errors("one piece", palette::BLUE, one(0.1)?).width(0.8).rounding(),
    ];
    let motion = Panel::new(
        "Oscillator with friction, steps of 1",
        "q'' + γq' + q = 0, γ = 0.1, dimensionless; ContactSplitting",
        [Axis::linear("time", 0.0..50.0), Axis::linear("q", -0.8..0.8)],
        motion,
    );
    let accuracy = Panel::new(
        "Oscillator with friction: error of q",
        "q'' + γq' + q = 0, γ = 0.1, dimensionless; ContactSplitting, h = 0.1",
        [Axis::linear("time", 0.0..50.0), Axis::decades("|error of q|", -18.0..0.0)],
        accuracy,
    );
    figure("damped_oscillator.svg", (3, 2), &[motion, accuracy])
}
