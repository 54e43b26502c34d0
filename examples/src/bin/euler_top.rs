//! On which path does the angular momentum of a free body move, and do steps stay on it?
//!
//! In the frame of the body Euler's equations keep the energy and the length of the angular momentum m. Therefore m moves along a polhode, the
//! intersection of an ellipsoid and a sphere. The program has three forms of the problem: a field with both integrals, a Poisson system in m,
//! and the attitude of the body. The Poisson system splits into rotations. The free motion of the attitude is exact at any step size. A
//! fourth form keeps a quartic integral, a Lyapunov function.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{changes, claim, largest, order, shortest, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;
use geoint_runtime::system::FirstIntegrals;
use std::error::Error;

/// x is the angular velocity in the frame of the body, in rad/s; a, b, c are the moments of inertia, in kg m².
#[vector_field(keeps(
    energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
    momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
))]
fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// Euler's equations with one integral of degree 4. Its minimum is the rotation (w, 0, 0) if a is the smallest moment of inertia.
#[vector_field(keeps(lyapunov = {
    let first = a * (c - a) * (x[0] * x[0] - w * w) + b * (c - b) * x[1] * x[1];
    let second = b * (b - a) * x[1] * x[1] + c * (c - a) * x[2] * x[2];
    first * first + second
}))]
fn lyapunov_top(x: [f64; 3], a: f64, b: f64, c: f64, w: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// Euler's equations as S(x) ∇H in the angular velocity x. S splits the flow into rotations in planes.
#[hamiltonian(structure = |i, j| {
    let k = 3 - i - j;
    (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
})]
fn planes(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| inertia[i] * x[i] * x[i] / 2.0).sum()
}

/// Euler's equations in the angular momentum x.
#[hamiltonian(structure = so3)]
fn momenta(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| x[i] * x[i] / (2.0 * inertia[i])).sum()
}

/// The attitude of the same body.
#[hamiltonian(attitude = r)]
fn body(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], weight: f64) -> f64 {
    (0..3).map(|i| m[i] * m[i] / (2.0 * inertia[i])).sum::<f64>() + weight * r.w
}

const INERTIA: [f64; 3] = [1.0, 2.0, 3.0];
const TOP: EulerTop = EulerTop { a: 1.0, b: 2.0, c: 3.0 };
const START: [f64; 3] = [0.5, 0.8, -0.4];
const TIME: f64 = 1000.0;

fn momentum(velocity: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| INERTIA[i] * velocity[i])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", EulerTop::REPORT);
    let free = Body { inertia: INERTIA, weight: 0.0 };
    let start = BodyState::new(UnitQuaternion::identity(), Vector3::from(momentum(START)));
    let mut exact = free.integrator(StormerVerlet, 1.0, start);
    exact.advance(TIME as u64)?;
    let end: [f64; 3] = exact.state().m.into();

    let (velocity, m) = (FlowState::new(START), FlowState::new(momentum(START)));
    let of_velocity = |x: &[f64; 3]| momentum(*x);
    let rows = [
        measured(TOP, RK4, velocity, end, of_velocity)?,
        measured(TOP, Projection(RK4, Integrals), velocity, end, of_velocity)?,
        measured(TOP, DiscreteGradient, velocity, end, of_velocity)?,
        measured(TOP, FourthOrder(DiscreteGradient), velocity, end, of_velocity)?,
        measured(Planes { inertia: INERTIA }, Suzuki4.of(PlanarSplitting), velocity, end, of_velocity)?,
        measured(Momenta { inertia: INERTIA }, Suzuki4.of(PoissonSplitting), m, end, |x| *x)?,
        measured(TOP, DOP853, velocity, end, of_velocity)?,
    ];
    println!("steps of {STEP} s: error of the angular momentum after {TIME} s, largest relative changes, cost\n");
    let head = ["method", "error", "energy", "momentum", "ns a step"];
    println!("{}", table(head, &rows.each_ref().map(Measured::row)));
    let [rk4, projected, second, fourth, planar, poisson, _] = &rows;
    claim("methods that are given both integrals keep both", {
        [projected, second, fourth].iter().all(|row| largest(row.changes) < 1e-13)
    })?;
    claim("planes keep the energy, rotations of the momentum its length", {
        planar.changes[0] < 1e-13 && poisson.changes[1] < 1e-13 && planar.changes[1] > 1e-8 && poisson.changes[0] > 1e-9
    })?;
    claim("RK4 keeps neither, and of the methods of order 4 it errs most", {
        rk4.changes.iter().all(|change| *change > 1e-6)
            && [projected, fourth, planar, poisson].iter().all(|row| row.error() < rk4.error())
    })?;
    let orders = rows.each_ref().map(|row| order(row.errors[4].1, row.errors[5].1));
    claim(&format!("orders are those that the methods claim ({:.2}, {:.2})", orders[2], orders[3]), {
        (orders[2] - 2.0).abs() < 0.05 && (orders[3] - 4.0).abs() < 0.05
    })?;

    let near = FlowState::new([0.5, 1e-2, -1e-2]);
    let lyapunov = LyapunovTop { a: 1.0, b: 2.0, c: 3.0, w: 0.5 };
    let mut sim = lyapunov.integrator(FourthOrder(DiscreteGradient), 0.3, near);
    let kept = changes(&mut sim, 300_000, |x| [lyapunov.lyapunov(x), x.x[0] - 0.5, x.x[1], x.x[2]])?;
    let [quartic, along, across, other] = kept[kept.len() - 1].1;
    claim("the quartic integral alone is kept to 1e-16, and holds the body at its rotation for 300 000 steps", {
        quartic < 1e-16 && along < 1e-3 && across < 0.04 && other < 0.04
    })?;
    figure("euler_top.svg", (5, 4), &[polhodes()?, errors(&rows)])
}

const STEP: f64 = 0.1;

/// Errors and cost of one method.
struct Measured {
    name: String,
    /// Step sizes 0.8, 0.4, … s, each with the error of the angular momentum.
    errors: Vec<(f64, f64)>,
    /// Largest relative changes of energy and momentum at steps of [`STEP`].
    changes: [f64; 2],
    nanoseconds: f64,
}

impl Measured {
    fn error(&self) -> f64 {
        self.errors.iter().find(|error| error.0 == STEP).map_or(f64::NAN, |error| error.1)
    }

    fn row(&self) -> [String; 5] {
        let [energy, momentum] = self.changes.map(|change| format!("{change:.1e}"));
        [self.name.clone(), format!("{:.1e}", self.error()), energy, momentum, format!("{:.0}", self.nanoseconds)]
    }
}

fn measured<S, M>(
    system: S,
    method: M,
    start: FlowState<[f64; 3]>,
    end: [f64; 3],
    momentum: impl Fn(&[f64; 3]) -> [f64; 3],
) -> Result<Measured, StepError>
where
    S: FirstIntegrals<State = FlowState<[f64; 3]>, Phase = [f64; 3]>,
    M: Method<S>,
{
    let run = |h: f64| {
        let mut sim = Integrator::new(system, method, h, start);
        sim.advance((TIME / h).round() as u64)?;
        let m = momentum(&sim.state().x);
        Ok(largest((0..3).map(|i| m[i] - end[i])))
    };
    let mut errors = vec![];
    for h in [0.8, 0.4, 0.2, 0.1, 0.05, 0.025] {
        errors.push((h, run(h)?));
    }
    let mut sim = Integrator::new(system, method, STEP, start);
    let integrals = |x: &FlowState<[f64; 3]>| {
        let m = momentum(&x.x);
        let squares = m.map(|m| m * m);
        [(0..3).map(|i| squares[i] / (2.0 * INERTIA[i])).sum::<f64>(), squares.iter().sum::<f64>() / 2.0]
    };
    let before = integrals(&start);
    let kept = changes(&mut sim, (TIME / STEP) as u64, integrals)?;
    let kept = kept[kept.len() - 1].1;
    let nanoseconds = shortest(|| run(STEP))?.as_secs_f64() * 1e9 * STEP / TIME;
    let changes = [kept[0] / before[0], kept[1] / before[1]];
    Ok(Measured { name: method.name().to_string(), errors, changes, nanoseconds })
}

fn errors(rows: &[Measured; 7]) -> Panel {
    let curve = |(row, ink): (&Measured, Ink)| {
        // Leave out the smallest errors, because accumulated rounding dominates them.
        let points = row.errors.iter().rev().copied().filter(|error| error.1 > 1e-10).collect();
        Curve::line(row.name.clone(), ink, points).marked(3.0)
    };
    let inks = [
        palette::VERMILION,
        palette::ORANGE,
        palette::BLUE,
        palette::GREEN,
        palette::SKY,
        palette::PURPLE,
        palette::BLACK,
    ];
    Panel::new(
        "Free body: error after 1000 s",
        "68 periods, compared with the exact motion of a free body; |m| = 1 kg m²/s",
        [Axis::decades("step (s)", -1.7..0.0), Axis::decades("error of the angular momentum", -10.5..1.0)],
        rows.iter().zip(inks).map(curve).collect(),
    )
}

/// Draws the polhodes on the sphere |m| = 1 kg m²/s, seen from between the axes.
fn polhodes() -> Result<Panel, Box<dyn Error>> {
    let view = Vector3::new(0.6, 1.0, 0.45).normalize();
    let right = Vector3::new(0.0, 0.0, 1.0).cross(&view).normalize();
    let up = view.cross(&right);
    let seen = |m: &Vector3<f64>| (m.dot(&right), m.dot(&up));

    let angle = |i: i32| f64::from(i) / 180.0 * std::f64::consts::PI;
    let rim = (0..=180).map(|i| (angle(2 * i).cos(), angle(2 * i).sin())).collect();
    let mut curves = vec![Curve::line("", palette::GREY, rim).width(1.0)];
    let groups = [
        ("about the axis of 1 kg m²", palette::BLUE, &[15, 30, 45][..]),
        ("beside the axis of 2 kg m²", palette::VERMILION, &[59, 61]),
        ("about the axis of 3 kg m²", palette::GREEN, &[67, 74, 82]),
    ];
    for (name, ink, angles) in groups {
        let mut name = name;
        for (i, sign) in angles.iter().flat_map(|i| [(*i, 1.0), (*i, -1.0)]) {
            // Start on the great circle through the first and the third axis. The separatrix crosses it at 60°.
            let (x, z) = (angle(i).cos(), angle(i).sin());
            let m = if i < 60 { [sign * x, 0.0, z] } else { [x, 0.0, sign * z] };
            let path = path(m)?;
            for part in path.chunk_by(|a, b| (a.dot(&view) > 0.0) == (b.dot(&view) > 0.0)) {
                let visible = part[0].dot(&view) > 0.0;
                let curve = Curve::line(if visible { name } else { "" }, ink, part.iter().map(seen).collect());
                name = if visible { "" } else { name };
                curves.push(if visible { curve } else { curve.width(0.4) });
            }
        }
    }
    Ok(Panel::new(
        "Polhodes: paths of the angular momentum",
        "FourthOrder(DiscreteGradient), h = 0.1 s; |m| = 1 kg m²/s; thin lines lie behind",
        [Axis::linear("across (kg m²/s)", -1.05..1.05), Axis::linear("up (kg m²/s)", -1.05..1.05)],
        curves,
    )
    .equal())
}

/// Returns the angular momentum over one period, from a point in the plane of the first and the third axis.
fn path(m: [f64; 3]) -> Result<Vec<Vector3<f64>>, StepError> {
    let start = FlowState::new(std::array::from_fn(|i| m[i] / INERTIA[i]));
    let mut sim = TOP.integrator(FourthOrder(DiscreteGradient), 0.1, start);
    let mut path = vec![Vector3::from(m)];
    // One period has two passages through the plane. The third closes the curve.
    let mut passages = 0;
    while passages < 3 {
        let before = sim.state().x[1];
        sim.step()?;
        path.push(Vector3::from(momentum(sim.state().x)));
        passages += usize::from(before == 0.0 || before * sim.state().x[1] < 0.0);
    }
    Ok(path)
}
