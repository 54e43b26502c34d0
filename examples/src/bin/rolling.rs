//! Does a disk roll down its slope, and a ball off its table? Both roll without slip.
//!
//! A vertical disk that also turns about its vertical axis drifts across a slope and not down it. A ball on a table that turns with Ω runs in circles with
//! 2Ω/7. The table does work, so the energy changes, and another function is constant.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, order, table};
use geoint_runtime::prelude::*;
use std::error::Error;

/// A disk of radius r on a slope: x downhill is −x, then y, the roll and the heading.
#[lagrangian(rolling = [v[0] - r * v[2] * q[3].cos(), v[1] - r * v[2] * q[3].sin()])]
fn disk(q: [f64; 4], v: [f64; 4], m: f64, r: f64, i: f64, j: f64, g: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * v[2] * v[2] / 2.0 + j * v[3] * v[3] / 2.0 + m * g * q[0]
}

/// A ball of radius r: its centre, and three angles whose rates are its angular velocity. Its attitude matters to nothing.
#[lagrangian(rolling = [v[0] - r * v[3] + omega * q[1], v[1] + r * v[2] - omega * q[0]])]
fn ball(q: [f64; 5], v: [f64; 5], m: f64, r: f64, omega: f64) -> f64 {
    let i = 0.4 * m * r * r;
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * (v[2] * v[2] + v[3] * v[3] + v[4] * v[4]) / 2.0
}

const DISK: Disk = Disk { m: 1.2, r: 0.5, i: 0.2, j: 0.1, g: 3.0 };
const BALL: Ball = Ball { m: 1.0, r: 0.3, omega: 1.5 };
const HEADING: f64 = 0.4;
const TURNING: f64 = 0.7;
const ROLLING: f64 = 1.1;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Disk::<f64>::REPORT);
    println!("{}", Ball::<f64>::REPORT);
    let disk = disk_states(0.05, 36.0)?;
    let ball = ball_states(0.05, 30.0)?;
    let across = |h: f64| -> Result<f64, StepError> {
        let states = disk_states(h, 8.0)?;
        Ok(states.last().map_or(f64::NAN, |end| (end.q[1] - disk_way(8.0)[1]).abs()))
    };
    let energy = largest(disk.iter().map(|state| (DISK.energy(state) - DISK.energy(&disk[0])).abs()));
    let law = largest(ball.iter().map(|state| (constant(state) - constant(&ball[0])).abs()));
    let work = largest(ball.iter().map(|state| (BALL.energy(state) - BALL.energy(&ball[0])).abs()));
    let lowest = disk.iter().fold(0.0, |far, state| f64::max(far, state.q[0]));
    let circle = largest(ball.iter().map(|state| (radius(state) / radius(&ball[0]) - 1.0).abs()));
    let rows = [
        ["disk: change of the energy".into(), format!("{energy:.1e}")],
        ["disk: farthest way downhill in 36 s".into(), format!("{lowest:.2}")],
        ["ball: change of the energy".into(), format!("{work:.2}")],
        ["ball: change of E − Ω(x p_y − y p_x + p_z)".into(), format!("{law:.1e}")],
        ["ball: change of the radius".into(), format!("{circle:.1e}")],
    ];
    println!("{}", table(["", "DiscreteGradient, h = 0.05 s"], &rows));

    claim("the disk keeps its energy to 1e-12", energy < 1e-12)?;
    claim("the disk comes back up: it goes downhill by less than 2.5", lowest < 2.5)?;
    claim("its way has order 2", (order(across(0.1)?, across(0.05)?) - 2.0).abs() < 0.1)?;
    claim("the table does work on the ball", work > 0.01)?;
    claim("the law of the table holds to 1e-13", law < 1e-13)?;
    claim("the ball runs in a circle to 1e-3", circle < 1e-3)?;
    println!();
    draw(&disk, &ball)
}

fn disk_states(h: f64, time: f64) -> Result<Vec<State<[f64; 4]>>, StepError> {
    let speed = DISK.r * ROLLING;
    let start = DISK.at([0.0, 0.0, 0.0, HEADING], [speed * HEADING.cos(), speed * HEADING.sin(), ROLLING, TURNING]);
    let mut sim = DISK.integrator(DiscreteGradient, h, start);
    let mut states = vec![sim.state()];
    for _ in 0..(time / h).round() as u32 {
        sim.step()?;
        states.push(sim.state());
    }
    Ok(states)
}

fn ball_states(h: f64, time: f64) -> Result<Vec<State<[f64; 5]>>, StepError> {
    let ([x, y], [u, w]) = ([0.5, 0.2], [0.3, -0.1]);
    let spin = [(BALL.omega * x - w) / BALL.r, (u + BALL.omega * y) / BALL.r];
    let start = BALL.at([x, y, 0.0, 0.0, 0.0], [u, w, spin[0], spin[1], 0.4]);
    let mut sim = BALL.integrator(DiscreteGradient, h, start);
    let mut states = vec![sim.state()];
    for _ in 0..(time / h).round() as u32 {
        sim.step()?;
        states.push(sim.state());
    }
    Ok(states)
}

/// The way of the disk: φ' = A + B sin θ with θ = θ₀ + ωt, x' = rφ' cos θ, y' = rφ' sin θ.
fn disk_way(t: f64) -> [f64; 2] {
    let Disk { m, r, i, g, .. } = DISK;
    let b = m * g * r / (i + m * r * r) / TURNING;
    let a = ROLLING - b * HEADING.sin();
    let x = |th: f64| r / TURNING * (a * th.sin() + b * th.sin().powi(2) / 2.0);
    let y = |th: f64| r / TURNING * (-a * th.cos() + b * (th / 2.0 - (2.0 * th).sin() / 4.0));
    let angle = HEADING + TURNING * t;
    [x(angle) - x(HEADING), y(angle) - y(HEADING)]
}

/// The function that the ball keeps in place of its energy.
fn constant(state: &State<[f64; 5]>) -> f64 {
    let State { q, p, .. } = state;
    BALL.energy(state) - BALL.omega * (q[0] * p[1] - q[1] * p[0] + p[4])
}

/// The distance of the ball from the point about which it turns with 2Ω/7.
fn radius(State { q, .. }: &State<[f64; 5]>) -> f64 {
    let rate = 2.0 * BALL.omega / 7.0;
    let centre = [0.5 + 0.1 / rate, 0.2 + 0.3 / rate];
    (q[0] - centre[0]).hypot(q[1] - centre[1])
}

fn draw(disk: &[State<[f64; 4]>], ball: &[State<[f64; 5]>]) -> Result<(), Box<dyn Error>> {
    let way = |t: f64| (disk_way(t)[1], -disk_way(t)[0]);
    let curves = vec![
        Curve::line("closed form", palette::BLACK, (0..=720).map(|k| way(0.05 * f64::from(k))).collect()),
        Curve::dots("DiscreteGradient", palette::BLUE, disk.iter().step_by(8).map(|s| (s.q[1], -s.q[0])).collect()),
    ];
    let slope = Panel::new(
        "A disk on a slope",
        "h = 0.05 s, for 36 s",
        [Axis::linear("across the slope in m", 0.0..45.0), Axis::linear("uphill in m", -3.0..1.0)],
        curves,
    );
    let paths = vec![
        Curve::line("centre of the ball", palette::VERMILION, ball.iter().map(|s| (s.q[0], s.q[1])).collect()).solid(),
        Curve::dots("", palette::VERMILION, vec![(ball[0].q[0], ball[0].q[1])]),
    ];
    let table = Panel::new(
        "A ball on a table that turns",
        "h = 0.05 s, for 30 s; the table turns about (0, 0) with 1.5 rad/s",
        [Axis::linear("x in m", -0.6..2.0), Axis::linear("y in m", -0.4..2.2)],
        paths,
    )
    .equal();
    figure("rolling.svg", (4, 3), &[slope, table])
}
