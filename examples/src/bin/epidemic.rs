//! How many people does an epidemic never infect?
//!
//! W. O. Kermack & A. G. McKendrick, Proc. R. Soc. Lond. A 115 (1927) 700, divide a population into susceptible, infected and recovered parts.
//! The orbit equation ds/dr = −(k/l) s gives the integral ln s + (k/l) r. The sum of the three parts is another integral. Both determine the
//! end: ln s∞ + R₀ (1 − s∞) = ln s₀ + R₀ r₀ with R₀ = k/l. Steps that keep both integrals to rounding end there, at any step size.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use std::error::Error;

/// k infections by each infected and l recoveries a day.
#[vector_field(keeps(people = x[0] + x[1] + x[2], spread = x[0].ln() + k / l * x[2]))]
fn epidemic(x: [f64; 3], k: f64, l: f64) -> [f64; 3] {
    [-k * x[0] * x[1], k * x[0] * x[1] - l * x[1], l * x[1]]
}

type Parts = FlowState<[f64; 3]>;

const START: [f64; 3] = [0.999, 0.001, 0.0];

/// A disease from which people recover in ten days.
fn disease(ratio: f64) -> Epidemic {
    Epidemic { k: ratio / 10.0, l: 0.1 }
}

/// The smaller solution s of ln s + R₀ (1 − s) = ln s₀, by Newton's iteration from below, where the function is concave.
fn never_infected(ratio: f64) -> f64 {
    let mut s = START[0] * (-ratio).exp();
    for _ in 0..100 {
        s -= ((s / START[0]).ln() + ratio * (1.0 - s)) / (1.0 / s - ratio);
    }
    s
}

/// Returns the susceptible part after [`DAYS`] days. The infected part has vanished by this time.
fn end<M: Method<Epidemic>>(method: M, ratio: f64, h: f64) -> Result<f64, StepError> {
    let mut sim = Integrator::new(disease(ratio), method, h, FlowState::new(START));
    sim.advance((DAYS / h).round() as u64)?;
    Ok(sim.state().x[0])
}

const DAYS: f64 = 960.0;
const STEPS: [f64; 6] = [8.0, 4.0, 2.0, 1.0, 0.5, 0.25];

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Epidemic::REPORT);
    let ratio = 2.5;
    let exact = never_infected(ratio);
    println!("R₀ = {ratio}: {:.10} of all are never infected; the table has the results of steps of h days\n", exact);
    let mut errors: [Vec<(f64, f64)>; 4] = Default::default();
    let mut rows = vec![];
    for h in STEPS {
        let found = [
            end(RK4, ratio, h)?,
            end(Gauss::<2>, ratio, h)?,
            end(DiscreteGradient, ratio, h)?,
            end(FourthOrder(DiscreteGradient), ratio, h)?,
        ];
        for (errors, s) in errors.iter_mut().zip(found) {
            errors.push((h, (s - exact).abs()));
        }
        let [a, b, c, d] = found.map(|s| format!("{s:.10}"));
        rows.push([h.to_string(), a, b, c, d]);
    }
    println!("{}", table(["h", "RK4", "Gauss<2>", "DiscreteGradient", "FourthOrder of it"], &rows));
    let [rk4, gauss, second, fourth] = &errors;
    claim("steps that keep both integrals end at the right number, steps of 8 days too", {
        largest(second.iter().chain(fourth).map(|error| error.1)) < 1e-12
    })?;
    let [explicit, implicit] = [rk4, gauss].map(|errors| order(errors[4].1, errors[5].1));
    claim(&format!("other methods do to their order ({explicit:.2}, {implicit:.2})"), {
        (explicit - 4.0).abs() < 0.3 && (implicit - 4.0).abs() < 0.3
    })?;
    claim("steps of 16 days, in which the infected grow tenfold, are refused by the one of order 2", {
        matches!(end(DiscreteGradient, ratio, 16.0), Err(StepError { t: 0.0, failure: Failure::Singular, .. }))
    })?;
    let ratios = [1.5, 2.5, 4.0];
    claim("that holds for other diseases", {
        let mut differences = vec![];
        for ratio in ratios {
            differences.push(end(DiscreteGradient, ratio, 4.0)? - never_infected(ratio));
        }
        largest(differences) < 1e-11
    })?;

    let days = 140.0;
    let fine = orbit(disease(ratio), FourthOrder(DiscreteGradient), 0.5, FlowState::new(START), days)?;
    let coarse = orbit(disease(ratio), FourthOrder(DiscreteGradient), 7.0, FlowState::new(START), days)?;
    let part = |states: &[Parts], i: usize| states.iter().map(|state| (state.t, state.x[i])).collect();
    let mut course = vec![];
    for (i, (name, ink)) in
        [("susceptible", palette::BLUE), ("infected", palette::VERMILION), ("recovered", palette::GREEN)]
            .into_iter()
            .enumerate()
    {
        course.push(Curve::line(name, ink, part(&fine, i)));
        course.push(Curve::dots("", ink, part(&coarse, i)).marked(3.0));
    }
    let mut plane = vec![];
    for (ratio, ink) in ratios.into_iter().zip([palette::GREEN, palette::BLUE, palette::VERMILION]) {
        let states = orbit(disease(ratio), DiscreteGradient, 2.0, FlowState::new(START), DAYS)?;
        let points = states.iter().map(|state| (state.x[0], state.x[1])).collect();
        plane.push(Curve::line(format!("R₀ = {ratio}"), ink, points));
        plane.push(Curve::dots("", ink, vec![(never_infected(ratio), 0.0)]).marked(4.0));
    }
    let names = ["RK4", "Gauss<2>", "DiscreteGradient", "FourthOrder(DiscreteGradient)"];
    let inks = [palette::VERMILION, palette::ORANGE, palette::GREEN, palette::BLUE];
    let curves = errors.iter().zip(names).zip(inks).map(|((errors, name), ink)| {
        let points: Vec<_> = errors.iter().rev().map(|(h, error)| (*h, error.max(1e-16))).collect();
        let curve = Curve::line(name, ink, points).marked(3.0);
        if name.starts_with(['D', 'F']) { curve.rounding() } else { curve }
    });
    figure(
        "epidemic.svg",
        (4, 3),
        &[
            Panel::new(
                "An epidemic, R₀ = 2.5",
                "FourthOrder(DiscreteGradient), h = 0.5 days; markers: h = 7 days",
                [Axis::linear("days", 0.0..days), Axis::linear("part of all people", 0.0..1.0)],
                course,
            ),
            Panel::new(
                "End of an epidemic",
                "DiscreteGradient, h = 2 days; markers: solution of the equation for s∞",
                [Axis::linear("susceptible (part of all)", 0.0..1.0), Axis::linear("infected (part of all)", 0.0..0.5)],
                plane,
            ),
            Panel::new(
                "Error of the part never infected",
                "after 960 days, R₀ = 2.5; smaller errors are drawn at 10⁻¹⁶",
                [Axis::decades("h (days)", -0.7..1.0), Axis::decades("|s − s∞| (part of all)", -16.5..0.0)],
                curves.collect(),
            ),
        ],
    )
}
