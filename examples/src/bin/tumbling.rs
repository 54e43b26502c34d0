//! Why does a body that turns about its middle axis tumble, and when?
//!
//! In free fall a body that is spun about the axis of its middle moment of inertia turns over, again and again (V. Dzhanibekov saw a wing nut
//! do so in orbit). The attitude is a unit quaternion, and the angular momentum is in the frame of the body. Without torques a step is the
//! exact motion at any length. The time between two turns is half of the period 4K(k)/λ of Jacobi's functions.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, table};
use geoint_runtime::methods::*;
use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;

/// `r` turns vectors of the body into those of space, `m` is the angular momentum in the body; `weight` pulls at the point c.
#[hamiltonian(attitude = r)]
fn satellite(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], weight: f64, c: Vector3<f64>) -> f64 {
    let spin = m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2];
    spin / 2.0 + weight * (r * c).z
}

type Attitude = BodyState<UnitQuaternion<f64>>;

/// A box of 12 kg with edges of 1.6, 1 and 0.4 m.
const EDGES: [f64; 3] = [1.6, 1.0, 0.4];
const INERTIA: [f64; 3] = [1.0 * 1.0 + 0.4 * 0.4, 1.6 * 1.6 + 0.4 * 0.4, 1.6 * 1.6 + 1.0 * 1.0];
const FREE: Satellite = Satellite { inertia: INERTIA, weight: 0.0, c: Vector3::new(0.0, 0.0, 0.0) };
const STEP: f64 = 0.1;
const TIME: f64 = 60.0;

/// Returns a state with this angular velocity in the body. The angular momentum points up in space.
fn spun(velocity: [f64; 3]) -> Attitude {
    let momentum = Vector3::from(velocity).component_mul(&Vector3::from(INERTIA));
    let up = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).unwrap_or_default();
    BodyState::new(up, momentum)
}

/// Starts with a spin that deviates from the middle axis by a thousandth.
fn start() -> Attitude {
    spun([0.0, 1.2, 0.0012])
}

/// Returns the period 4K(k)/λ of the angular momentum in the body. The arithmetic-geometric mean gives K.
fn period(state: &Attitude) -> f64 {
    let square = state.m.norm_squared();
    let [a, b, c] = INERTIA;
    let twice = 2.0 * FREE.energy(state);
    // The angular momentum circles the axis of the smallest or the largest moment of inertia.
    let (a, c) = if square > twice * b { (a, c) } else { (c, a) };
    let rate = ((c - b) * (square - twice * a) / (a * b * c)).sqrt();
    let modulus = (b - a) * (twice * c - square) / ((c - b) * (square - twice * a));
    let (mut x, mut y) = (1.0, (1.0 - modulus).sqrt());
    for _ in 0..10 {
        (x, y) = (0.5 * (x + y), (x * y).sqrt());
    }
    2.0 * std::f64::consts::PI / (x * rate)
}

/// Cosine of the angle between an axis and the momentum.
fn cosine(state: &Attitude, axis: usize) -> f64 {
    state.m[axis] / state.m.norm()
}

/// Returns the angle between two attitudes, in rad.
fn apart(a: &Attitude, b: &Attitude) -> f64 {
    a.r.angle_to(&b.r)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Satellite::REPORT);
    let period = period(&start());
    println!("the satellite turns over every {:.6} s\n", period / 2.0);

    let exact = orbit(FREE, StormerVerlet, STEP, start(), TIME)?;
    let mut rows = vec![];
    let mut row = |name: &str, states: &[Attitude]| {
        let angle = largest(states.iter().zip(&exact).map(|(a, b)| apart(a, b)));
        let energy = largest(states.iter().map(|x| FREE.energy(x) / FREE.energy(&start()) - 1.0));
        let momentum = largest(states.iter().map(|x| (x.r * x.m).metric_distance(&(start().r * start().m))));
        rows.push([name.into(), format!("{angle:.1e}"), format!("{energy:.1e}"), format!("{momentum:.1e}")]);
        [angle, energy, momentum]
    };
    let rotations = orbit(FREE, FiveRotations, STEP, start(), TIME)?;
    let drift = row("exact drift", &exact);
    let five = row("FiveRotations", &rotations);
    let runge_kutta = row("RK4", &orbit(FREE, RK4, STEP, start(), TIME)?);
    println!(
        "steps of {STEP} s up to {TIME} s: largest angle to the exact attitude (rad), relative change of the energy, of"
    );
    println!("the angular momentum in space (kg m²/s)\n");
    println!("{}", table(["", "attitude", "energy", "momentum"], &rows));
    claim("the drift keeps energy and momentum to rounding", largest([drift[1], drift[2]]) < 1e-12)?;
    claim("rotations keep the momentum, RK4 neither", {
        five[2] < 1e-12 && five[1] > 1e-6 && runge_kutta[1].min(runge_kutta[2]) > 1e-8
    })?;

    let step = |h: f64| step(StormerVerlet, h, start());
    claim("one step of a whole period brings the momentum back, to 1e-11", {
        let back = step(period)?;
        (back.m - start().m).amax() < 1e-11
    })?;
    claim("and one of half a period turns the satellite over", {
        let over = step(period / 2.0)?;
        (cosine(&over, 1) + cosine(&start(), 1)).abs() < 1e-12
    })?;
    claim("steps of 7 s end where steps of 0.1 s do, to 1e-9 rad", {
        let long = orbit(FREE, StormerVerlet, 7.0, start(), 56.0)?;
        largest(long.iter().enumerate().map(|(n, x)| apart(x, &exact[70 * n]))) < 1e-9
    })?;

    let curve =
        |states: &[Attitude], axis| -> Vec<(f64, f64)> { states.iter().map(|x| (x.t, cosine(x, axis))).collect() };
    let of = |axis: usize| {
        let velocity = std::array::from_fn(|i| if i == axis { 1.2 } else { 0.2 });
        orbit(FREE, StormerVerlet, STEP, spun(velocity), TIME).map(|states| curve(&states, axis))
    };
    let (long_edge, short_edge) = (of(0)?, of(2)?);
    let long = orbit(FREE, StormerVerlet, 4.0, start(), TIME)?;
    claim("about the axes of the smallest and the largest moment it only wobbles", {
        long_edge.iter().chain(&short_edge).all(|point| point.1 > 0.8)
    })?;
    let turns = Panel::new(
        "The middle axis turns over, the other axes stay",
        format!(
            "exact drift, h = {STEP} s, markers h = 4 s; spun with 1.2 rad/s about an axis, 0.2 about the others (middle: 0.0012)"
        ),
        [Axis::linear("time (s)", 0.0..TIME), Axis::linear("cosine of the axis and the momentum", -1.1..1.1)],
        vec![
            Curve::line("middle axis", palette::BLUE, curve(&exact, 1)),
            Curve::dots("", palette::BLUE, curve(&long, 1)).marked(3.4),
            Curve::line("long edge", palette::VERMILION, long_edge),
            Curve::line("short edge", palette::GREEN, short_edge),
        ],
    );
    figure("tumbling.svg", (1, 1), &[pictures(&exact), turns])
}

fn step<M: Method<Satellite>>(method: M, h: f64, state: Attitude) -> Result<Attitude, StepError> {
    let mut sim = Integrator::new(FREE, method, h, state);
    sim.step()?;
    Ok(sim.state())
}

const COLUMNS: usize = 5;
const ROWS: usize = 5;

/// Draws the box once a second, seen from the side and slightly from above. Rows run from bottom to top.
fn pictures(exact: &[Attitude]) -> Panel {
    let view = Vector3::new(0.0, -1.0, 0.45).normalize();
    let (right, up) = (Vector3::x(), view.cross(&Vector3::x()));
    let (width, height) = (COLUMNS as f64, (COLUMNS * ROWS) as f64);
    let mut black = vec![];
    let mut crosses = [vec![], vec![]];
    for (k, state) in exact.iter().step_by((1.0 / STEP).round() as usize).take(COLUMNS * ROWS).enumerate() {
        let (column, row) = (k % COLUMNS, k - k % COLUMNS);
        // One metre is 0.42 columns. The factor height/width gives both directions the same scale.
        let place = |corner: Vector3<f64>| {
            let seen = state.r * corner * 0.42;
            (column as f64 + seen.dot(&right), row as f64 + seen.dot(&up) * height / width)
        };
        for axis in 0..3 {
            for side in [-1.0, 1.0] {
                let mut normal = Vector3::zeros();
                normal[axis] = side;
                if (state.r * normal).dot(&view) <= 0.0 {
                    continue;
                }
                let corner = |i: f64, j: f64| {
                    let mut corner = normal;
                    (corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (i, j);
                    place(corner.component_mul(&(Vector3::from(EDGES) / 2.0)))
                };
                let face = [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
                black.push(face.map(|(i, j)| corner(i, j)).to_vec());
                if axis == 1 {
                    let cross = &mut crosses[usize::from(side > 0.0)];
                    cross.push(vec![corner(1.0, 1.0), corner(-1.0, -1.0)]);
                    cross.push(vec![corner(1.0, -1.0), corner(-1.0, 1.0)]);
                }
            }
        }
    }
    let group = |name: &'static str, ink, lines: Vec<Vec<(f64, f64)>>| {
        let line = move |(i, line)| Curve::line(if i == 0 { name } else { "" }, ink, line).solid().width(1.2);
        lines.into_iter().enumerate().map(line).collect::<Vec<_>>()
    };
    let [below, above] = crosses;
    let mut curves = group("the box", palette::BLACK, black);
    curves.extend(group("face at the front of the middle axis", palette::VERMILION, above));
    curves.extend(group("face at its back", palette::BLUE, below));
    let half = COLUMNS as f64 / 2.0;
    Panel::new(
        "A tumbling box, second by second",
        "exact drift, h = 0.1 s; the angular momentum points up; edges of 1.6, 1 and 0.4 m",
        [
            Axis::linear("seconds from the left", -0.5..width - 0.5),
            Axis::linear("seconds at the left (s)", -half..height - half),
        ],
        curves,
    )
}
