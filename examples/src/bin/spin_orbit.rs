//! Which rotations of a satellite are stable, and in which one does friction end?
//!
//! The satellite moves on an ellipse, and its moment of inertia C = 1 + λ cos Ωt changes: d(C q')/dt is the torque of the central body. The
//! torque is a Fourier series in 2q − kt with coefficients that depend on the eccentricity (A. Cayley 1861), as in A. Bravetti et al., Celest.
//! Mech. Dyn. Astr. 132 (2020) 7. With C'/C as friction it is a contact system. Sections are at t = 2πk.

use geoint_examples::claim;
use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_runtime::StepError;
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::PI;

/// The angle q of a satellite under the torques of k = −5, …, 9; `tide` is friction and a constant torque, `inertia` λ and Ω.
#[contact_hamiltonian]
fn satellite(q: f64, p: f64, s: f64, t: f64, tide: [f64; 2], inertia: [f64; 2], torque: [f64; 15]) -> f64 {
    let [lambda, omega] = inertia;
    let inertia = 1.0 + lambda * (omega * t).cos();
    let change = -lambda * omega * (omega * t).sin() / inertia;
    let potential = (0..15).map(|i| torque[i] * (2.0 * q - (i as f64 - 5.0) * t).cos()).sum::<f64>();
    p * p / 2.0 + (tide[0] + change) * s - potential / (2.0 * inertia) - tide[1] * q
}

/// Computes the coefficients of (a/r)³ cos(2f − 2q) = Σ cₖ cos(2q − kt) for k = −5, …, 9. They are mean values over an orbit. The
/// trapezoidal rule in the eccentric anomaly u is exact to rounding; the true anomaly f and the time t are functions of u.
fn coefficients(e: f64) -> [f64; 15] {
    std::array::from_fn(|i| {
        let mean = (0..64).map(|j| {
            let u = 2.0 * PI * f64::from(j) / 64.0;
            let r = 1.0 - e * u.cos();
            let f = 2.0 * ((1.0 + e).sqrt() * (u / 2.0).sin()).atan2((1.0 - e).sqrt() * (u / 2.0).cos());
            (2.0 * f - (i as f64 - 5.0) * (u - e * u.sin())).cos() / (r * r)
        });
        mean.sum::<f64>() / 64.0
    })
}

/// Returns (q modulo π, q') at the first `n` sections, with 20 steps from section to section.
fn sections(system: Satellite, q: f64, p: f64, n: usize) -> Result<Vec<(f64, f64)>, StepError> {
    let mut sim = system.integrator(ContactSplitting, PI / 10.0, ContactState::new(q, p, 0.0));
    sim.sampled(20).take(n).map(|x| x.map(|x| ((x.q + PI / 2.0).rem_euclid(PI) - PI / 2.0, x.p))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Satellite::REPORT);
    println!("k    coefficient at eccentricity 0.01, its leading term");
    let (e, c) = (0.01_f64, coefficients(0.01));
    let leading =
        [(1, -e / 2.0), (2, 1.0 - 2.5 * e * e), (3, 3.5 * e), (4, 8.5 * e * e), (5, 845.0 / 48.0 * e.powi(3))];
    for (k, leading) in leading {
        println!("{k}    {:.8}, {leading:.8}", c[k + 5]);
    }
    println!();
    claim("leading terms are right to a fraction of 3 e²", {
        leading.iter().all(|(k, leading)| (c[k + 5] / leading - 1.0).abs() < 3.0 * e * e)
    })?;

    let resonant = Satellite { tide: [0.0; 2], inertia: [0.01, 1.0], torque: c.map(|c| 0.0075 * c) };
    let mut portrait = vec![];
    let starts = [
        (1.135, "rotation", palette::BLUE),
        (0.845, "", palette::BLUE),
        (1.1106, "beside the separatrix", palette::VERMILION),
        (0.86838, "", palette::VERMILION),
        (0.98, "libration from q' = 0.98", palette::GREEN),
        (0.93, "0.93", palette::ORANGE),
        (0.9, "0.9", palette::BLACK),
        (0.878, "0.878", palette::PURPLE),
    ];
    for (p, name, colour) in starts {
        portrait.push(Curve::dots(name, colour, sections(resonant, 0.0, p, 600)?).marked(0.9).rounding());
    }
    let locked = sections(resonant, 0.0, 0.98, 600)?;
    let rotating = sections(resonant, 0.0, 1.135, 600)?;
    claim("from (0, 0.98) the satellite librates about 1:1", locked.iter().all(|x| x.1 > 0.9 && x.1 < 1.1))?;
    let turns = rotating.iter().any(|x| x.0.abs() > 1.47);
    claim("from (0, 1.135) it turns past the resonance", turns && locked.iter().all(|x| x.0.abs() < 1.47))?;

    let mut chaos = vec![];
    for (lambda, colour) in [(0.2, palette::BLUE), (0.01, palette::VERMILION)] {
        let torque = coefficients(0.06).map(|c| 0.045 * c);
        let system = Satellite { tide: [0.0; 2], inertia: [lambda, 2.0_f64.sqrt()], torque };
        let points = sections(system, PI, 1.0, 3000)?;
        let (low, high) = points.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x.1), high.max(x.1)));
        claim(&format!("Ω = √2, λ = {lambda}: q' stays between {low:.2} and {high:.2}"), low > 0.0 && high < 2.5)?;
        chaos.push(Curve::dots(format!("λ = {lambda}"), colour, points).marked(0.8).rounding());
    }

    let captured = Satellite { tide: [1e-3; 2], inertia: [1e-4, 1.0], torque: c.map(|c| 0.0075 * c) };
    let capture = sections(captured, 2.7, 3.0, 1591)?;
    let last = &capture[capture.len() - 500..];
    let mean = last.iter().map(|x| x.1).sum::<f64>() / 500.0;
    claim(&format!("friction ends in 1:1: the mean of the last 500 q' is {mean:.4}"), (mean - 1.0).abs() < 0.005)?;
    let spin = capture.iter().zip(1..).map(|(x, n)| (f64::from(n) / 1000.0, x.1)).collect();
    let spin = vec![Curve::dots("at the pericentre", palette::BLUE, spin).marked(0.9).rounding()];

    let angle = || Axis::linear("q modulo π (rad)", -PI / 2.0..PI / 2.0);
    let rate = |range| Axis::linear("q' (mean motions of the orbit)", range);
    figure(
        "spin_orbit.svg",
        (4, 3),
        &[
            Panel::new(
                "Satellite in resonance: Ω = 1, λ = 0.01",
                "sections at the pericentre from q = 0; ContactSplitting, h = 2π/20",
                [angle(), rate(0.8..1.2)],
                portrait,
            ),
            Panel::new(
                "Satellite without resonance: Ω = √2",
                "sections at the pericentre from (π, 1); ContactSplitting, h = 2π/20",
                [angle(), rate(0.0..2.5)],
                chaos,
            ),
            Panel::new(
                "Friction captures a satellite in 1:1",
                "from (2.7, 3), with tidal friction 10⁻³; ContactSplitting, h = 2π/20",
                [Axis::linear("orbits (thousands)", 0.0..1.6), rate(0.8..3.0)],
                spin,
            ),
        ],
    )
}
