//! Does a chain with a weak nonlinearity return to its first wave?
//!
//! Fermi, Pasta, Ulam and Tsingou expected that the energy of one wave would spread over all waves. After 157 periods nearly all of it is back
//! (E. Fermi, J. Pasta & S. Ulam, Los Alamos report LA-1940 (1955), figure 1: 32 springs, α = 1/4). The linear part of the springs couples all
//! masses and is solved exactly, as A of A + B. Far fewer steps are then enough. For few masses this also saves time.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;
use std::f64::consts::PI;
use std::time::Instant;

/// Masses between two walls.
const MASSES: usize = 31;

/// Springs with the force d + αd².
#[hamiltonian(const MASSES = 31)]
fn chain(q: [f64; MASSES], p: [f64; MASSES], alpha: f64) -> f64 {
    let (first, last) = (q[0], -q[MASSES - 1]);
    let mut energy = (first * first + last * last) / 2.0 + alpha * (first.powi(3) + last.powi(3)) / 3.0;
    for i in 0..MASSES {
        energy += p[i] * p[i] / 2.0;
    }
    for i in 1..MASSES {
        let d = q[i] - q[i - 1];
        energy += d * d / 2.0 + alpha * d.powi(3) / 3.0;
    }
    energy
}

type Shape = State<[f64; MASSES]>;

const SYSTEM: Chain = Chain { alpha: 0.25 };
const DURATION: f64 = 11_000.0;

/// Returns the chain at rest in the shape of the first wave with the given amplitude.
fn plucked(amplitude: f64) -> Shape {
    Shape::new(std::array::from_fn(|i| amplitude * (PI * (i + 1) as f64 / 32.0).sin()), [0.0; MASSES])
}

/// The energy of the k-th wave of the chain without α.
fn wave(state: &Shape, k: usize) -> f64 {
    let shape = |i: usize| (2.0_f64 / 32.0).sqrt() * (PI * (k * (i + 1)) as f64 / 32.0).sin();
    let along = |x: &[f64; MASSES]| x.iter().enumerate().map(|(i, x)| x * shape(i)).sum::<f64>();
    let frequency = 2.0 * (PI * k as f64 / 64.0).sin();
    (along(&state.p).powi(2) + (frequency * along(&state.q)).powi(2)) / 2.0
}

fn end<M: Method<Chain, f64>>(method: M, steps: u64, start: Shape) -> Result<Shape, StepError> {
    let mut sim = SYSTEM.integrator(method, DURATION / steps as f64, start);
    sim.advance(steps)?;
    Ok(sim.state())
}

/// The distance of two states, relative to the second.
fn distance(a: &Shape, b: &Shape) -> f64 {
    let both = |x: &Shape| x.q.into_iter().chain(x.p).collect::<Vec<_>>();
    let norm = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (a, b) = (both(a), both(b));
    norm(&a.iter().zip(&b).map(|(a, b)| a - b).collect::<Vec<_>>()) / norm(&b)
}

/// Steps, time in ms and error of a run.
fn run<M: Method<Chain, f64>>(method: M, steps: u64, start: Shape, truth: &Shape) -> Result<[f64; 3], StepError> {
    let begin = Instant::now();
    let state = end(method, steps, start)?;
    Ok([steps as f64, begin.elapsed().as_secs_f64() * 1e3, distance(&state, truth)])
}

fn main() -> Result<(), Box<dyn Error>> {
    // At a small amplitude the chain is 31 coupled linear oscillators with a very small perturbation.
    let start = plucked(0.01);
    let truth = end(BceRkn17_8, 60_000, start)?;
    let mut rows = vec![];
    let mut errors = vec![];
    macro_rules! row {
        ($name:literal, $method:expr, $steps:expr) => {{
            let [steps, time, error] = run($method, $steps, start, &truth)?;
            rows.push([$name.into(), format!("{steps}"), format!("{time:.0} ms"), format!("{error:.1e}")]);
            errors.push(error);
        }};
    }
    row!("StormerVerlet", StormerVerlet, 120_000);
    row!("BlanesMoanSrkn14a", BlanesMoanSrkn14a, 7_000);
    row!("WisdomHolmanGradient", WisdomHolmanGradient, 12_000);
    row!("Saba5Gradient", Saba5Gradient, 2_000);
    row!("Rnia10_8_6", Rnia10_8_6, 1_000);
    println!("171 periods of the first wave, plucked by 0.01\n");
    println!("{}", table(["method", "steps", "time", "error at the end"], &rows));
    // Each flow of A multiplies the state by a 62 × 62 matrix. This saves time only for few masses, for example eight.
    claim("with the springs solved exactly, steps seven times as long have the smaller error", errors[4] < errors[1])?;

    let start = plucked(1.0);
    let (whole, energy) = (wave(&start, 1), SYSTEM.energy(&start));
    let mut sim = SYSTEM.integrator(Perturbation(BlanesMoanSrkn14a), 1.0, start);
    let (mut shares, mut worst): (Vec<Vec<(f64, f64)>>, f64) = (vec![vec![]; 4], 0.0);
    for state in sim.sampled(20).take((DURATION / 20.0) as usize) {
        let state = state?;
        worst = worst.max((SYSTEM.energy(&state) / energy - 1.0).abs());
        for (k, share) in shares.iter_mut().enumerate() {
            share.push((state.t / 1000.0, wave(&state, k + 1) / whole));
        }
    }
    let of_first = |times: std::ops::Range<f64>| {
        shares[0].iter().filter(move |share| times.contains(&share.0)).map(|share| share.1)
    };
    let (least, back) = (of_first(0.0..8.0).fold(1.0, f64::min), of_first(9.0..11.0).fold(0.0, f64::max));
    println!(
        "energy of the first wave: 1 at the start, minimum {least:.3}, {back:.3} after its return; error of H {worst:.1e}"
    );
    claim("the energy leaves the first wave and comes back", least < 0.1 && back > 0.95)?;
    claim("H is kept to 1e-6", worst < 1e-6)?;
    let inks: [Ink; 4] = [palette::BLUE, palette::VERMILION, palette::GREEN, palette::PURPLE];
    let curves = shares.into_iter().zip(inks).enumerate();
    let curves =
        curves.map(|(k, (share, ink))| Curve::line(format!("wave {}", k + 1), ink, share).width(1.2)).collect();
    figure(
        "fput.svg",
        (3, 2),
        &[Panel::new(
            "Recurrence in a chain",
            "31 masses, α = 1/4, Perturbation(BlanesMoanSrkn14a), h = 1; unit masses and springs",
            [
                Axis::linear("time / 1000", 0.0..11.0),
                Axis::linear("energy of a wave / energy of the first wave at the start", 0.0..1.05),
            ],
            curves,
        )],
    )
}
