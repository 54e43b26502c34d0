//! T6: an inequality g ≥ 0, by events and a reflection that the user writes.

use geoint_runtime::Real;
use geoint_runtime::prelude::*;

/// A ball on springs, with a mass for each direction.
#[hamiltonian]
fn ball(q: [f64; 2], p: [f64; 2], mass: [f64; 2], kappa: f64) -> f64 {
    (0..2).map(|i| p[i] * p[i] / (2.0 * mass[i]) + kappa * mass[i] * q[i] * q[i] / 2.0).sum()
}

const SYSTEM: Ball = Ball { mass: [1.7, 0.6], kappa: 0.3 };

/// Half the axes of the wall.
const AXES: [f64; 2] = [1.5, 1.1];

/// g = 1 − q₁²/a² − q₂²/b², which is 0 at the wall.
fn inside<R: Real>(q: [R; 2]) -> R {
    let [x, y] = [0, 1].map(|i| q[i] / R::from_f64(AXES[i]));
    R::from_f64(1.0) - x * x - y * y
}

fn normal(q: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| q[i] / AXES[i].powi(2))
}

/// p − 2 (n·W p)/(n·W n) n with W = M⁻¹.
fn reflected(p: [f64; 2], n: [f64; 2]) -> [f64; 2] {
    let product = |x: [f64; 2]| n[0] * x[0] / SYSTEM.mass[0] + n[1] * x[1] / SYSTEM.mass[1];
    [0, 1].map(|i| p[i] - 2.0 * product(p) / product(n) * n[i])
}

/// Joachimsthal's function n·v at an impact. A flight and a reflection keep its magnitude.
fn joachimsthal(state: &State<[f64; 2]>) -> f64 {
    let n = normal(state.q);
    n[0] * state.p[0] / SYSTEM.mass[0] + n[1] * state.p[1] / SYSTEM.mass[1]
}

/// The square of Joachimsthal's function from a state inside. With y = √m q, w = y', A = √m a it is Σ (w² + κy²)/A² − (y₁w₂ − y₂w₁)²/(A₁A₂)² − κ.
/// Flights keep it, and at the wall it is (Σ yw/A²)² by Lagrange's identity.
fn square_from(state: &State<[f64; 2]>) -> f64 {
    let Ball { mass, kappa } = SYSTEM;
    let [y, w] = [[0, 1].map(|i| mass[i].sqrt() * state.q[i]), [0, 1].map(|i| state.p[i] / mass[i].sqrt())];
    let squares = [0, 1].map(|i| mass[i] * AXES[i] * AXES[i]);
    let sum: f64 = (0..2).map(|i| (w[i] * w[i] + kappa * y[i] * y[i]) / squares[i]).sum();
    sum - (y[0] * w[1] - y[1] * w[0]).powi(2) / (squares[0] * squares[1]) - kappa
}

/// A run inside of the wall. The changes of energy and Joachimsthal's function are relative.
struct Billiard {
    impacts: usize,
    smallest_g: f64,
    off_energy: f64,
    off_invariant: f64,
}

impl Billiard {
    fn run(reflect: impl Fn(State<[f64; 2]>) -> [f64; 2]) -> Result<Self, StepError> {
        let start = State::new([0.4, 0.3], [1.9, 0.5]);
        let mut sim = SYSTEM.taylor(Taylor::default(), start);
        let mut seen = Billiard { impacts: 0, smallest_g: 1.0, off_energy: 0.0, off_invariant: 0.0 };
        let (energy, invariant) = (sim.energy(), square_from(&start).sqrt());
        for n in 1..=500 {
            while let Some(impact) = sim.until_event(0.4 * f64::from(n), Direction::Down, |x| inside(x.q))? {
                let at = impact.state;
                seen.off_invariant = seen.off_invariant.max((joachimsthal(&at).abs() / invariant - 1.0).abs());
                seen.impacts += 1;
                seen.smallest_g = seen.smallest_g.min(inside(at.q));
                sim.set_state(State { p: reflect(at), ..at });
            }
            seen.smallest_g = seen.smallest_g.min(inside(sim.state().q));
            seen.off_energy = seen.off_energy.max((sim.energy() / energy - 1.0).abs());
        }
        Ok(seen)
    }
}

#[test]
fn a_ball_stays_inside_of_an_ellipse() -> Result<(), StepError> {
    let seen = Billiard::run(|at| reflected(at.p, normal(at.q)))?;
    assert!(seen.impacts > 100 && seen.smallest_g > -1e-14, "{} {:e}", seen.impacts, seen.smallest_g);
    assert!(seen.off_energy < 1e-13 && seen.off_invariant < 1e-12, "{:e} {:e}", seen.off_energy, seen.off_invariant);
    // Controls: a normal of a circle keeps the energy only, and a reflection without masses keeps neither.
    let circle = Billiard::run(|at| reflected(at.p, at.q))?;
    assert!(circle.off_energy < 1e-13 && circle.off_invariant > 0.1, "{:e}", circle.off_invariant);
    let massless = Billiard::run(|at| {
        let n = normal(at.q);
        let share = 2.0 * (at.p[0] * n[0] + at.p[1] * n[1]) / (n[0] * n[0] + n[1] * n[1]);
        [0, 1].map(|i| at.p[i] - share * n[i])
    })?;
    assert!(massless.off_energy > 0.1 && massless.off_invariant > 0.1, "{:e}", massless.off_energy);
    Ok(())
}
