//! Bodies in close encounters.

use super::{Job, Part, Row, Section, all, row, short};
use crate::run::{Outcome, adapting, fixed};
use crate::systems::comet;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, TaylorIntegrator};
use geoint_tests::problems::{Kepler, ThreeBodies};
use nalgebra::Vector3;

type Plane = State<[f64; 2]>;
type Space = State<[Vector3<f64>; 3]>;

/// Bounds that a run must fulfil.
#[derive(Clone, Copy)]
struct Bounds {
    energy: f64,
    /// True if the run may be refused before its end.
    refusal: bool,
}

const ORBITS: f64 = 100.0;
const TOLERANCE: f64 = 1e-12;

/// Returns the row of an orbit: energy, angular momentum, and the distance from its start.
fn orbit(name: String, eccentricity: f64, outcome: &Outcome<Plane>, bounds: Bounds) -> Row {
    let (Kepler { mu, .. }, start, _) = comet(eccentricity);
    let momentum = |x: &Plane| x.q[0] * x.p[1] - x.q[1] * x.p[0];
    let (energy, at) = (outcome.energy / (0.5 * mu), &outcome.state);
    let turned = (momentum(at) / momentum(&start) - 1.0).abs();
    let away = (at.q[0] - start.q[0]).hypot(at.q[1] - start.q[1]);
    let cells = vec![
        name,
        eccentricity.to_string(),
        short(energy),
        short(turned),
        short(away),
        outcome.steps.to_string(),
        outcome.end(),
    ];
    row(cells, energy <= bounds.energy && (bounds.refusal || outcome.refused.is_none()))
}

fn fixed_orbit<M: Method<Kepler> + Send + 'static>(
    name: &str,
    method: M,
    eccentricity: f64,
    steps: f64,
    energy: f64,
) -> Job {
    let name = format!("{name}, {steps:.0} a period");
    Box::new(move || {
        let (system, start, period) = comet(eccentricity);
        let run = system.integrator(method, period / steps, start);
        let outcome = fixed(run, (ORBITS * steps) as u64, ORBITS as u32, |_| ());
        orbit(name, eccentricity, &outcome, Bounds { energy, refusal: true })
    })
}

fn adaptive_orbit<M: Method<Kepler> + Send + 'static>(
    name: &str,
    method: M,
    eccentricity: f64,
    tolerance: f64,
    energy: f64,
) -> Job {
    let name = format!("adaptive({name}), {tolerance:.0e}");
    Box::new(move || {
        let (system, start, period) = comet(eccentricity);
        let outcome = adapting(system.adaptive(method, tolerance, start), ORBITS * period, ORBITS as u32, |_| ());
        orbit(name, eccentricity, &outcome, Bounds { energy, refusal: false })
    })
}

/// An orbit whose pericentre is at 1/100 or 1/10 000 of its semi-major axis.
pub(super) fn kepler() -> Section {
    let mut jobs: Vec<Job> = vec![];
    macro_rules! rows {
        ($how:ident $e:ident, $number:expr, $bound:expr; $($method:expr),*) => {
            $( jobs.push($how(stringify!($method), $method, $e, $number, $bound)); )*
        };
    }
    for e in [0.99, 0.9999] {
        // In each passage the energy changes by v·δp, with the tolerated δp relative to p. The product v·p is 2μ/r.
        rows!(adaptive_orbit e, TOLERANCE, ORBITS * TOLERANCE * 4.0 / (1.0 - e); DOP853, Gauss::<4>);
        rows!(adaptive_orbit e, 1e-6, 1e-10; DiscreteGradient, FourthOrder(DiscreteGradient));
        jobs.push(Box::new(move || {
            let (system, start, period) = comet(e);
            let run = TaylorIntegrator::new(system, Taylor::default(), start);
            let outcome = adapting(run, ORBITS * period, ORBITS as u32, |_| ());
            orbit("Taylor".into(), e, &outcome, Bounds { energy: 1e-10, refusal: false })
        }));
        for steps in [1e3, 1e5] {
            rows!(fixed_orbit e, steps, f64::INFINITY; StormerVerlet, BlanesMoanSrkn14a, Gauss::<3>);
            rows!(fixed_orbit e, steps, 1e-10; DiscreteGradient, FourthOrder(DiscreteGradient));
        }
    }
    Section {
        title: "Close encounters: Kepler",
        text: "100 periods from the apocentre. Bounds: 4e-10/(1 − e) for adaptive DOP853 and Gauss, 1e-10 for Taylor series and discrete gradients. \
               Other fixed steps promise nothing. With 1000 steps a period, only DiscreteGradient reaches the end with its energy.",
        head: &["method", "e", "energy", "angular momentum", "distance", "steps", "end"],
        part: Part::Pivot {
            row: 0,
            by: 1,
            cells: &["0.99", "0.9999"],
            value: 2,
            chosen: |cells| !cells[0].ends_with(", 1000 a period"),
        },
        jobs,
    }
}

fn bodies_row(name: String, outcome: &Outcome<Space>, scale: f64, told: String, holds: bool) -> Row {
    let cells = vec![
        name,
        short(outcome.energy / scale),
        short(angular_momentum(&outcome.state).abs()),
        outcome.steps.to_string(),
        told,
        outcome.end(),
    ];
    row(cells, holds && outcome.refused.is_none())
}

/// Returns the smallest distance between two bodies.
fn nearest(state: &Space) -> f64 {
    let [a, b, c] = state.q;
    (a - b).norm().min((b - c).norm()).min((c - a).norm())
}

fn eights(name: String, run: impl FnOnce(&mut dyn FnMut(&Space)) -> Outcome<Space>) -> Row {
    let (mut near, mut far) = (f64::INFINITY, 0.0_f64);
    let outcome = run(&mut |state: &Space| {
        near = near.min(nearest(state));
        far = state.q.iter().fold(far, |far, q| far.max(q.norm()));
    });
    let (system, start, _) = eight();
    let scale = energy(&system, &start).abs();
    let holds = outcome.energy <= 1e-10 * scale && near > 0.5 && far < 1.2;
    bodies_row(format!("eight: {name}"), &outcome, scale, format!("bodies {near:.2} to {far:.2}"), holds)
}

fn energy(system: &ThreeBodies, start: &Space) -> f64 {
    system.integrator(StormerVerlet, 1.0, *start).energy()
}

fn triangles(name: String, outcome: &Outcome<Space>, bound: f64) -> Row {
    let (system, start) = pythagorean();
    let (State { q, p, .. }, m) = (&outcome.state, system.m);
    // Bodies 1 and 2 alone form the pair.
    let v = p[1] / m[1] - p[2] / m[2];
    let reduced = m[1] * m[2] / (m[1] + m[2]);
    let bound_energy = 0.5 * reduced * v.norm_squared() - m[1] * m[2] / (q[1] - q[2]).norm();
    let axis = -m[1] * m[2] / (2.0 * bound_energy);
    let (distance, away) = (q[0].norm(), q[0].dot(&p[0]) > 0.0);
    let scale = energy(&system, &start).abs();
    let told = format!("body of mass 3 at {distance:.1}, pair with axis {axis:.4}");
    let holds = outcome.energy <= bound * scale && away && distance > 10.0 && axis > 0.0 && axis < 2.0;
    bodies_row(format!("Pythagorean: {name}"), outcome, scale, told, holds)
}

/// Returns the section of three bodies.
pub(super) fn bodies() -> Section {
    const PERIODS: u32 = 10_000;
    let mut jobs: Vec<Job> = vec![];
    macro_rules! eights {
        ($($steps:literal: $method:expr),*) => { $( jobs.push(Box::new(|| {
            let (system, start, period) = eight();
            let run = system.integrator($method, period / f64::from($steps), start);
            eights(format!("{}, {} a period", stringify!($method), $steps), |see| {
                fixed(run, u64::from($steps * PERIODS), 17 * PERIODS, see)
            })
        })); )* };
    }
    eights!(170: BlanesMoanSrkn14a, 170: Gauss::<4>, 340: DiscreteGradient);
    jobs.push(Box::new(|| {
        let (system, start, period) = eight();
        let run = TaylorIntegrator::new(system, Taylor::default(), start);
        eights("Taylor".into(), |see| adapting(run, period * f64::from(PERIODS), 17 * PERIODS, see))
    }));
    const END: f64 = 100.0;
    macro_rules! triangles {
        ($($tolerance:literal, $bound:literal: $method:expr),*) => { $( jobs.push(Box::new(|| {
            let (system, start) = pythagorean();
            let outcome = adapting(system.adaptive($method, $tolerance, start), END, 100, |_| ());
            triangles(format!("adaptive({}), {:.0e}", stringify!($method), $tolerance), &outcome, $bound)
        })); )* };
    }
    triangles!(1e-13, 1e-8: DOP853, 1e-13, 1e-8: Gauss::<4>, 1e-10, 1e-10: FourthOrder(DiscreteGradient));
    jobs.push(Box::new(|| {
        let (system, start) = pythagorean();
        let outcome = adapting(TaylorIntegrator::new(system, Taylor::default(), start), END, 100, |_| ());
        // At t = 15.83 two bodies are 4e-4 apart, at 1.8 from the centre. A rounding of their positions by ε/2 changes the energy of −12.8 by the fraction
        // 8e-10.
        triangles("Taylor".into(), &outcome, 1e-9)
    }));
    Section {
        title: "Close encounters: three bodies",
        text: "Figure eight over 10⁴ periods, bound 1e-10. Pythagorean problem up to t = 100: masses 3, 4 and 5 start at rest, and the lightest \
               body leaves a pair.",
        head: &["run", "energy", "angular momentum", "steps", "", "end"],
        part: Part::Columns(&[0, 1], all),
        jobs,
    }
}

/// Three bodies of mass 3, 4 and 5 at rest in the corners of a triangle with sides 3, 4 and 5. Each mass lies opposite to the side of its number. C.
/// Burrau, Astron. Nachr. 195 (1913) 113. About t = 60 the lightest body leaves a pair: V. Szebehely & C. F. Peters, Astron. J. 72 (1967) 876.
fn pythagorean() -> (ThreeBodies, Space) {
    let q = [Vector3::new(1.0, 3.0, 0.0), Vector3::new(-2.0, -1.0, 0.0), Vector3::new(1.0, -1.0, 0.0)];
    (ThreeBodies { m: [3.0, 4.0, 5.0], g: 1.0 }, State::new(q, [Vector3::zeros(); 3]))
}

/// Three bodies that follow each other along an eight, and their period. C. Moore, Phys. Rev. Lett. 70 (1993) 3675; digits of C. Simó.
fn eight() -> (ThreeBodies, Space, f64) {
    let m = 1.7;
    let first = Vector3::new(0.97000435669734, -0.24308753153583, 0.0);
    let last = m * Vector3::new(-0.93240737144104, -0.86473146092102, 0.0);
    let start = State::new([first, -first, Vector3::zeros()], [-0.5 * last, -0.5 * last, last]);
    (ThreeBodies { m: [m; 3], g: 1.0 / m }, start, 6.325_913_985)
}

/// Returns the angular momentum of bodies. Only its z component differs from zero.
fn angular_momentum(state: &Space) -> f64 {
    state.q.iter().zip(&state.p).map(|(q, p)| q.cross(p).z).sum()
}
