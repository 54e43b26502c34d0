//! Along which path does a bead fall fastest?
//!
//! The time of a fall is the integral of a Lagrangian over x, which replaces the time: L(y, y') = √((1 + y'²)/y) with the depth y below the
//! start. L is not quadratic in y'. The attribute finds the energy −√(1/y − p²) by its rule for roots. The energy is constant, which is
//! Beltrami's identity y (1 + y'²) = const, and the path is a cycloid. A hanging chain has L = y√(1 + y'²) and Beltrami's constant
//! y/√(1 + y'²).

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use std::error::Error;

/// The time that a bead needs for a piece of its path.
#[lagrangian(q = y, v = slope, t = _x)]
fn fall(y: f64, slope: f64, _x: f64) -> f64 {
    ((1.0 + slope * slope) / y).sqrt()
}

/// The weight of a piece of a chain, at a height y.
#[lagrangian(q = y, v = slope)]
fn chain(y: f64, slope: f64) -> f64 {
    y * (1.0 + slope * slope).sqrt()
}

/// First and last angle of the rolling wheel that draws the cycloid.
const ANGLES: [f64; 2] = [1.0, 3.0];

/// x, y and y' of the cycloid.
fn cycloid(angle: f64) -> (f64, f64, f64) {
    (angle - angle.sin(), 1.0 - angle.cos(), angle.sin() / (1.0 - angle.cos()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let counts = [20, 40, 80];
    let [midpoint, gauss, discrete] = [
        counts.map(|steps| path(ImplicitMidpoint, steps)),
        counts.map(|steps| path(Gauss::<3>, steps)),
        counts.map(|steps| path(DiscreteGradient, steps)),
    ];
    let row = |name: &str, paths: &[Result<Path, StepError>; 3]| -> Result<[String; 5], StepError> {
        let errors = paths.each_ref().map(|path| path.as_ref().map(|path| path.error).map_err(|error| *error));
        let [a, b, c] = [errors[0]?, errors[1]?, errors[2]?];
        let beltrami = paths[0].as_ref().map(|path| path.beltrami).map_err(|error| *error)?;
        Ok([name.into(), format!("{a:.1e}"), format!("{b:.1e}"), format!("{c:.1e}"), format!("{beltrami:.1e}")])
    };
    let rows = [row("ImplicitMidpoint", &midpoint)?, row("DiscreteGradient", &discrete)?, row("Gauss<3>", &gauss)?];
    println!("A fall from y = {:.3} to {:.3}\n", cycloid(ANGLES[0]).1, cycloid(ANGLES[1]).1);
    println!("{}", table(["", "20 steps", "40", "80", "Beltrami, 20"], &rows));
    println!("error of y at the end; change of y (1 + y'²)\n");

    println!("A chain from x = 0 to 2: error of y by 20 steps of Gauss<2> {:.1e}\n", hung()?.1);
    let [midpoint, gauss, discrete] =
        [midpoint, gauss, discrete].map(|paths| paths.map(|path| path.map(|p| (p.error, p.beltrami))));
    let order = |coarse: (f64, f64), fine: (f64, f64)| (coarse.0 / fine.0).log2();
    claim("the midpoint rule is of order 2, Gauss' method of order 6", {
        (order(midpoint[1]?, midpoint[2]?) - 2.0).abs() < 0.2 && (order(gauss[1]?, gauss[2]?) - 6.0).abs() < 0.6
    })?;
    claim("the discrete gradient keeps Beltrami's constant to 1e-13, the midpoint rule to 1e-2 alone", {
        discrete[0]?.1 < 1e-13 && midpoint[0]?.1 > 1e-4
    })?;
    println!();
    draw(&[path(ImplicitMidpoint, 20)?, path(Gauss::<3>, 20)?, path(DiscreteGradient, 20)?], &hung()?.0)
}

/// Returns the points of a chain from its lowest point, and the error of its end against the hyperbolic cosine.
fn hung() -> Result<(Vec<(f64, f64)>, f64), StepError> {
    let mut sim = Chain.integrator(Gauss::<2>, 0.1, Chain.at(1.0, 0.0));
    let mut points = vec![(0.0, 1.0)];
    for _ in 0..20 {
        sim.step()?;
        points.push((sim.state().t, sim.state().q));
    }
    Ok((points, (sim.state().q - 2.0_f64.cosh()).abs()))
}

/// A path by equal steps of x.
struct Path {
    points: Vec<(f64, f64)>,
    error: f64,
    /// Largest change of Beltrami's constant. The field `changes` has the change at each x.
    beltrami: f64,
    changes: Vec<(f64, f64)>,
}

fn path<M: Method<Fall, f64>>(method: M, steps: u64) -> Result<Path, StepError> {
    let [(x, y, slope), (end, depth, _)] = ANGLES.map(cycloid);
    let mut sim = Fall.integrator(method, (end - x) / steps as f64, Fall.at_time(x, y, slope));
    let (mut points, mut changes) = (vec![(x, y)], vec![]);
    for _ in 0..steps {
        sim.step()?;
        let State { t, q, .. } = sim.state();
        points.push((t, q));
        changes.push((t, (q * (1.0 + sim.velocity().powi(2)) - 2.0).abs()));
    }
    let beltrami = changes.iter().fold(0.0, |largest, (_, change)| f64::max(largest, *change));
    Ok(Path { error: (sim.state().q - depth).abs(), points, beltrami, changes })
}

fn draw([midpoint, gauss, discrete]: &[Path; 3], hung: &[(f64, f64)]) -> Result<(), Box<dyn Error>> {
    let down = |points: &[(f64, f64)]| points.iter().map(|(x, y)| (*x, -*y)).collect::<Vec<_>>();
    let exact: Vec<(f64, f64)> =
        (0..=100).map(|i| cycloid(f64::from(i) * 3.2 / 100.0)).map(|(x, y, _)| (x, y)).collect();
    let straight = [gauss.points[0], gauss.points[gauss.points.len() - 1]];
    let fall = Panel::new(
        "The fastest way down",
        "20 steps of Gauss, 3 stages, with x for time; lengths in radii of the wheel",
        [Axis::linear("x", 0.0..3.4), Axis::linear("−y", -2.2..0.2)],
        vec![
            Curve::line("cycloid", palette::GREY, down(&exact)),
            Curve::line("straight", palette::VERMILION, down(&straight)),
            Curve::dots("Gauss", palette::BLUE, down(&gauss.points)),
        ],
    );
    let beltrami = Panel::new(
        "Change of Beltrami's constant",
        "20 steps with x for time; differences of 0 are not drawn",
        [Axis::linear("x", 0.0..3.4), Axis::decades("|y (1 + y'²) − 2|", -17.0..0.0)],
        vec![
            Curve::line("midpoint rule", palette::VERMILION, midpoint.changes.clone()),
            Curve::line("Gauss, 3 stages", palette::BLUE, gauss.changes.clone()),
            Curve::line("discrete gradient", palette::GREEN, discrete.changes.clone()).rounding(),
        ],
    );
    let cosh = (0..=100).map(|i| f64::from(i) / 50.0).map(|x| (x, x.cosh())).collect();
    let chain = Panel::new(
        "Half of a hanging chain",
        "20 steps of Gauss, 2 stages; lengths in its lowest height",
        [Axis::linear("x", 0.0..2.2), Axis::linear("y", 0.5..4.0)],
        vec![Curve::line("cosh x", palette::GREY, cosh), Curve::dots("Gauss", palette::BLUE, hung.to_vec())],
    );
    let panels = [fall, beltrami, chain];
    figure("brachistochrone.svg", (4, 3), &panels)
}
