//! How does the period of a relativistic particle on a spring depend on its amplitude?
//!
//! The Lagrangian is not quadratic in the velocity. A rule of conjugates gives the energy √(m²c⁴ + p²c²) + k q²/2. It is T(p) + V(q), so kick
//! and drift exist. The period grows with the amplitude, because the speed stays below c.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;

/// In units in which m, c and k may be 1.
#[lagrangian(require(separable))]
fn relativistic(q: f64, v: f64, m: f64, c: f64, k: f64) -> f64 {
    -m * c * c * (1.0 - v * v / (c * c)).sqrt() - 0.5 * k * q * q
}

const SYSTEM: Relativistic = Relativistic { m: 1.0, c: 1.0, k: 1.0 };
const AMPLITUDES: [f64; 9] = [0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.5, 6.0];

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Relativistic::<f64>::REPORT.lines().take(12).collect::<Vec<_>>().join("\n"));
    println!();
    let mut rows = vec![];
    let mut periods = vec![];
    for amplitude in AMPLITUDES {
        let (found, exact) = (period(amplitude)?, integral(amplitude));
        rows.push([format!("{amplitude}"), format!("{found:.9}"), format!("{exact:.9}")]);
        periods.push((amplitude, found, exact));
    }
    println!("{}", table(["amplitude", "period", "by quadrature"], &rows));
    let fastest = |amplitude: f64| (1.0 - 1.0 / (1.0 + amplitude * amplitude / 2.0).powi(2)).sqrt();
    claim(
        "periods agree with a quadrature to 1e-7",
        periods.iter().all(|(_, found, exact)| (found - exact).abs() < 1e-7),
    )?;
    claim("a small swing takes 2π(1 + 3A²/16)", {
        let (a, found, _) = periods[0];
        (found / TAU - 1.0 - 3.0 * a * a / 16.0).abs() < 1e-5
    })?;
    claim("a long one takes the time of light to all four ends, and a little more", {
        let (a, found, _) = periods[8];
        found > 4.0 * a && found < 4.0 * a + 1.0
    })?;
    let swing = swing(6.0)?;
    let speed = swing.iter().fold(0.0, |most, (_, _, v)| f64::max(most, v.abs()));
    claim("the speed stays below that of light, and is what the energy says", {
        speed < 1.0 && (speed - fastest(6.0)).abs() < 1e-4
    })?;
    println!();
    draw(&periods)
}

/// Returns times, positions relative to the amplitude, and velocities.
fn swing(amplitude: f64) -> Result<Vec<(f64, f64, f64)>, StepError> {
    let h = 0.01;
    let mut sim = SYSTEM.integrator(BlanesMoan6, h, SYSTEM.at(amplitude, 0.0));
    let mut samples = vec![];
    while sim.state().t < 30.0 {
        samples.push((sim.state().t, sim.state().q / amplitude, sim.velocity()));
        sim.step()?;
    }
    Ok(samples)
}

/// Returns four times the time from the turning point to q = 0. A cubic through both ends of the last step gives its zero.
fn period(amplitude: f64) -> Result<f64, StepError> {
    let h = 0.01;
    let mut sim = SYSTEM.integrator(BlanesMoan6, h, SYSTEM.at(amplitude, 0.0));
    loop {
        let before = (sim.state(), sim.velocity());
        sim.step()?;
        let after = (sim.state(), sim.velocity());
        if after.0.q <= 0.0 {
            let cubic = |x: f64| {
                let [a, b] = [before.0.q, after.0.q];
                let [u, w] = [h * before.1, h * after.1];
                a + x * (u + x * (3.0 * (b - a) - 2.0 * u - w + x * (2.0 * (a - b) + u + w)))
            };
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if cubic(middle) > 0.0 { low = middle } else { high = middle }
            }
            return Ok(4.0 * (before.0.t + low * h));
        }
    }
}

/// Computes the period 4 ∫ dq/v with q = A sin φ. The trapezoidal rule is exact to rounding for a periodic function.
fn integral(amplitude: f64) -> f64 {
    let points = 400;
    let sum: f64 = (0..points)
        .map(|i| {
            let phase = TAU * f64::from(i) / f64::from(points);
            let excess = 0.5 * (amplitude * phase.cos()).powi(2);
            // γ = 1 + excess, and v = √(γ² − 1)/γ.
            (1.0 + excess) / (1.0 + 0.5 * excess).sqrt()
        })
        .sum();
    TAU * sum / f64::from(points)
}

fn draw(periods: &[(f64, f64, f64)]) -> Result<(), Box<dyn Error>> {
    let mut motion = vec![];
    for (amplitude, ink) in [(0.25, palette::BLUE), (2.0, palette::GREEN), (6.0, palette::VERMILION)] {
        let points = swing(amplitude)?.into_iter().map(|(t, q, _)| (t, q)).collect();
        motion.push(Curve::line(format!("A = {amplitude}"), ink, points).width(1.4));
    }
    let motion = Panel::new(
        "Relativistic particle on a spring, from rest at A",
        "BlanesMoan6, h = 0.01; units in which m = c = k = 1",
        [Axis::linear("t", 0.0..30.0), Axis::linear("q/A", -1.1..1.1)],
        motion,
    );
    let fine: Vec<f64> = (0..=120).map(|i| f64::from(i) / 20.0).collect();
    let of = |value: &dyn Fn(f64) -> f64| fine.iter().map(|a| (*a, value(*a))).collect::<Vec<_>>();
    let light = fine.iter().filter(|a| **a >= 1.5).map(|a| (*a, 4.0 * a)).collect();
    let period = Panel::new(
        "Period of a relativistic particle on a spring",
        "BlanesMoan6, h = 0.01, and a quadrature; m = c = k = 1",
        [Axis::linear("A", 0.0..6.2), Axis::linear("period", 4.0..26.0)],
        vec![
            Curve::line("quadrature", palette::BLUE, of(&integral)).solid(),
            Curve::line("light, 4A/c", palette::GREY, light).width(1.0),
            Curve::dots("integrated", palette::VERMILION, periods.iter().map(|(a, found, _)| (*a, *found)).collect()),
        ],
    );
    figure("relativistic.svg", (4, 3), &[motion, period])
}
