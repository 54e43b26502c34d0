//! Why does a weight that bounces on a spring begin to swing?
//!
//! In polar coordinates H = (p_r² + p_θ²/r²)/2m + k (r − l)²/2 − m g r cos θ couples r and p_θ. It is still a sum of three pieces with exact
//! flows. In Cartesian coordinates H is T + V. If bouncing is twice as fast as swinging, k = 3 m g/l, each motion turns into the other
//! (A. Vitt & G. Gorelik 1933; P. Lynch, Int. J. Nonlin. Mech. 37 (2002) 345).

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;

/// (r, θ) from the point of suspension, θ from below.
#[hamiltonian]
fn polar(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
    let [r, angle] = q;
    (p[0] * p[0] + p[1] * p[1] / (r * r)) / (2.0 * m) + k * (r - l).powi(2) / 2.0 - m * g * r * angle.cos()
}

/// (x, y), y upward.
#[hamiltonian]
fn cartesian(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
    let r = (q[0] * q[0] + q[1] * q[1]).sqrt();
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * (r - l).powi(2) / 2.0 + m * g * q[1]
}

type Plane = State<[f64; 2]>;

/// kg, N/m, m, m/s². The length at rest is l + m g/k = 1 m.
const M: f64 = 0.8;
const K: f64 = 4.0 * M * G;
const L: f64 = 0.75;
const G: f64 = 9.81;
const POLAR: Polar = Polar { m: M, k: K, l: L, g: G };
const CARTESIAN: Cartesian = Cartesian { m: M, k: K, l: L, g: G };

/// Returns the start at rest: pulled down by 12 cm, with an angle of 0.005 rad.
fn start() -> Plane {
    State::new([1.12, 0.005], [0.0, 0.0])
}

fn to_cartesian(state: &Plane) -> Plane {
    let ([r, angle], [radial, turning]) = (state.q, state.p);
    let (sin, cos) = angle.sin_cos();
    let across = turning / r;
    State::at(state.t, [r * sin, -r * cos], [radial * sin + across * cos, across * sin - radial * cos])
}

/// Returns the energy of swinging: the kinetic energy of the angle, and the potential energy at the length of rest.
fn swing(state: &Plane) -> f64 {
    let [r, angle] = state.q;
    state.p[1].powi(2) / (2.0 * M * r * r) + M * G * (1.0 - angle.cos())
}

fn end<S, T: Method<S, f64>>(system: S, method: T, steps: u32, from: Plane) -> Result<Plane, StepError>
where
    S: geoint_runtime::PhaseSpace<State = Plane> + Copy,
{
    let mut sim = Integrator::new(system, method, DURATION / f64::from(steps), from);
    sim.advance(u64::from(steps))?;
    Ok(sim.state())
}

const DURATION: f64 = 20.0;

fn distance(a: &Plane, b: &Plane) -> f64 {
    largest((0..2).flat_map(|i| [a.q[i] - b.q[i], a.p[i] - b.p[i]]))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Polar::REPORT);
    let truth = end(CARTESIAN, BceRkn17_8, 8000, to_cartesian(&start()))?;
    let steps = [250, 500, 1000];
    let row = |name: &str, errors: [f64; 3]| {
        let [a, b, c] = errors.map(|error| format!("{error:.1e}"));
        [name.to_string(), a, b, c, format!("{:.1}", order(errors[1], errors[2]))]
    };
    let mut rows = vec![];
    let mut errors = vec![];
    macro_rules! polar {
        ($name:literal, $method:expr) => {{
            let mut found = [0.0; 3];
            for (error, steps) in found.iter_mut().zip(steps) {
                *error = distance(&to_cartesian(&end(POLAR, $method, steps, start())?), &truth);
            }
            rows.push(row($name, found));
            errors.push(found);
        }};
    }
    polar!("PieceSplitting, polar", PieceSplitting);
    polar!("BlanesMoan4X of it, polar", BlanesMoan4X.of(PieceSplitting));
    polar!("BlanesMoan6X of it, polar", BlanesMoan6X.of(PieceSplitting));
    let mut found = [0.0; 3];
    for (error, steps) in found.iter_mut().zip(steps) {
        *error = distance(&end(CARTESIAN, BlanesMoanSrkn14a, steps, to_cartesian(&start()))?, &truth);
    }
    rows.push(row("BlanesMoanSrkn14a, Cartesian", found));
    println!("largest error of (q, p) in Cartesian coordinates at t = {DURATION} s\n");
    println!("{}", table(["method", "250 steps", "500", "1000", "order"], &rows));
    claim("pieces have their orders", {
        [2.0, 4.0, 6.0].iter().zip(&errors).all(|(claimed, errors)| (order(errors[1], errors[2]) - claimed).abs() < 0.5)
    })?;

    let states = orbit(POLAR, BlanesMoan6X.of(PieceSplitting), 0.02, start(), 60.0)?;
    let rest = POLAR.energy(&State::new([1.0, 0.0], [0.0, 0.0]));
    let whole = POLAR.energy(&start()) - rest;
    let shares: Vec<(f64, f64)> = states.iter().map(|state| (state.t, swing(state) / whole)).collect();
    let most = shares.iter().map(|share| share.1).fold(0.0, f64::max);
    let late = shares.iter().filter(|share| share.0 > 5.0).map(|share| share.1).fold(f64::INFINITY, f64::min);
    println!("largest share of the energy in swinging: {most:.2}");
    claim("nearly all of the energy goes to swinging, and comes back", most > 0.8 && late < 0.02)?;
    let lengths = states.iter().map(|state| (state.t, state.q[0])).collect();
    let path = states.iter().map(to_cartesian).map(|state| (state.q[0], state.q[1])).collect();
    figure(
        "swinging_spring.svg",
        (4, 3),
        &[
            Panel::new(
                "A weight on a spring",
                "BlanesMoan6X of pieces, h = 0.02 s, for 60 s from 12 cm below rest",
                [Axis::linear("x in m", -0.45..0.45), Axis::linear("y in m", -1.2..-0.75)],
                vec![Curve::line("weight", palette::BLUE, path).width(0.6)],
            ),
            Panel::new(
                "Bouncing: length of the spring",
                "BlanesMoan6X of pieces, h = 0.02 s",
                [Axis::linear("time in s", 0.0..60.0), Axis::linear("length of the spring in m", 0.85..1.15)],
                vec![Curve::line("spring", palette::VERMILION, lengths).width(0.7).solid()],
            ),
            Panel::new(
                "Swinging: part of the energy",
                "BlanesMoan6X of pieces, h = 0.02 s; the rest is bouncing",
                [Axis::linear("time in s", 0.0..60.0), Axis::linear("part of the energy", 0.0..1.05)],
                vec![Curve::line("swinging", palette::BLUE, shares).width(0.7)],
            ),
        ],
    )
}
