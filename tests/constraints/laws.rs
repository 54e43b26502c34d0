//! Conserved quantities of systems with constraints.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

const SPHERICAL: SphericalPendulum = SphericalPendulum { m: 1.0, l: 1.0, g: 9.81 };

/// The polar angle 1 from below, turning about the vertical.
fn turning() -> State<[f64; 3]> {
    State::new([1.0_f64.sin(), 0.0, -1.0_f64.cos()], [0.0, 2.0 * 1.0_f64.sin(), 0.0])
}

fn momentum(State { q, p, .. }: &State<[f64; 3]>) -> f64 {
    q[0] * p[1] - q[1] * p[0]
}

#[test]
fn the_spherical_pendulum_keeps_its_momentum() {
    let report = SphericalPendulum::<f64>::REPORT;
    assert!(
        report.contains("angular momentum: p[0]·q[1] - p[1]·q[0]") || report.contains("q[0]·p[1] - q[1]·p[0]"),
        "{report}"
    );
    assert!(!report.contains("λ["), "{report}");
    // θ and φ at t = 3 to twenty digits.
    let (theta, phi) = (0.849050422962852410407386_f64, 10.868062174150498807318_f64);
    let exact = [theta.sin() * phi.cos(), theta.sin() * phi.sin(), -theta.cos()];
    macro_rules! keeps {
        ($($method:expr => $energy:literal),*) => { $(
            let errors = [0.02, 0.01, 0.005].map(|h| {
                let sim = run(SPHERICAL, $method, h, turning(), 3.0);
                assert!((momentum(&sim.state()) - momentum(&turning())).abs() < 1e-14);
                assert!((sim.energy() - SPHERICAL.energy(&turning())).abs() < $energy);
                let q = sim.state().q;
                (0..3).fold(0.0, |far, i| f64::max(far, (q[i] - exact[i]).abs()))
            });
            assert!(orders(&errors).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
        )* };
    }
    keeps!(Rattle => 1e-1, DiscreteGradient => 3e-14);
}

/// A fast mass on a sphere: T is not quadratic.
#[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - 1.0) / 2.0])]
fn fast_pendulum(q: [f64; 3], p: [f64; 3], m: f64, c: f64, g: f64) -> f64 {
    c * (m * m * c * c + p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt() + m * g * q[2]
}

/// By how much the velocity leads away from the sphere does not grow, and is of order h². Made tangent it would change the energy by O(h⁴). This is the price
/// of a T that is not quadratic.
#[test]
fn momenta_come_back_to_the_constraint() -> Result<(), StepError> {
    let system = FastPendulum { m: 0.8, c: 4.0, g: 9.81 };
    let State { q, p, .. } = turning();
    let start = State::new(q, p.map(|p| 0.8 * p));
    let most = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    let mut largest = vec![];
    for h in [0.02, 0.01] {
        let mut sim = system.integrator(DiscreteGradient, h, start);
        let (mut normal, mut changed) = (vec![], 0.0_f64);
        for _ in 0..5000 {
            sim.step()?;
            let State { q, p, .. } = sim.state();
            normal.push((q[0] * p[0] + q[1] * p[1] + q[2] * p[2]).abs());
            let shown = sim.state_on_constraint()?;
            changed = changed.max((system.energy(&shown) - system.energy(&start)).abs());
        }
        assert!((sim.energy() - system.energy(&start)).abs() < 1e-13);
        let (first, last) = (most(&normal[..500]), most(&normal[4500..]));
        assert!(last < 1.1 * first, "{first:e} {last:e}");
        largest.push([first, changed]);
    }
    for (k, order) in [(0, 2.0), (1, 4.0)] {
        let found = (largest[0][k] / largest[1][k]).log2();
        assert!((found - order).abs() < 0.2, "{largest:?}");
    }
    Ok(())
}

/// A hyperbolic plane in a space whose metric has both signs: inertia along the gradient of the constraint is negative.
#[hamiltonian(constraint = [(q[1] * q[1] + q[2] * q[2] - q[0] * q[0] + 1.0) / 2.0])]
fn hyperbolic(q: [f64; 3], p: [f64; 3], m: f64, g: f64) -> f64 {
    (p[1] * p[1] + p[2] * p[2] - p[0] * p[0]) / (2.0 * m) + g * q[0]
}

/// The same in polar coordinates, q₀ = cosh r.
#[hamiltonian]
fn hyperbolic_polar(q: [f64; 2], p: [f64; 2], m: f64, g: f64) -> f64 {
    (p[0] * p[0] + (p[1] / q[0].sinh()).powi(2)) / (2.0 * m) + g * q[0].cosh()
}

#[test]
fn inertia_may_be_negative() -> Result<(), StepError> {
    let (r, rate, turning) = (0.7_f64, 0.3, 0.9);
    let (system, polar) = (Hyperbolic { m: 1.3, g: 2.0 }, HyperbolicPolar { m: 1.3, g: 2.0 });
    // From (r, φ = 0) with r' and φ': p₀ = −m q₀'.
    let momenta = [-1.3 * r.sinh() * rate, 1.3 * r.cosh() * rate, 1.3 * r.sinh() * turning];
    let start = State::new([r.cosh(), r.sinh(), 0.0], momenta);
    let mut exact = polar.adaptive(DOP853, 1e-13, State::new([r, 0.0], [1.3 * rate, 1.3 * r.sinh().powi(2) * turning]));
    exact.advance_to(2.0)?;
    let [r, angle] = exact.state().q;
    let place = [r.cosh(), r.sinh() * angle.cos(), r.sinh() * angle.sin()];
    let errors = [0.04, 0.02, 0.01].map(|h| {
        let sim = run(system, DiscreteGradient, h, start, 2.0);
        assert!((sim.energy() - system.energy(&start)).abs() < 1e-13);
        let State { q, p, .. } = sim.state();
        assert!((q[1] * p[1] + q[2] * p[2] + q[0] * p[0]).abs() < 1e-13);
        (0..3).fold(0.0, |far, i| f64::max(far, (q[i] - place[i]).abs()))
    });
    assert!(orders(&errors).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
    Ok(())
}

/// A pendulum of 10¹⁰ m in single precision: squares of the inertia of its constraint would overflow. Below 10⁻⁹ m steps are refused.
#[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] - l * l) / 2.0])]
fn tall(q: [f32; 2], p: [f32; 2], m: f32, l: f32, g: f32) -> f32 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

#[test]
fn large_lengths_in_single_precision() -> Result<(), StepError> {
    for l in [1.0_f32, 1e10, 1e-8] {
        let system = Tall { m: 0.7, l, g: l };
        let mut sim = system.integrator(DiscreteGradient, 0.05, State::new([0.6 * l, -0.8 * l], [0.0; 2]));
        let energy = sim.energy();
        sim.advance(500)?;
        assert!((sim.energy() / energy - 1.0).abs() < 1e-5, "{l:e}");
        assert!((sim.state().q[0].hypot(sim.state().q[1]) / l - 1.0).abs() < 1e-6, "{l:e}");
    }
    Ok(())
}

/// The rods of a mechanism, each as the difference of its ends.
type Rods = Vec<Vec<f64>>;

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Largest defects of energy, lengths of rods and their rates over 10⁵ steps. `rods` is linear, so it also returns the changes of the rods from velocities.
fn defects<S, const N: usize>(
    system: S,
    start: State<[f64; N]>,
    masses: [f64; N],
    lengths: &[f64],
    rods: impl Fn(&[f64], f64) -> Rods,
) -> Result<[f64; 3], StepError>
where
    S: geoint_runtime::Constrained<Coordinates = [f64; N], Array = [f64; N], State = State<[f64; N]>>,
    DiscreteGradient: Method<S>,
{
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut sim = Integrator::new(system, DiscreteGradient, 0.02, start);
    let energy = sim.energy();
    let [mut changed, mut off, mut rate] = [0.0_f64; 3];
    for _ in 0..100_000 {
        sim.step()?;
        changed = changed.max((sim.energy() - energy).abs());
        let State { q, p, .. } = sim.state();
        let v: Vec<f64> = p.iter().zip(masses).map(|(p, m)| p / m).collect();
        for ((rod, change), length) in rods(&q, 1.0).iter().zip(&rods(&v, 0.0)).zip(lengths) {
            off = off.max((dot(rod, rod).sqrt() - length).abs());
            rate = rate.max(dot(rod, change).abs());
        }
    }
    Ok([changed, off, rate])
}

/// Pendulum, double spherical pendulum and linkage: constraint, rate and energy stay at rounding.
#[test]
fn tangent_ends_last() -> Result<(), StepError> {
    let (sin, cos) = 2.0_f64.sin_cos();
    let pendulum = defects(
        Pendulum { m: 0.7, l: 1.3, g: 9.81 },
        State::new([1.3 * sin, -1.3 * cos], [0.0; 2]),
        [0.7; 2],
        &[1.3],
        |x, _| vec![x.to_vec()],
    )?;
    let double = DoubleSpherical { m: M, l: L, g: 9.81 };
    let near = State::new([0.84, 0.0, -0.54, 1.14, 0.4, -1.04], [0.1, 2.0, 0.3, -0.5, 1.0, 0.2]);
    let masses = [M[0], M[0], M[0], M[1], M[1], M[1]];
    let double = defects(double, double.state_on_constraint(&near)?, masses, &L, |x, _| {
        vec![x[..3].to_vec(), difference(&x[3..], &x[..3])]
    })?;
    let linkage = defects(FOUR_BAR, cranked(0.5, 3.0).1, [0.7, 0.7, 1.5, 1.5], &BARS, |x, fixed| {
        vec![x[..2].to_vec(), difference(&x[2..], &x[..2]), difference(&x[2..], &[2.2 * fixed, 0.0])]
    })?;
    for found in [pendulum, double, linkage] {
        assert!(found.iter().all(|defect| *defect < 1e-12), "{found:?}");
    }
    Ok(())
}

/// Two spherical pendulums, one below the other.
#[hamiltonian(constraint = [
    (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l[0] * l[0]) / 2.0,
    ((q[3] - q[0]).powi(2) + (q[4] - q[1]).powi(2) + (q[5] - q[2]).powi(2) - l[1] * l[1]) / 2.0
])]
fn double_spherical(q: [f64; 6], p: [f64; 6], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m[0])
        + (p[3] * p[3] + p[4] * p[4] + p[5] * p[5]) / (2.0 * m[1])
        + g * (m[0] * q[2] + m[1] * q[5])
}

/// h v̄·C v̄ with the mean velocity of a step.
#[test]
fn friction_takes_what_it_says() -> Result<(), StepError> {
    let system = Rubbed { m: M, l: L, g: 9.81, c: 0.3 };
    let State { q, .. } = released();
    let mut sim = system.integrator(DiscreteGradient, 0.02, system.at(q, [0.0; 4]));
    for _ in 0..500 {
        let (before, energy) = (sim.state(), sim.energy());
        sim.step()?;
        let after = sim.state();
        let lost: f64 = (0..4).map(|i| 0.3 * (after.q[i] - before.q[i]).powi(2) / 0.02).sum();
        assert!((sim.energy() - energy + lost).abs() < 1e-13, "{:e}", sim.energy() - energy + lost);
    }
    let exact = run(system, KahanLi8_17a.of(Rattle), 0.01, system.at(q, [0.0; 4]), 1.0).state();
    let errors = [0.02, 0.01, 0.005].map(|h| far(&run(system, Rattle, h, system.at(q, [0.0; 4]), 1.0).state(), &exact));
    assert!(orders(&errors).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
    Ok(())
}

/// The mass matrix is diagonal, so L and H give the same steps.
#[test]
fn a_lagrangian_has_the_same_steps() -> Result<(), StepError> {
    let of_speeds = OfSpeeds { m: M, l: L, g: 9.81 };
    assert_eq!(of_speeds.at(released().q, [0.0; 4]).p, [0.0; 4]);
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = DOUBLE.integrator($method, 0.02, released());
            let mut other = of_speeds.integrator($method, 0.02, released());
            one.advance(300)?;
            other.advance(300)?;
            assert!(far(&one.state(), &other.state()) < 1e-12, "{:e}", far(&one.state(), &other.state()));
        )* };
    }
    same!(Rattle, DiscreteGradient, Suzuki4.of(Rattle));
    Ok(())
}

/// Runs of 10⁵ steps. The discrete gradient keeps the energy to 10⁻¹³, RATTLE to 0.03. Both keep the lengths to 10⁻¹⁵.
#[test]
fn long_runs() -> Result<(), StepError> {
    let mut sim = DOUBLE.integrator(DiscreteGradient, 0.02, released());
    let energy = sim.energy();
    sim.advance(100_000)?;
    assert!((sim.energy() - energy).abs() < 1e-13, "{:e}", sim.energy() - energy);
    let mut rattle = DOUBLE.integrator(Rattle, 0.02, released());
    rattle.advance(100_000)?;
    assert!((rattle.energy() - energy).abs() < 3e-2);
    for State { q, .. } in [sim.state(), rattle.state()] {
        assert!((q[0].hypot(q[1]) - 1.0).abs() < 1e-15 && ((q[2] - q[0]).hypot(q[3] - q[1]) - 0.8).abs() < 1e-15);
    }
    Ok(())
}

/// An oriented area on the tangent bundle of the circle, by differences: kept by RATTLE, not by the discrete gradient.
#[test]
fn rattle_is_symplectic() {
    let image = |method: u32, angle: f64, rate: f64| {
        let (q, p) = ([angle.sin(), -angle.cos()], [0.7 * rate * angle.cos(), 0.7 * rate * angle.sin()]);
        let start = State::new(q, p);
        let system = Pendulum { m: 0.7, l: 1.0, g: 9.81 };
        let end = match method {
            0 => run(system, Rattle, 0.3, start, 0.3).state(),
            _ => run(system, DiscreteGradient, 0.3, start, 0.3).state(),
        };
        let angle = end.q[0].atan2(-end.q[1]);
        [angle, (end.p[0] * angle.cos() + end.p[1] * angle.sin()) / 0.7]
    };
    let area = |method: u32| {
        let d = 1e-4;
        let column = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|i| (a[i] - b[i]) / (2.0 * d));
        let by_angle = column(image(method, 1.0 + d, 0.5), image(method, 1.0 - d, 0.5));
        let by_rate = column(image(method, 1.0, 0.5 + d), image(method, 1.0, 0.5 - d));
        by_angle[0] * by_rate[1] - by_angle[1] * by_rate[0]
    };
    assert!((area(0) - 1.0).abs() < 1e-7, "{:e}", area(0) - 1.0);
    assert!((area(1) - 1.0).abs() > 1e-4, "{:e}", area(1) - 1.0);
}

/// A pendulum in a plane.
#[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] - l * l) / 2.0])]
fn pendulum(q: [f64; 2], p: [f64; 2], m: f64, l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}
