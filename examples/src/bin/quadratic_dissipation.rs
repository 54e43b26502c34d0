//! Does friction that grows with the action cost more than constant friction?
//!
//! H = p²/2 + q²/2 + a s²/2 gives p' = −q − a s p. This term drives the oscillator while s < 0, and damps it afterwards. The variational scheme
//! is implicit (M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206). The flows of both parts are known, so a splitting is
//! explicit: a rotation and a quotient. The quotient has a pole if a step is too long; then the step is refused.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// An oscillator with friction a·s.
#[contact_hamiltonian]
fn quadratic(q: f64, p: f64, s: f64, a: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + a * s * s / 2.0
}

const START: ContactState<f64> = ContactState { t: 0.0, q: 0.5, p: 0.5, s: -0.2 };

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Quadratic::REPORT);
    let (mut rows, mut orders) = (vec![], vec![]);
    for a in [0.1, 0.5, 1.0, 1.5] {
        let system = Quadratic { a };
        let truth = orbit(system, BlanesMoan6X, 0.05, START, 50.0)?;
        let off = |stride: usize, states: &[ContactState<f64>]| {
            let pairs = states.iter().zip(truth.iter().step_by(stride));
            largest(pairs.flat_map(|(x, y)| [x.q - y.q, x.p - y.p, x.s - y.s]))
        };
        let two = |h, stride| orbit(system, ContactSplitting, h, START, 50.0).map(|x| off(stride, &x));
        let four = |h, stride| orbit(system, BlanesMoan4X, h, START, 50.0).map(|x| off(stride, &x));
        let errors = [two(0.2, 4)?, two(0.1, 2)?, four(0.2, 4)?, four(0.1, 2)?];
        orders.push([order(errors[0], errors[1]), order(errors[2], errors[3])]);
        let [b, c, d, e] = errors.map(|x| format!("{x:.1e}"));
        rows.push([a.to_string(), b, c, d, e]);
    }
    println!("largest error of (q, p, s), up to t = 50\n");
    println!("{}", table(["a", "ContactSplitting, h = 0.2", "0.1", "BlanesMoan4X, h = 0.2", "0.1"], &rows));
    claim("orders are 2 and 4 for a = 0.1", (orders[0][0] - 2.0).abs() < 0.1 && (orders[0][1] - 4.0).abs() < 0.2)?;

    // The flow of s' = −a s²/2 has a pole after 2/(a|s|) = 0.1.
    let mut sim = Quadratic { a: 1.0 }.integrator(ContactSplitting, 0.2, ContactState::new(0.5, 0.5, -20.0));
    let refused = sim.step();
    claim(
        "a step over the pole of its quotient is refused",
        matches!(refused, Err(StepError { failure: Failure::Pole { .. }, .. })),
    )?;
    println!("  {}", refused.err().map_or_else(String::new, |error| error.to_string()));

    let colours = [(0.1, palette::BLUE), (0.5, palette::GREEN), (1.0, palette::VERMILION)];
    let (mut paths, mut actions) = (vec![], vec![]);
    for (a, colour) in colours {
        let states = orbit(Quadratic { a }, ContactSplitting, 0.05, START, 50.0)?;
        let name = format!("a = {a}");
        paths.push(Curve::line(&name, colour, states.iter().map(|x| (x.q, x.p)).collect()).width(1.2));
        actions.push(Curve::line(&name, colour, states.iter().map(|x| (x.t, x.s)).collect()));
    }
    let note = "ContactSplitting, h = 0.05, from (q, p, s) = (0.5, 0.5, −0.2) up to t = 50; dimensionless";
    let axes = [Axis::linear("q", -3.0..3.0), Axis::linear("p", -5.0..4.0)];
    let paths = Panel::new("Driven while s < 0, damped afterwards", note, axes, paths);
    let axes = [Axis::linear("time", 0.0..50.0), Axis::linear("action s", -2.4..2.6)];
    let actions = Panel::new("The action turns the friction on", note, axes, actions);
    figure("quadratic_dissipation.svg", (4, 3), &[paths, actions])
}
