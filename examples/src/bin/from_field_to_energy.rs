//! Which planar fields have an energy, and what is its formula?
//!
//! On a simply connected domain div f = 0 is enough (J. Liouville); then f = (∂H/∂p, −∂H/∂q). The fields are those of T. Aung, *Numerical ODE
//! solvers that preserve first integrals*, MSc thesis, Rochester Institute of Technology, 2000, chapters 2 to 4. The program contains only f.
//! The attribute derives H at compile time, or reports the divergence if no H exists. Steps keep the derived H to rounding.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{changes, claim, largest, table};
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, PhaseSpace};
use std::error::Error;

/// Example 2.2.2: the saddle.
#[vector_field]
fn saddle(x: [f64; 2]) -> [f64; 2] {
    [x[0] + x[1], x[0] - x[1]]
}

/// Example 2.2.3, as printed.
#[vector_field]
fn linear(x: [f64; 2]) -> [f64; 2] {
    [x[0] + 2.0 * x[1], x[0] - x[1]]
}

/// Example 2.2.3, as H is printed.
#[vector_field]
fn parabola(x: [f64; 2]) -> [f64; 2] {
    [x[0] + 2.0 * x[1], x[0] * x[0] - x[1]]
}

/// Example 2.2.4: its divergence is t + 2.
#[vector_field]
fn swelling(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t - 2.0 * x[1], x[0] + 2.0 * x[1]]
}

/// Example 2.2.5: H reads time.
#[vector_field]
fn driven(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t + 2.0 * x[1], x[0] * x[0] - x[1] * t]
}

/// Example 2.2.7 with F = cosh p, which is free there.
#[vector_field]
fn half_given(x: [f64; 2]) -> [f64; 2] {
    let [q, p] = x;
    [-2.0 * p * q - 2.0 * q + p.sinh(), p * p - 2.0 * q + 2.0 * p]
}

/// Example 3.1.1: the oscillator.
#[vector_field]
fn oscillator(x: [f64; 2], omega: f64) -> [f64; 2] {
    [x[1], -omega * omega * x[0]]
}

/// Example 3.1.2: Duffing's.
#[vector_field]
fn duffing(x: [f64; 2]) -> [f64; 2] {
    [x[1], -x[0] - x[0].powi(3)]
}

/// Example 4.1.2: predators and prey, with a multiplier.
#[vector_field]
fn predators(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}

type Plane = FlowState<[f64; 2]>;

/// Returns the lines of a report about the divergence, the energy and the multiplier of a field.
fn findings(report: &str) -> Vec<&str> {
    let of_interest = ["- div f", "- canonical", "- Jacobi's multiplier", "- f = J"];
    report.lines().filter(|line| of_interest.iter().any(|words| line.starts_with(words))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let reports = [
        ("2.2.2", Saddle::REPORT),
        ("2.2.3", Linear::REPORT),
        ("2.2.3, H", Parabola::REPORT),
        ("2.2.4", Swelling::REPORT),
        ("2.2.5", Driven::REPORT),
        ("2.2.7", HalfGiven::REPORT),
        ("3.1.1", Oscillator::<f64>::REPORT),
        ("3.1.2", Duffing::REPORT),
        ("4.1.2", Predators::<f64>::REPORT),
    ];
    for (example, report) in reports {
        println!("{example}");
        for line in findings(report) {
            println!("  {line}");
        }
    }
    println!();
    let says = |report: &str, words: &str| findings(report).iter().any(|line| line.contains(words));
    claim("the field of example 2.2.4 has none: div f = t + 2", says(Swelling::REPORT, "div f = t + 2"))?;
    claim("predators and prey have a multiplier, 1/xy", says(Predators::<f64>::REPORT, "μ = 1/(x[0]·x[1])"))?;
    claim("the others are canonical", {
        let canonical = |i: usize| says(reports[i].1, "canonical, H = ");
        [0, 1, 2, 4, 5, 6, 7].into_iter().all(canonical)
    })?;
    let at = FlowState { t: 0.4, x: [0.3, -0.7] };
    let [q, p, t] = [0.3_f64, -0.7_f64, 0.4];
    let expected = [
        (Saddle.energy(&at), q * p + p * p / 2.0 - q * q / 2.0),
        (Linear.energy(&at), q * p + p * p - q * q / 2.0),
        (Parabola.energy(&at), q * p + p * p - q.powi(3) / 3.0),
        (Driven.energy(&at), q * p * t + p * p - q.powi(3) / 3.0),
        (HalfGiven.energy(&at), -p * p * q + q * q - 2.0 * p * q + p.cosh()),
        (Oscillator { omega: 1.5 }.energy(&at), p * p / 2.0 + 1.125 * q * q),
        (Duffing.energy(&at), p * p / 2.0 + q * q / 2.0 + q.powi(4) / 4.0),
    ];
    claim("and have the energies that are printed there", {
        largest(expected.map(|(found, printed)| found - printed)) < 1e-15
    })?;

    let rows = [
        row("2.2.2", Saddle, RK4, [1.0, 0.5], 2, |x| Saddle.energy(x))?,
        row("2.2.3", Linear, RK4, [1.0, 0.5], 2, |x| Linear.energy(x))?,
        row("2.2.3, H", Parabola, RK4, [-0.3, 0.2], 1000, |x| Parabola.energy(x))?,
        row("2.2.7", HalfGiven, RK4, [-0.25, -0.3], 1000, |x| HalfGiven.energy(x))?,
        row("3.1.1", Oscillator { omega: 1.5 }, RK4, [1.0, 0.0], 1000, |x| Oscillator { omega: 1.5 }.energy(x))?,
        row("3.1.2", Duffing, RK4, [0.9, 0.0], 1000, |x| Duffing.energy(x))?,
    ];
    println!("\nlargest changes of the energies that were derived, h = {STEP}\n");
    let text = |(name, time, [dg, rk4], _): &Row| {
        [(*name).into(), time.to_string(), format!("{dg:.1e}"), format!("{rk4:.1e}")]
    };
    println!("{}", table(["field", "up to", "DiscreteGradient", "RK4"], &rows.each_ref().map(text)));
    claim("steps of the field keep them to rounding", rows.iter().all(|row| row.2[0] < 1e-12))?;

    figure("from_field_to_energy.svg", (4, 3), &[parabolas()?, small()?, kept(&rows)])
}

const STEP: f64 = 0.1;

/// Name of a field, duration, largest energy changes by the discrete gradient and by RK4, and both changes over time.
type Row = (&'static str, u32, [f64; 2], [Vec<(f64, f64)>; 2]);

fn row<S, K>(
    name: &'static str,
    system: S,
    explicit: K,
    x: [f64; 2],
    time: u32,
    energy: impl Fn(&Plane) -> f64,
) -> Result<Row, StepError>
where
    S: PhaseSpace<State = Plane>,
    DiscreteGradient: Method<S>,
    K: Method<S>,
{
    let steps = (f64::from(time) / STEP).round() as u64;
    let of = |samples: Vec<(f64, [f64; 1])>| samples.into_iter().map(|(t, [change])| (t, change)).collect::<Vec<_>>();
    let start = FlowState::new(x);
    let kept = of(changes(&mut Integrator::new(system, DiscreteGradient, STEP, start), steps, |x| [energy(x)])?);
    let lost = of(changes(&mut Integrator::new(system, explicit, STEP, start), steps, |x| [energy(x)])?);
    let last = |samples: &[(f64, f64)]| samples[samples.len() - 1].1;
    Ok((name, time, [last(&kept), last(&lost)], [kept, lost]))
}

/// Returns points of an orbit until it leaves the square with the half-width `half`.
fn path<S>(system: S, x: [f64; 2], h: f64, steps: usize, half: f64) -> Vec<(f64, f64)>
where
    S: PhaseSpace<State = Plane>,
    DiscreteGradient: Method<S>,
{
    let mut sim = Integrator::new(system, DiscreteGradient, h, FlowState::new(x));
    let states = sim.sampled(1).take(steps).map_while(Result::ok).map(|state| (state.x[0], state.x[1]));
    std::iter::once((x[0], x[1])).chain(states.take_while(|(x, y)| x.abs().max(y.abs()) < half)).collect()
}

/// Orbits on both sides of the separatrix, forwards and backwards in time.
fn parabolas() -> Result<Panel, Box<dyn Error>> {
    let groups: [(&str, Ink, &[[f64; 2]]); 2] = [
        ("around the centre", palette::BLUE, &[[-0.4, 0.2], [-0.25, 0.125], [-0.08, 0.04]]),
        ("beyond the separatrix", palette::VERMILION, &[[0.3, 0.0], [0.6, 0.3], [0.0, -0.5], [-1.2, 0.0]]),
    ];
    let mut curves = vec![];
    for (name, ink, starts) in groups {
        for (i, x) in starts.iter().enumerate() {
            for (j, h) in [0.02, -0.02].into_iter().enumerate() {
                let name = if i + j == 0 { name } else { "" };
                curves.push(Curve::line(name, ink, path(Parabola, *x, h, 400, 2.0)));
            }
        }
    }
    Ok(Panel::new(
        "x' = x + 2y, y' = x² − y",
        "H = xy + y² − x³/3 was derived; DiscreteGradient, h = 0.02, dimensionless",
        [Axis::linear("x", -1.6..1.6), Axis::linear("y", -1.6..1.6)],
        curves,
    ))
}

/// Draws the figure of example 3.1.2: Duffing's equation with the small amplitudes of the thesis.
fn small() -> Result<Panel, Box<dyn Error>> {
    let mut curves = vec![];
    for (x, ink) in [(0.01, palette::GREEN), (0.02, palette::BLUE), (0.03, palette::VERMILION)] {
        curves.push(Curve::line(format!("from x = {x}"), ink, path(Duffing, [x, 0.0], 0.1, 63, 1.0)));
    }
    Ok(Panel::new(
        "x' = y, y' = −x − x³",
        "H = y²/2 + x²/2 + x⁴/4 was derived; DiscreteGradient, h = 0.1, dimensionless",
        [Axis::linear("x", -0.035..0.035), Axis::linear("y", -0.035..0.035)],
        curves,
    ))
}

fn kept(rows: &[Row; 6]) -> Panel {
    let mut curves = vec![];
    for (row, ink) in rows[3..].iter().zip([palette::GREEN, palette::VERMILION, palette::BLUE]) {
        curves.push(Curve::line(format!("{}, RK4", row.0), ink, row.3[1].clone()));
        curves.push(Curve::line(format!("{}, DiscreteGradient", row.0), ink, row.3[0].clone()).width(0.9).rounding());
    }
    Panel::new(
        "Change of the derived energies",
        format!("h = {STEP}, dimensionless; numbers of fields as in T. Aung (2000)"),
        [Axis::decades("time", -1.0..3.0), Axis::decades("|H − H₀|, largest so far", -17.5..0.0)],
        curves,
    )
}
