//! How long may a step of steepest descent be?
//!
//! The flow q' = −∇U(q) is the base of H = −p·∇U(q); the option `lift` of the attribute states this. The macro splits the field into
//! coordinates. With the other coordinates fixed, each one obeys an equation that J. Bernoulli solved in 1695. Each of these flows goes
//! downhill, and so does every step of any length. The accuracy of the path is a separate question.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, orbit, order, table};
use geoint_runtime::StepError;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Steepest descent on U = (|q|² − 1)²/4 + b q₀²/2.
#[contact_hamiltonian(lift)]
fn descent(q: [f64; 2], p: [f64; 2], s: f64, b: f64) -> f64 {
    let slope = q[0] * q[0] + q[1] * q[1] - 1.0;
    -p[0] * q[0] * (slope + b) - p[1] * q[1] * slope + 0.0 * s
}

const SYSTEM: Descent = Descent { b: 0.3 };

fn height([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y - 1.0).powi(2) / 4.0 + SYSTEM.b * x * x / 2.0
}

fn path(h: f64, start: [f64; 2], duration: f64) -> Result<Vec<[f64; 2]>, StepError> {
    let states = orbit(SYSTEM, ContactSplitting, h, ContactState::new(start, [0.0; 2], 0.0), duration)?;
    Ok(states.into_iter().map(|x| x.q).collect())
}

/// Returns the points of steepest descent by explicit Euler steps.
fn euler(h: f64, start: [f64; 2], duration: f64) -> Vec<[f64; 2]> {
    let step = |&[x, y]: &[f64; 2]| {
        let slope = x * x + y * y - 1.0;
        Some([x - h * x * (slope + SYSTEM.b), y - h * y * slope])
    };
    std::iter::successors(Some(start), step).take((duration / h).round() as usize + 1).collect()
}

fn rises(points: &[[f64; 2]]) -> usize {
    // The tolerance ignores rounding errors at the minimum.
    points.windows(2).filter(|pair| height(pair[1]) > height(pair[0]) + 1e-15 || height(pair[1]).is_nan()).count()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Descent::REPORT);
    let start = [1.6, 0.2];
    let mut rows = vec![];
    let (mut steady, mut reaches) = (true, true);
    for h in [0.1, 1.0, 10.0, 100.0] {
        let duration = f64::max(200.0 * h, 100.0);
        let points = path(h, start, duration)?;
        let end = points.last().copied().unwrap_or(start);
        steady &= rises(&points) == 0;
        reaches &= height(end) < 1e-12;
        let of_euler = rises(&euler(h, start, duration));
        let heights = [format!("{:.4}", height(points[1])), format!("{:.1e}", height(end))];
        let [first, last] = heights;
        rows.push([h.to_string(), first, last, rises(&points).to_string(), of_euler.to_string()]);
    }
    println!("from U = {:.4} at (1.6, 0.2), up to t = 100 at least\n", height(start));
    println!("{}", table(["h", "U after one step", "in the end", "rises", "of explicit Euler"], &rows));
    claim("no step rises, at all four step sizes", steady)?;
    claim("all of them end in a minimum", reaches)?;
    let far = path(0.001, start, 2.0)?;
    let truth = far[far.len() - 1];
    let error = |h: f64| -> Result<f64, StepError> {
        let points = path(h, start, 2.0)?;
        let end = points[points.len() - 1];
        Ok((end[0] - truth[0]).hypot(end[1] - truth[1]))
    };
    let observed = order(error(0.1)?, error(0.05)?);
    claim(&format!("short steps follow the path to order 2 (observed {observed:.2})"), (observed - 2.0).abs() < 0.1)?;

    let starts = [[1.6, 0.2], [-1.6, -0.4], [0.1, 0.05], [-0.4, 1.5], [0.9, -1.4], [-0.05, -0.02]];
    let mut curves = vec![];
    for start in starts {
        let name = if curves.is_empty() { "h = 0.01" } else { "" };
        let flow = path(0.01, start, 40.0)?.into_iter().map(|[x, y]| (x, y)).collect();
        curves.push(Curve::line(name, palette::GREY, flow));
    }
    for (h, colour, size) in [(0.2, palette::BLUE, 1.6), (2.0, palette::VERMILION, 3.5)] {
        let mut points = vec![];
        for start in starts {
            points.extend(path(h, start, 40.0)?.into_iter().map(|[x, y]| (x, y)));
        }
        curves.push(Curve::dots(format!("h = {h}"), colour, points).marked(size).open());
    }
    let plane = Panel::new(
        "Descent to two minima",
        "ContactSplitting from six points, up to t = 40; dimensionless",
        [Axis::linear("q₀", -1.7..1.7), Axis::linear("q₁", -1.6..1.6)],
        curves,
    );
    let mut heights = vec![];
    for (h, colour) in [(0.1, palette::GREEN), (1.0, palette::BLUE), (10.0, palette::VERMILION)] {
        let points = path(h, start, 40.0 * h)?;
        // Stop at 10⁻³⁰. Smaller heights are rounding errors, and zero has no logarithm.
        let points = points.iter().map(|x| height(*x)).take_while(|height| *height > 1e-30).zip(0..);
        let points = points.map(|(height, n)| (f64::from(n), height)).collect();
        heights.push(Curve::line(format!("h = {h}"), colour, points).width(0.8).solid().marked(2.5));
    }
    let heights = Panel::new(
        "Steepest descent: height after each step",
        "ContactSplitting from (1.6, 0.2), dimensionless; down to U = 10⁻³⁰, which is rounding",
        [Axis::linear("steps", 0.0..40.0), Axis::decades("U", -30.0..1.0)],
        heights,
    );
    figure("gradient_flow.svg", (5, 4), &[plane.equal(), heights])
}
