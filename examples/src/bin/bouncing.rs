//! How does a ball come to rest, impact by impact?
//!
//! At each impact the ball loses a part of its speed. Between impacts it falls freely. The impact is an event: it ends a step, and the
//! program changes the state there. A Taylor series finds the impact as the zero of a polynomial; a splitting finds it by
//! shorter steps from the start of the last one.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::prelude::*;
use std::error::Error;

/// A ball above the ground; q in m, p in kg m/s.
#[hamiltonian]
fn ball(q: f64, p: f64, m: f64, g: f64) -> f64 {
    p * p / (2.0 * m) + m * g * q
}

const BALL: Ball = Ball { m: 0.16, g: 9.81 };
const START: State<f64> = State { t: 0.0, q: 2.0, p: 0.0 };
/// Coefficient of restitution: the speed after an impact over the speed before it.
const RESTITUTION: f64 = 0.85;
const IMPACTS: usize = 12;
/// Shortest flight in s. A ball whose next flight is shorter counts as at rest; otherwise it has infinitely many impacts in a finite time.
const SHORTEST: f64 = 1e-3;

/// Times of impacts, each with the energy after the impact.
type Impacts = Vec<(f64, f64)>;

/// Returns the state after an impact that multiplies the speed by `restitution`.
fn reflected(impact: State<f64>, restitution: f64) -> State<f64> {
    State { q: 0.0, p: -restitution * impact.p, ..impact }
}

fn by_series() -> Result<Impacts, StepError> {
    let mut sim = BALL.taylor(Taylor::default(), START);
    let mut impacts = vec![];
    while impacts.len() < IMPACTS {
        let Some(impact) = sim.until_event(100.0, Direction::Down, |state| state.q)? else { break };
        sim.set_state(reflected(impact.state, RESTITUTION));
        impacts.push((sim.time(), sim.energy()));
    }
    Ok(impacts)
}

fn by_steps(h: f64) -> Result<Impacts, StepError> {
    let mut sim = BALL.integrator(StormerVerlet, h, START);
    let mut impacts = vec![];
    while impacts.len() < IMPACTS {
        let Some(impact) = sim.until_event(100.0, Direction::Down, |state| state.q)? else { break };
        sim.set_state(reflected(impact.state, RESTITUTION));
        impacts.push((sim.time(), sim.energy()));
    }
    Ok(impacts)
}

/// Computes the impacts in closed form: the durations of the flights are a geometric sequence.
fn exact() -> Impacts {
    let fall = (2.0 * START.q / BALL.g).sqrt();
    let mut t = fall;
    (0..IMPACTS)
        .map(|n| {
            let speed = RESTITUTION.powi(n as i32 + 1);
            let impact = (t, BALL.energy(&START) * speed * speed);
            t += 2.0 * fall * speed;
            impact
        })
        .collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let (series, steps, exact) = (by_series()?, by_steps(0.01)?, exact());
    let row = |n: &usize| {
        let (t, energy) = exact[*n];
        let [a, b] = [&series, &steps].map(|found| format!("{:.1e}", (found[*n].0 - t).abs()));
        [format!("{}", n + 1), format!("{t:.6} s"), format!("{energy:.6} J"), a, b]
    };
    let head = ["impact", "time", "energy left", "series: error of the time", "steps of 0.01 s"];
    println!("{}", table(head, &[0, 1, 2, 5, 8, 11].iter().map(row).collect::<Vec<_>>()));
    let error = |found: &Impacts, of: fn(&(f64, f64)) -> f64| {
        found.iter().zip(&exact).map(|(a, b)| (of(a) / of(b) - 1.0).abs()).fold(0.0, f64::max)
    };
    claim("both find twelve impacts", series.len() == IMPACTS && steps.len() == IMPACTS)?;
    claim("times are right to 10⁻¹⁴ by series, and energies to 10⁻¹³", {
        error(&series, |impact| impact.0) < 1e-14 && error(&series, |impact| impact.1) < 1e-13
    })?;
    claim("Störmer–Verlet is exact for free fall, and its times of impact are right to 10⁻¹³", {
        error(&steps, |impact| impact.0) < 1e-13
    })?;
    draw()
}

/// Samples heights and energies up to the time `end`, in flight and on the ground.
fn curves(restitution: f64, end: f64) -> Result<[Vec<(f64, f64)>; 2], StepError> {
    let mut sim = BALL.taylor(Taylor::default(), START);
    let (mut heights, mut energies, mut lies) = (vec![], vec![], false);
    let dt = 0.01;
    for n in 0..(end / dt) as u32 {
        let t = dt * f64::from(n);
        while sim.time() < t && !lies {
            if let Some(impact) = sim.until_event(t, Direction::Down, |state| state.q)? {
                let flies = reflected(impact.state, restitution);
                lies = 2.0 * flies.p < SHORTEST * BALL.m * BALL.g;
                sim.set_state(flies);
            }
        }
        let (height, energy) = if lies { (0.0, 0.0) } else { (sim.state().q, sim.energy()) };
        heights.push((t, height));
        energies.push((t, energy));
    }
    Ok([heights, energies])
}

fn draw() -> Result<(), Box<dyn Error>> {
    let [heights, energies] = curves(RESTITUTION, 7.0)?;
    let note = "Taylor series; an impact keeps 0.85 of the speed";
    let panels = [
        Panel::new(
            "A ball comes to rest",
            note,
            [Axis::linear("time in s", 0.0..7.0), Axis::linear("height in m", 0.0..2.2)],
            vec![Curve::line("height", palette::BLUE, heights)],
        ),
        Panel::new(
            "Energy of the ball, impact by impact",
            note,
            [Axis::linear("time in s", 0.0..7.0), Axis::linear("energy in J", 0.0..3.4)],
            vec![Curve::line("energy", palette::VERMILION, energies)],
        ),
    ];
    figure("bouncing.svg", (3, 2), &panels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Flights end after fall·(1 + e)/(1 − e), with e the coefficient of restitution. Here this time lies within the figure.
    #[test]
    fn a_ball_that_loses_more_comes_to_rest() -> Result<(), StepError> {
        let fall = (2.0 * START.q / BALL.g).sqrt();
        for restitution in [0.0, 0.3, 0.6] {
            let end = fall * (1.0 + restitution) / (1.0 - restitution);
            let [heights, energies] = curves(restitution, 7.0)?;
            assert_eq!((heights.len(), energies.len()), (700, 700));
            assert!(heights.iter().all(|(t, height)| *height >= -1e-12 && (*t < end + 0.01 || *height == 0.0)));
            assert!(energies.is_sorted_by(|before, after| after.1 < before.1 + 1e-12));
        }
        Ok(())
    }
}
