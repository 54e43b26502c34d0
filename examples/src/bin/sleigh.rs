//! Why does a sleigh turn round? A blade lets it slide along its heading and not across.
//!
//! Chaplygin's sleigh rests on a blade behind its centre of mass. Pushed backwards it is unstable: over all time it turns by π√(1 + I/(ma²)), and it ends
//! forwards with all its energy in this motion. Running forwards it contracts volume in phase space, so a method that keeps volume cannot follow it.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, order, table};
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::PI;

/// Centre of mass and heading; `a` is the distance from the blade to the centre of mass, and `i` the moment of inertia about it.
#[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin() - a * v[2]])]
fn sleigh(q: [f64; 3], v: [f64; 3], m: f64, i: f64, a: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * v[2] * v[2] / 2.0
}

const SLEIGH: Sleigh = Sleigh { m: 1.3, i: 0.4, a: 0.5 };
const H: f64 = 0.1;
/// Speed along the blade in m/s, rate of turning in rad/s, and heading in rad at the start.
const SPEED: f64 = -0.6;
const TURNING: f64 = 0.9;
const HEADING: f64 = 0.2;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Sleigh::<f64>::REPORT);
    let path = run(H, 20.0)?;
    let (first, last) = (&path[0], &path[path.len() - 1]);
    let whole_turn = PI * (1.0 + SLEIGH.i / (SLEIGH.m * SLEIGH.a * SLEIGH.a)).sqrt();
    let turned =
        run(H, 100.0)?.last().map_or(0.0, |end| end.heading) - run(H, -100.0)?.last().map_or(0.0, |end| end.heading);
    let error = |h: f64| -> Result<f64, StepError> { Ok((speed_at(h)? - exact_speed(6.0)).abs()) };
    let kept = largest(path.iter().map(|e| (e.energy - first.energy).abs()));
    let rows = [
        ["speed along the blade at the start, m/s".into(), format!("{:.4}", first.speed)],
        ["the same after 20 s".into(), format!("{:.4}", last.speed)],
        ["turn from t = −100 to 100, rad".into(), format!("{turned:.6}")],
        ["π√(1 + I/(ma²))".into(), format!("{whole_turn:.6}")],
        ["largest change of the energy".into(), format!("{kept:.1e}")],
        ["largest speed across the blade".into(), format!("{:.1e}", largest(path.iter().map(|e| e.across.abs())))],
    ];
    println!("{}", table(["", "DiscreteGradient, h = 0.1 s"], &rows));

    let ends_as_known = (last.speed - exact_speed(last.t)).abs() < 1e-4;
    claim("it starts backwards and ends forwards, as the closed form says", first.speed < 0.0 && ends_as_known)?;
    claim("its whole turn is π√(1 + I/(ma²)) to 1e-2", (turned.abs() - whole_turn).abs() < 1e-2)?;
    claim("the energy is kept to 1e-13", kept < 1e-13)?;
    claim("the blade does not slip: 1e-14", largest(path.iter().map(|e| e.across.abs())) < 1e-14)?;
    claim("the method has order 2", (order(error(0.1)?, error(0.05)?) - 2.0).abs() < 0.1)?;
    println!();
    draw(&path)
}

/// A state in terms of the blade.
struct Sample {
    t: f64,
    contact: (f64, f64),
    heading: f64,
    speed: f64,
    /// Speed across the blade at the point of contact.
    across: f64,
    energy: f64,
}

/// Runs from the start until `time`, which may be negative.
fn run(h: f64, time: f64) -> Result<Vec<Sample>, StepError> {
    let (sin, cos) = HEADING.sin_cos();
    let across = SLEIGH.a * TURNING; // of the centre of mass
    let velocity = [SPEED * cos - across * sin, SPEED * sin + across * cos, TURNING];
    let start = SLEIGH.at([SLEIGH.a * cos, SLEIGH.a * sin, HEADING], velocity);
    let mut sim = SLEIGH.integrator(DiscreteGradient, h.copysign(time), start);
    let mut samples = vec![];
    for _ in 0..=(time.abs() / h).round() as u32 {
        let (State { t, q, .. }, v) = (sim.state(), sim.velocity());
        let (sin, cos) = q[2].sin_cos();
        samples.push(Sample {
            t,
            contact: (q[0] - SLEIGH.a * cos, q[1] - SLEIGH.a * sin),
            heading: q[2],
            speed: v[0] * cos + v[1] * sin,
            across: v[1] * cos - v[0] * sin - SLEIGH.a * v[2],
            energy: sim.energy(),
        });
        sim.step()?;
    }
    Ok(samples)
}

/// The speed along the blade at 6 s.
fn speed_at(h: f64) -> Result<f64, StepError> {
    Ok(run(h, 6.0)?.last().map_or(f64::NAN, |end| end.speed))
}

/// The exact speed along the blade: V tanh(k(t − t₀)) with mV² = mv₀² + Jω₀², J = I + ma² and k = maV/J. It is v₀ at t = 0.
fn exact_speed(t: f64) -> f64 {
    let Sleigh { m, i, a } = SLEIGH;
    let inertia = i + m * a * a;
    let fastest = (SPEED * SPEED + inertia * TURNING * TURNING / m).sqrt();
    let k = m * a * fastest / inertia;
    fastest * (k * t + (SPEED / fastest).atanh()).tanh()
}

fn draw(path: &[Sample]) -> Result<(), Box<dyn Error>> {
    let first = &path[..100.min(path.len())];
    let mut curves = vec![Curve::line("blade", palette::BLUE, first.iter().map(|e| e.contact).collect()).solid()];
    let bodies = first.iter().step_by(10).map(|e| {
        let (x, y) = e.contact;
        vec![(x, y), (x + e.heading.cos(), y + e.heading.sin())]
    });
    curves.extend(bodies.enumerate().map(|(k, body)| {
        Curve::line(if k == 0 { "sleigh, each second" } else { "" }, palette::VERMILION, body).width(1.2).solid()
    }));
    let way = Panel::new(
        "A sleigh that is pushed backwards",
        "DiscreteGradient, h = 0.1 s, for 10 s",
        [Axis::linear("x in m", -8.0..2.0), Axis::linear("y in m", -4.5..3.0)],
        curves,
    )
    .equal();
    let speeds = vec![
        Curve::line(
            "closed form",
            palette::BLACK,
            (0..=400).map(|k| 0.05 * f64::from(k)).map(|t| (t, exact_speed(t))).collect(),
        ),
        Curve::dots("DiscreteGradient", palette::BLUE, path.iter().step_by(4).map(|e| (e.t, e.speed)).collect()),
    ];
    let speed = Panel::new(
        "Sleigh: speed along the blade",
        "h = 0.1 s; nonholonomic RATTLE, which keeps volume, ends at −0.90 m/s",
        [Axis::linear("time in s", 0.0..20.0), Axis::linear("speed in m/s", -1.2..1.2)],
        speeds,
    );
    figure("sleigh.svg", (4, 3), &[way, speed])
}
