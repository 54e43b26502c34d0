//! How well do steps keep the total energy if friction heats a bath?
//!
//! A pendulum with friction heats a bath of heat capacity C: x = (angle, v, heat), v' = −sin q − γv, heat' = γv². The GENERIC form
//! (M. Grmela & H. C. Öttinger, Phys. Rev. E 56 (1997) 6620) is x' = L∇E + M∇S with E = v²/2 − cos q + heat and S = C ln heat. The option `lift`
//! with H = p·x' gives two pieces: {q' = v, heat' = γv²} and {v' = −sin q − γv}. The first piece adds a square to the heat, so entropy grows in
//! every step with positive weights. The error of the total energy has the order of the method.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::prelude::*;
use std::error::Error;

/// x is (angle, v, heat).
#[contact_hamiltonian(lift, q = x)]
fn pendulum(x: [f64; 3], p: [f64; 3], s: f64, gamma: f64) -> f64 {
    let friction = gamma * x[1];
    p[0] * x[1] - p[1] * (x[0].sin() + friction) + p[2] * friction * x[1] + 0.0 * s
}

type Bath = ContactState<[f64; 3]>;

const SYSTEM: Pendulum = Pendulum { gamma: 0.1 };
const CAPACITY: f64 = 2.0;
const DURATION: f64 = 80.0;

fn total(x: &Bath) -> f64 {
    let [q, v, heat] = x.q;
    v * v / 2.0 + 1.0 - q.cos() + heat
}

fn entropy(x: &Bath) -> f64 {
    CAPACITY * x.q[2].ln()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Pendulum::REPORT);
    let start = ContactState::new([2.8, 0.0, 1.0], [0.0; 3], 0.0);
    let drift = |states: &[Bath]| largest(states.iter().map(|x| total(x) - total(&start)));
    let falls = |states: &[Bath]| states.windows(2).filter(|x| entropy(&x[1]) < entropy(&x[0])).count();
    let (mut rows, mut errors, mut fallen) = (vec![], vec![], [0, 0]);
    for h in [0.4, 0.2, 0.1, 0.05] {
        let two = orbit(SYSTEM, ContactSplitting, h, start, DURATION)?;
        let four = orbit(SYSTEM, Suzuki4.of(ContactSplitting), h, start, DURATION)?;
        errors.push([drift(&two), drift(&four)]);
        fallen = [fallen[0] + falls(&two), fallen[1] + falls(&four)];
        let [a, b] = [&two, &four].map(|x| format!("{:.1e}", drift(x)));
        rows.push([h.to_string(), a, falls(&two).to_string(), b, falls(&four).to_string()]);
    }
    println!("largest error of the total energy up to t = {DURATION}, and steps in which entropy falls\n");
    println!("{}", table(["h", "ContactSplitting", "falls", "Suzuki4 of it", "falls"], &rows));
    claim("with ContactSplitting entropy falls in no step", fallen[0] == 0)?;
    let [two, four] = [0, 1].map(|i| order(errors[2][i], errors[3][i]));
    claim(&format!("total energy is kept to orders 2 and 4 (observed {two:.2}, {four:.2})"), {
        (two - 2.0).abs() < 0.1 && (four - 4.0).abs() < 0.1
    })?;
    let states = orbit(SYSTEM, ContactSplitting, 0.1, start, 200.0)?;
    let end = states[states.len() - 1];
    claim("in the end the pendulum hangs still, and all energy is heat", {
        end.q[1].abs() < 1e-3 && (end.q[2] - total(&start)).abs() < 1e-2
    })?;

    let curve = |name: &str, colour, of: &dyn Fn(&Bath) -> f64| {
        let points = states.iter().take_while(|x| x.t <= DURATION).map(|x| (x.t, of(x)));
        Curve::line(name, colour, points.collect())
    };
    let energies = vec![
        curve("total energy", palette::BLACK, &total),
        curve("heat", palette::VERMILION, &|x| x.q[2]),
        curve("energy of the pendulum", palette::BLUE, &|x| total(x) - x.q[2]),
        curve("entropy", palette::GREEN, &entropy),
    ];
    let mut drifts = vec![];
    for (h, colour) in [(0.2, palette::VERMILION), (0.1, palette::GREEN), (0.05, palette::BLUE)] {
        let states = orbit(SYSTEM, ContactSplitting, h, start, DURATION)?;
        let points = states.iter().skip(1).map(|x| (x.t, (total(x) - total(&start)).abs()));
        drifts.push(Curve::line(format!("h = {h}"), colour, points.collect()).width(1.0).solid());
    }
    let energies = Panel::new(
        "Friction turns energy into heat",
        "ContactSplitting, h = 0.1; γ = 0.1, heat capacity 2; unit mass, length, gravity and temperature",
        [Axis::linear("time", 0.0..DURATION), Axis::linear("energies, entropy", 0.0..3.2)],
        energies,
    );
    let drifts = Panel::new(
        "Error of the total energy",
        "ContactSplitting; γ = 0.1, heat capacity 2; half the step has a quarter of the error",
        [Axis::linear("time", 0.0..DURATION), Axis::decades("|error|", -7.0..-1.0)],
        drifts,
    );
    figure("heat_bath.svg", (3, 2), &[energies, drifts])
}
