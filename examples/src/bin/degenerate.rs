//! How does one integrate a Lagrangian that is linear in the velocities?
//!
//! L = ϑ(q)·v − H(q) has the equations Ω q' = ∇H with Ω = dϑ. The attribute derives Ω and its inverse. The first system is that of Lotka and
//! Volterra in numbers of animals, without logarithms. One component of ϑ is zero there. Gauss methods then move the other coordinate with its
//! momentum ϑ, and are symplectic; the discrete gradient keeps H to rounding. The second system is the guiding centre of a charged particle
//! in a torus, without a zero component.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Prey and predators.
#[lagrangian]
fn animals(q: [f64; 2], v: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    let [x, y] = q;
    y.ln() / x * v[0] + b * x - c * x.ln() + b * y - a * y.ln()
}

/// The guiding centre of a charged particle; q is (r, φ, z, u), with u the velocity along the field.
#[lagrangian]
fn guiding_centre(q: [f64; 4], v: [f64; 4], field: f64, twist: f64, moment: f64) -> f64 {
    let [r, _, z, u] = q;
    let (x, y) = (r - 1.0, z);
    // The toroidal field falls as 1/r. A smaller poloidal field twists its lines about the circle r = 1.
    let toroidal = field / r;
    let [along_r, along_z] = [y / (twist * r), -x / (twist * r)];
    let strength = (toroidal * toroidal + along_r * along_r + along_z * along_z).sqrt();
    let part = u / strength;
    let potential = [-field * z / (2.0 * r), (x * x + y * y) / (2.0 * twist), 0.5 * field * r.ln()];
    (potential[0] + part * along_r) * v[0]
        + (potential[1] + part * toroidal * r) * v[1]
        + (potential[2] + part * along_z) * v[2]
        - (0.5 * u * u + moment * strength)
}

const ANIMALS: Animals = Animals { a: 1.0, b: 0.7, c: 0.5 };
const GUIDED: GuidingCentre = GuidingCentre { field: 1.0, twist: 2.0, moment: 2.25e-6 };
const H: f64 = 0.2;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Animals::<f64>::REPORT);
    let runs = [
        ("RK4", palette::BLACK, strayed(RK4)?),
        ("Gauss, 1 stage", palette::VERMILION, strayed(Gauss::<1>)?),
        ("Gauss, 2 stages", palette::BLUE, strayed(Gauss::<2>)?),
        ("discrete gradient", palette::GREEN, strayed(DiscreteGradient)?),
    ];
    let largest = |run: &[(f64, f64)]| run.iter().fold(0.0, |most, (_, error)| f64::max(most, *error));
    let rows = runs.each_ref().map(|(name, _, run)| [(*name).into(), format!("{:.1e}", largest(run))]);
    println!("{}", table(["method, h = 0.2", "H strays by, in 2000"], &rows));

    let [rk4, one, two, gradient] = runs.each_ref().map(|(_, _, run)| run);
    claim("symplectic methods keep H to their order, in 10 as in 2000 units of time", {
        [one, two].iter().all(|run| largest(run) < 1.5 * largest(&run[..run.len() / 2]))
    })?;
    claim(
        "RK4 does not: it strays twice as far in twice the time",
        largest(rk4) > 1.8 * largest(&rk4[..rk4.len() / 2]),
    )?;
    claim("the discrete gradient keeps H to 2e-14", largest(gradient) < 2e-14)?;
    claim("canonical coordinates were found for animals, none for the guiding centre", {
        Animals::<f64>::REPORT.contains("canonical coordinates: q[0]")
            && GuidingCentre::<f64>::REPORT.contains("no canonical coordinates")
    })?;
    let (orbit, kept) = banana()?;
    claim("the particle is a trapped one, which turns where the field is strong", {
        let turns = orbit.windows(2).filter(|pair| pair[0][2].signum() != pair[1][2].signum()).count();
        turns > 4 && orbit.iter().all(|point| point[0] > 1.0)
    })?;
    claim("its energy is kept to rounding, its momentum about the axis to the order of the method", {
        kept[0] < 1e-12 && kept[1] < 1e-4
    })?;
    println!();
    draw(&runs, &orbit)
}

/// Returns times, each with the largest error of H in the last ten steps.
fn strayed<M: Method<Animals>>(method: M) -> Result<Vec<(f64, f64)>, StepError> {
    let mut sim = ANIMALS.integrator(method, H, ANIMALS.at([1.0, 1.5]));
    let before = sim.energy();
    let mut errors = vec![];
    for _ in 0..1000 {
        let mut most: f64 = 0.0;
        for _ in 0..10 {
            sim.step()?;
            most = most.max((sim.energy() - before).abs());
        }
        errors.push((sim.state().t, most));
    }
    Ok(errors)
}

/// Returns (r, z, u) of the guiding centre after each step, and the largest relative changes of its energy and of its
/// momentum about the axis.
fn banana() -> Result<(Vec<[f64; 3]>, [f64; 2]), StepError> {
    let start = GUIDED.at([1.05, 0.0, 0.0, -4.306e-4]);
    let mut sim = GUIDED.integrator(DiscreteGradient, 100.0, start);
    let momentum = |x: [f64; 4]| GUIDED.momentum(0.0, x)[1];
    let (energy, about) = (sim.energy(), momentum(start.x));
    let (mut orbit, mut strayed) = (vec![], [0.0; 2]);
    for _ in 0..1500 {
        let [r, _, z, u] = sim.state().x;
        orbit.push([r, z, u]);
        strayed = [
            f64::max(strayed[0], (sim.energy() / energy - 1.0).abs()),
            f64::max(strayed[1], (momentum(sim.state().x) / about - 1.0).abs()),
        ];
        sim.step()?;
    }
    Ok((orbit, strayed))
}

/// A name, its colour, and points of a figure.
type Named = (&'static str, Ink, Vec<(f64, f64)>);

fn draw(runs: &[Named], orbit: &[[f64; 3]]) -> Result<(), Box<dyn Error>> {
    let mut orbits = vec![];
    for (start, name) in [(1.2, "four starts"), (1.5, ""), (2.2, ""), (3.0, "")] {
        let mut sim = ANIMALS.integrator(Gauss::<2>, 0.05, ANIMALS.at([1.0, start]));
        let mut points = vec![];
        while sim.state().t < 14.0 {
            points.push((sim.state().x[0], sim.state().x[1]));
            sim.step()?;
        }
        orbits.push(Curve::line(name, palette::BLUE, points).solid().width(1.3));
    }
    let portrait = Panel::new(
        "Prey and predators",
        "Gauss, 2 stages, h = 0.05; dimensionless",
        [Axis::linear("prey", 0.0..2.4), Axis::linear("predators", 0.0..3.4)],
        orbits,
    );
    let curves =
        runs.iter().map(|(name, ink, run)| Curve::line(*name, *ink, run.clone()).rounding().width(1.2)).collect();
    let energy = Panel::new(
        "Prey and predators: error of H",
        "h = 0.2, dimensionless; differences of 0 are not drawn",
        [Axis::linear("time", 0.0..2000.0), Axis::decades("|H − H₀|", -17.0..0.0)],
        curves,
    );
    let way = orbit.iter().map(|point| (point[0], point[1])).collect();
    let banana = Panel::new(
        "A guiding centre in a torus",
        "discrete gradient, h = 100; lengths in radii of the torus, dimensionless",
        [Axis::linear("r", 0.98..1.06), Axis::linear("z", -0.04..0.04)],
        vec![Curve::line("banana orbit", palette::GREEN, way).solid().width(1.2)],
    );
    figure("degenerate.svg", (4, 3), &[portrait, energy, banana])
}
