//! Do steps keep the law of the angular momentum of an orbit with friction?
//!
//! Two bodies have friction that changes its sign, H = |p|²/2 − 1/|q| + α sin(Ωt) s, as in A. Bravetti et al., Celest. Mech. Dyn. Astr. 132
//! (2020) 7. The flow obeys L = L₀ exp(−α∫sin Ωt dt). A step of the splitting multiplies L by exp(−hα sin Ωt) at the middle of the step, to
//! rounding, even if the orbit has a large error.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;
use std::f64::consts::PI;

/// Two bodies; q is the vector between them.
#[contact_hamiltonian]
fn perturbed_kepler(q: [f64; 2], p: [f64; 2], s: f64, t: f64, alpha: f64, omega: f64) -> f64 {
    let r = (q[0] * q[0] + q[1] * q[1]).sqrt();
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / r + alpha * (omega * t).sin() * s
}

type Body = ContactState<[f64; 2]>;

const SYSTEM: PerturbedKepler = PerturbedKepler { alpha: -0.07, omega: 2.0 * PI };
const STEP_SIZES: [f64; 4] = [0.1, 0.05, 0.025, 0.0125];
const DURATION: f64 = 10.0;

/// Returns the state in the pericentre of an ellipse with the semi-major axis 1.
fn pericentre(e: f64) -> Body {
    ContactState::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()], 0.0)
}

fn distance(a: &Body, b: &Body) -> f64 {
    largest([a.q[0] - b.q[0], a.q[1] - b.q[1], a.p[0] - b.p[0], a.p[1] - b.p[1], a.s - b.s])
}

fn angular_momentum(x: &Body) -> f64 {
    x.q[0] * x.p[1] - x.q[1] * x.p[0]
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", PerturbedKepler::REPORT);
    let truth = after(SofroniouSpaletta10_35.of(ContactSplitting), 0.01)?;
    let runs = [
        errors(ContactLeapfrog, &truth)?,
        errors(ContactSplitting, &truth)?,
        errors(Yoshida4.of(ContactSplitting), &truth)?,
        errors(Suzuki4.of(ContactSplitting), &truth)?,
        errors(Yoshida6a.of(ContactSplitting), &truth)?,
        errors(BlanesMoan4, &truth)?,
        errors(BlanesMoan6, &truth)?,
    ];
    let rows = runs.each_ref().map(|(name, errors, _)| {
        let [a, b, c, d] = errors.map(|x| format!("{x:.2e}"));
        [name.clone(), a, b, c, d, format!("{:.2}", order(errors[1], errors[2]))]
    });
    println!("largest error of (q, p, s) at t = {DURATION}, eccentricity 0.4\n");
    println!("{}", table(["method", "h = 0.1", "0.05", "0.025", "0.0125", "order"], &rows));
    claim("all have their orders", {
        runs.iter().all(|(_, errors, claimed)| (order(errors[1], errors[2]) - claimed).abs() < 0.35)
    })?;

    let h = 0.05;
    let states = orbit(SYSTEM, ContactSplitting, h, pericentre(0.4), 2000.0 * h)?;
    let mut exponent = 0.0;
    let defects = states.windows(2).map(|pair| {
        exponent -= h * SYSTEM.alpha * (SYSTEM.omega * (pair[0].t + h / 2.0)).sin();
        angular_momentum(&pair[1]) / angular_momentum(&states[0]) / f64::exp(exponent) - 1.0
    });
    let defects: Vec<f64> = defects.collect();
    let worst = largest(defects.iter().copied());
    claim(&format!("2000 steps keep the law of L to {worst:.1e}"), worst < 2e-14)?;

    let accuracy = runs.iter().zip(palette::ALL).map(|((name, errors, _), colour)| {
        Curve::line(name.clone(), colour, STEP_SIZES.into_iter().zip(*errors).rev().collect()).marked(3.0)
    });
    let accuracy = Panel::new(
        "Two bodies with friction: error at t = 10",
        "largest entry of the error of (q, p, s); G M = 1, unit axis",
        [Axis::decades("step size h", -2.0..-1.0), Axis::decades("largest error", -12.0..0.0)],
        accuracy.collect(),
    );
    let path = |states: &[Body]| states.iter().map(|x| (x.q[0], x.q[1])).collect::<Vec<_>>();
    let smooth = orbit(SYSTEM, Yoshida6a.of(ContactSplitting), 0.01, pericentre(0.4), 40.0)?;
    let coarse = orbit(SYSTEM, ContactSplitting, 0.2, pericentre(0.4), 40.0)?;
    let orbits = vec![
        Curve::line("Yoshida6a of ContactSplitting, h = 0.01", palette::BLUE, path(&smooth)).width(0.8),
        Curve::dots("ContactSplitting, h = 0.2", palette::VERMILION, path(&coarse)).marked(2.6).open(),
    ];
    let orbits = Panel::new(
        "Two bodies with friction of changing sign",
        "up to t = 40; G M = 1, unit axis",
        [Axis::linear("x", -1.7..1.0), Axis::linear("y", -1.4..1.4)],
        orbits,
    );
    let law = |t: f64| SYSTEM.alpha / SYSTEM.omega * ((SYSTEM.omega * t).cos() - 1.0);
    let start = angular_momentum(&states[0]);
    let law = (0..=400).map(|n| 0.01 * f64::from(n)).map(|t| (t, start * law(t).exp())).collect();
    let steps = states.iter().take_while(|x| x.t <= 4.0).map(|x| (x.t, angular_momentum(x))).collect();
    let momentum = vec![
        Curve::line("exact law", palette::GREY, law),
        Curve::dots("ContactSplitting, h = 0.05", palette::VERMILION, steps).open(),
    ];
    let momentum = Panel::new(
        "Angular momentum under friction",
        "friction α sin Ωt, α = −0.07, Ω = 2π; G M = 1, unit axis",
        [Axis::linear("time", 0.0..4.0), Axis::linear("L", 0.91..0.945)],
        momentum,
    );
    figure("perturbed_kepler.svg", (5, 4), &[orbits.equal(), momentum, accuracy])
}

fn after<M: Method<PerturbedKepler, f64>>(method: M, h: f64) -> Result<Body, StepError> {
    let mut sim = SYSTEM.integrator(method, h, pericentre(0.4));
    sim.advance((DURATION / h).round() as u64)?;
    Ok(sim.state())
}

fn errors<M: Method<PerturbedKepler, f64>>(method: M, truth: &Body) -> Result<(String, [f64; 4], f64), StepError> {
    let mut errors = [0.0; 4];
    for (error, h) in errors.iter_mut().zip(STEP_SIZES) {
        *error = distance(&after(method, h)?, truth);
    }
    Ok((method.name().to_string(), errors, f64::from(method.claims().order)))
}
