//! How do three bodies at rest move apart? The Pythagorean problem, up to the ejection of one body.
//!
//! Masses 3, 4 and 5 rest in the corners of a triangle with sides 3, 4 and 5. They fall, and pass each other at distances down to 4·10⁻⁴. After
//! 60 units of time a binary leaves to one side and the lightest body to the other. The adaptive step changes by a factor of more than 1000.
//!
//! C. Burrau, Astron. Nachr. 195 (1913) 113; V. Szebehely & C. F. Peters, Astron. J. 72 (1967) 876.

use geoint_examples::claim;
use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_runtime::prelude::*;
use std::error::Error;

/// Bodies under their mutual gravity, G = 1.
#[hamiltonian]
fn three_bodies(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3]) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
            energy -= m[i] * m[j] / (x * x + y * y).sqrt();
        }
    }
    energy
}

const END: f64 = 70.0;

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn main() -> Result<(), Box<dyn Error>> {
    let system = ThreeBodies { m: [3.0, 4.0, 5.0] };
    let mut sim = system.taylor(Taylor::default(), State::new([[1.0, 3.0], [-2.0, -1.0], [1.0, -1.0]], [[0.0; 2]; 3]));
    let energy = sim.energy();
    let (mut paths, mut steps) = ([const { vec![] }; 3], vec![]);
    let (mut error, mut closest) = (0.0_f64, f64::INFINITY);
    while sim.step_towards(END)? {
        let State { t, q, .. } = sim.state();
        error = error.max((sim.energy() / energy - 1.0).abs());
        for i in 0..3 {
            closest = closest.min(distance(q[i], q[(i + 1) % 3]));
            paths[i].push((q[i][0], q[i][1]));
        }
        steps.push((t, sim.last_step()));
    }
    let State { q, .. } = sim.state();
    let (binary, far) = (distance(q[1], q[2]), distance(q[0], q[1]));
    let lengths = steps.iter().map(|(_, h)| *h);
    let (shortest, longest) = (lengths.clone().fold(f64::INFINITY, f64::min), lengths.fold(0.0, f64::max));
    println!(
        "{} steps of {shortest:.1e} to {longest:.1e}; closest approach of the ends of steps {closest:.1e}",
        sim.steps()
    );
    println!(
        "at t = {END}: the heavy two are {binary:.2} apart, the light one is {far:.1} away; energy error {error:.1e}\n"
    );
    claim("two bodies come as close as 10⁻³", closest < 1e-3)?;
    // Positions near 1 have rounding errors of 10⁻¹⁶. Their difference of 4·10⁻⁴ therefore has a relative error of 10⁻¹².
    claim("the energy is kept to 10⁻⁸ through all encounters", error < 1e-8)?;
    claim("steps differ by a factor of 1000", longest > 1000.0 * shortest)?;
    claim("the lightest body leaves a binary", far > 10.0 * binary)?;
    let near = |path: &[(f64, f64)]| path.iter().copied().filter(|(x, y)| x.abs() < 6.0 && y.abs() < 6.0).collect();
    let curves = [("m = 3", palette::BLUE), ("m = 4", palette::VERMILION), ("m = 5", palette::GREEN)];
    let curves = curves.into_iter().zip(&paths).map(|((name, colour), path)| Curve::line(name, colour, near(path)));
    let panels = [
        Panel::new(
            "Three bodies that start at rest",
            "Taylor series to rounding; G = 1, dimensionless",
            [Axis::linear("x", -6.0..6.0), Axis::linear("y", -6.0..6.0)],
            curves.collect(),
        )
        .equal(),
        Panel::new(
            "Step size through close encounters",
            "Taylor series to rounding; G = 1, dimensionless",
            [Axis::linear("time", 0.0..END), Axis::decades("step", -6.0..1.0)],
            vec![Curve::line("step", palette::BLACK, steps).solid().width(1.0)],
        ),
    ];
    figure("close_encounter.svg", (5, 4), &panels)
}
