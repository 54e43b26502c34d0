//! Do steps of 0.2 show the motion of a spring and of a pendulum?
//!
//! Explicit Euler and leapfrog cost one force a step. Explicit Euler multiplies the energy of the spring by 1 + h² in each step, and drives the
//! pendulum over its top. Leapfrog moves the spring on the ellipse p² + (1 − h²/4)q² = const, and stays close to the true curve of the
//! pendulum for any time.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, Separable};
use std::error::Error;
use std::f64::consts::PI;

/// A mass on a spring, in units of the mass and of the stiffness.
#[hamiltonian]
fn spring(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0
}

/// A pendulum of unit length, in units of its mass and of gravity; q is the angle from below.
#[hamiltonian]
fn pendulum(q: f64, p: f64) -> f64 {
    p * p / 2.0 - q.cos()
}

const H: f64 = 0.2;
const DURATION: f64 = 20.0;

/// States after 0, 1, 2, … steps from q = 1 at rest.
type Orbit = Vec<State<f64>>;

fn run<S, M>(system: S, method: M, h: f64, duration: f64) -> Result<Orbit, StepError>
where
    S: Hamiltonian<Coordinates = f64>,
    M: Method<S>,
{
    orbit(system, method, h, State::new(1.0, 0.0), duration)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("From q = 1 at rest to t = {DURATION}, steps of {H}\n");
    let [springs, pendulums] = [both(Spring)?, both(Pendulum)?];
    let row = |name: &str, [euler, leapfrog]: &[Orbit; 2], energy: fn(&State<f64>) -> f64| {
        let change = |orbit: &Orbit| largest(orbit.iter().map(|x| energy(x) - energy(&orbit[0])));
        [name.into(), format!("{:.1e}", change(euler)), format!("{:.1e}", change(leapfrog))]
    };
    let rows = [row("spring", &springs, |x| Spring.energy(x)), row("pendulum", &pendulums, |x| Pendulum.energy(x))];
    println!("{}", table(["largest change of the energy", "ExplicitEuler", "StormerVerlet"], &rows));

    let last = Spring.energy(&springs[0][100]) / 0.5;
    claim("explicit Euler multiplies the energy of the spring by 1.04 in each step: by 50.5 in a hundred", {
        (last / 1.04_f64.powi(100) - 1.0).abs() < 1e-13
    })?;
    let ellipse = |x: &State<f64>| x.p * x.p + (1.0 - H * H / 4.0) * x.q * x.q - (1.0 - H * H / 4.0);
    let long = run(Spring, StormerVerlet, H, 20_000.0)?;
    claim("leapfrog keeps p² + 0.99 q² of the spring to rounding for 100 000 steps", {
        largest(long.iter().map(ellipse)) < 1e-11
    })?;
    let over = pendulums[0].iter().position(|x| x.q.abs() > PI);
    claim("explicit Euler carries the pendulum over its top after 86 steps", over == Some(86))?;
    let long = run(Pendulum, StormerVerlet, H, 20_000.0)?;
    let changes = long.iter().map(|x| Pendulum.energy(x) + 1.0_f64.cos());
    let (least, most) = changes.fold((0.0_f64, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
    claim(&format!("leapfrog's energy of the pendulum is too low by at most {:.5}, and never too high", -least), {
        (least + 0.00425).abs() < 1e-5 && most < 1e-11
    })?;
    let error = |orbit: &Orbit| largest(orbit.iter().map(|x| x.q - x.t.cos()));
    let orders = [
        order(
            error(&run(Spring, ExplicitEuler, 0.001, DURATION)?),
            error(&run(Spring, ExplicitEuler, 0.0005, DURATION)?),
        ),
        order(error(&run(Spring, StormerVerlet, 0.2, DURATION)?), error(&run(Spring, StormerVerlet, 0.1, DURATION)?)),
    ];
    claim(&format!("explicit Euler is of order 1, leapfrog of order 2 ({:.2}, {:.2})", orders[0], orders[1]), {
        (orders[0] - 1.0).abs() < 0.02 && (orders[1] - 2.0).abs() < 0.02
    })?;
    println!();
    let spring = panel("Spring", &springs, |q| 1.0 - q * q);
    let pendulum = panel("Pendulum", &pendulums, |q| 2.0 * (q.cos() - 1.0_f64.cos()));
    figure("explicit_against_leapfrog.svg", (4, 3), &[spring, pendulum])
}

/// Runs explicit Euler, then leapfrog.
fn both<S: Hamiltonian<Coordinates = f64> + Separable>(system: S) -> Result<[Orbit; 2], StepError> {
    Ok([run(system, ExplicitEuler, H, DURATION)?, run(system, StormerVerlet, H, DURATION)?])
}

/// Draws both orbits and the true curve p² = `square`(q).
fn panel(name: &str, [euler, leapfrog]: &[Orbit; 2], square: fn(f64) -> f64) -> Panel {
    // The spiral ends where it leaves the panel.
    let points =
        |orbit: &Orbit| orbit.iter().map(|x| (x.q, x.p)).take_while(|x| x.0.abs() < 4.0 && x.1.abs() < 3.0).collect();
    let curve = (0..=400).map(|i| PI * f64::from(i) / 200.0).map(|angle: f64| {
        let q = angle.cos();
        (q, square(q).max(0.0).sqrt().copysign(angle.sin()))
    });
    let curves = vec![
        Curve::line("exact", palette::GREY, curve.collect()),
        Curve::line("explicit Euler", palette::VERMILION, points(euler)).width(0.8).solid().marked(2.0),
        Curve::dots("leapfrog", palette::BLUE, points(leapfrog)).marked(2.0),
    ];
    let axes = [Axis::linear("q", -4.0..4.0), Axis::linear("p", -3.0..3.0)];
    Panel::new(format!("{name}, h = {H}"), "100 steps from (1, 0); dimensionless", axes, curves).equal()
}
