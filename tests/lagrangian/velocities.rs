//! Lagrangians whose steps are solved for velocities: against their energies, published numbers, and laws.

use crate::references::{ARM, DOUBLE_PENDULUM};
use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

const BENT: ([f64; 3], [f64; 3]) = ([0.5, 0.4, -0.3], [0.0, 0.0, 1.0]);

/// The largest difference of positions and momenta.
fn far<const N: usize>(a: &State<[f64; N]>, b: &State<[f64; N]>) -> f64 {
    (0..N).fold(0.0, |far, i| f64::max(far, f64::max((a.q[i] - b.q[i]).abs(), (a.p[i] - b.p[i]).abs())))
}

/// Returns the state after `steps` steps of length `h`.
fn after<S, M>(system: S, method: M, h: f64, start: State<[f64; 3]>, steps: u64) -> State<[f64; 3]>
where
    S: PhaseSpace<State = State<[f64; 3]>>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, h, start);
    sim.advance(steps).expect("steps");
    sim.state()
}

/// Nothing is faster than light.
#[lagrangian]
fn fast(q: [f64; 1], v: [f64; 1], m: f64, c: f64) -> f64 {
    -m * c * c * (1.0 - v[0] * v[0] / (c * c)).sqrt() - m * q[0] * q[0] / 2.0
}

#[test]
fn velocities_without_a_momentum_are_refused_by_name() {
    let system = Fast { m: 1.0, c: 3.0 };
    let refused = |error: StepError| {
        assert!(matches!(error, StepError { t: 0.0, failure: Failure::NoMomentum, .. }), "{error:?}");
        assert!(error.to_string().contains("the velocities of the state at t = 0 have no finite momenta"), "{error}");
    };
    for v in [3.0, 4.0, -3.5] {
        let state = system.at([0.2], [v]);
        refused(system.integrator(StormerVerlet, 0.1, state).step().unwrap_err());
        refused(system.adaptive(DOP853, 1e-6, state).step().unwrap_err());
        refused(system.taylor(Taylor::default(), state).step().unwrap_err());
    }
    let nowhere = system.integrator(StormerVerlet, 0.1, system.at([f64::NAN], [0.1])).step().unwrap_err();
    assert!(matches!(nowhere, StepError { failure: Failure::NonFiniteState, .. }), "{nowhere:?}");
    assert!(system.integrator(StormerVerlet, 0.1, system.at([0.2], [2.9])).step().is_ok());
}

#[test]
fn the_report_says_which_steps() {
    let report = Arm::<f64>::REPORT;
    assert!(report.contains("steps are solved for v"), "{report}");
    assert!(report.contains("with 3 unknowns a stage"), "{report}");
    assert!(report.contains("- the energy"), "{report}");
    assert!(!DoublePendulum::<f64>::REPORT.contains("steps are solved for v"));
    assert!(Quartic::<f64>::REPORT.contains("there is no discrete gradient"));
}

/// Numbers that were found by another program.
#[test]
fn errors_of_the_polarised_discrete_gradient() {
    let start = ARM.at(BENT.0, BENT.1);
    let exact = after(ARM, Gauss::<6>, 0.01, start, 100);
    for (h, expected) in [(0.04, 2.04e-2), (0.02, 5.61e-3), (0.01, 1.44e-3), (0.005, 3.61e-4)] {
        let found = far(&after(ARM, DiscreteGradient, h, start, (1.0 / h) as u64), &exact);
        assert!((found / expected - 1.0).abs() < 0.05, "{found:.3e} {expected:.3e}");
    }
    let fourth = [0.04, 0.02, 0.01]
        .map(|h: f64| far(&after(ARM, Suzuki4.of(DiscreteGradient), h, start, (1.0 / h) as u64), &exact));
    assert!((fourth[0] / fourth[1]).log2() > 3.7 && (fourth[1] / fourth[2]).log2() > 3.8, "{fourth:?}");
}

#[test]
fn the_energy_stays_and_steps_go_back() -> Result<(), StepError> {
    let start = ARM.at(BENT.0, BENT.1);
    for h in [0.01, 0.05, 0.1] {
        let mut sim = ARM.integrator(DiscreteGradient, h, start);
        let energy = sim.energy();
        sim.advance(2000)?;
        assert!((sim.energy() - energy).abs() < 1e-12, "{h}: {:e}", sim.energy() - energy);
    }
    macro_rules! back {
        ($($method:expr),*) => { $(
            let mut sim = ARM.integrator($method, 0.05, start);
            sim.step()?;
            sim.set_step_size(-0.05);
            sim.step()?;
            assert!(far(&sim.state(), &start) < 1e-14, "{:?}", sim.state());
        )* };
    }
    back!(DiscreteGradient, ImplicitMidpoint, Gauss::<2>, Gauss::<3>);
    Ok(())
}

/// The double pendulum with a third coordinate at rest relative to the first. If the momentum of this coordinate is 0, the coordinate adds nothing,
/// but couples three velocities. Steps for velocities then equal steps of the energy, and the polarised discrete gradient has the published errors.
#[test]
fn steps_for_velocities_are_those_of_the_energy() -> Result<(), StepError> {
    #[lagrangian]
    fn with_another(q: [f64; 3], v: [f64; 3], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
        let x = [l[0] * v[0], l[1] * v[1]];
        let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
        let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
        kinetic
            + (m[0] + m[1]) * g * l[0] * q[0].cos()
            + m[1] * g * l[1] * q[1].cos()
            + 0.5 * (v[2] + 0.3 * v[0]).powi(2)
    }
    assert!(WithAnother::<f64>::REPORT.contains("steps are solved for v"));
    let DoublePendulum { m, l, g } = DOUBLE_PENDULUM;
    let (system, start) = (WithAnother { m, l, g }, State::new([0.0, 1.4, 0.0], [0.0; 3]));
    macro_rules! far_from_energy {
        ($method:expr, $h:literal, $steps:literal) => {{
            let mut one = system.integrator($method, $h, start);
            let mut other = DOUBLE_PENDULUM.integrator($method, $h, DOUBLE_PENDULUM.at([0.0, 1.4], [0.0, 0.0]));
            one.advance($steps)?;
            other.advance($steps)?;
            let (one, other) = (one.state(), other.state());
            (0..2).fold(0.0, |far, i| {
                f64::max(far, f64::max((one.q[i] - other.q[i]).abs(), (one.p[i] - other.p[i]).abs()))
            })
        }};
    }
    for found in [
        far_from_energy!(ImplicitMidpoint, 0.002, 1000),
        far_from_energy!(Gauss::<2>, 0.002, 1000),
        far_from_energy!(Gauss::<3>, 0.002, 1000),
    ] {
        assert!(found < 1e-13, "{found:e}");
    }
    let mut exact = DOUBLE_PENDULUM.integrator(Gauss::<6>, 0.01, DOUBLE_PENDULUM.at([0.0, 1.4], [0.0, 0.0]));
    exact.advance(200)?;
    for (h, expected) in [(0.04, 1.08e-2), (0.02, 2.71e-3), (0.01, 6.79e-4), (0.005, 1.70e-4)] {
        let end = after(system, DiscreteGradient, h, start, (2.0 / h).round() as u64);
        let exact = exact.state();
        let error = (0..2)
            .fold(0.0, |far, i| f64::max(far, f64::max((end.q[i] - exact.q[i]).abs(), (end.p[i] - exact.p[i]).abs())));
        assert!((error / expected - 1.0).abs() < 0.05, "{error:.3e} {expected:.3e}");
    }
    Ok(())
}

/// Without weight the whole arm turns freely, and Gauss methods conserve its momentum. The discrete gradient conserves the momenta of angles that L
/// does not read.
#[test]
fn a_momentum_that_is_not_acted_on_stays() -> Result<(), StepError> {
    let arm = Arm { g: 0.0, ..ARM };
    let start = arm.at(BENT.0, [0.7, 0.2, 1.0]);
    macro_rules! keeps {
        ($($method:expr),*) => { $(
            let mut sim = arm.integrator($method, 0.05, start);
            sim.advance(200)?;
            assert!((sim.state().p[0] - start.p[0]).abs() < 1e-13, "{:e}", sim.state().p[0] - start.p[0]);
        )* };
    }
    keeps!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>);
    // An angle that is not read at all: to the last bit.
    let start = FREE.at([0.5, 0.4, -0.3], [0.7, 0.2, 1.0]);
    let mut sim = FREE.integrator(DiscreteGradient, 0.05, start);
    sim.advance(200)?;
    assert_eq!(sim.state().p[0], start.p[0]);
    assert!(FreeArm::<f64>::REPORT.contains("p[0]: L does not read q[0]"));
    Ok(())
}

const FREE: FreeArm = FreeArm { m: [2.0, 1.0, 0.5] };

/// Friction takes h v̄·C v̄ from the energy in a step. For h > 0 friction never adds energy.
#[test]
fn friction_takes_what_it_says() -> Result<(), StepError> {
    let Arm { m, l, g } = ARM;
    let system = RubbedArm { m, l, g, c: 0.4 };
    let mut sim = system.integrator(DiscreteGradient, 0.05, system.at(BENT.0, BENT.1));
    for _ in 0..200 {
        let (before, energy) = (sim.state(), sim.energy());
        sim.step()?;
        let after = sim.state();
        let mean: [f64; 3] = core::array::from_fn(|i| (after.q[i] - before.q[i]) / 0.05);
        let middle = 0.5 * (before.q[1] + after.q[1]);
        let c = 0.4 * (1.0 + middle * middle);
        let rayleigh = 0.5
            * c
            * (0.3 * mean[0] * mean[0] + 0.1 * mean[0] * mean[1] + 0.2 * mean[1] * mean[1] + 0.1 * mean[2] * mean[2]);
        assert!((sim.energy() - energy + 0.05 * 2.0 * rayleigh).abs() < 1e-13);
        assert!(sim.energy() < energy);
    }
    // Gauss methods keep their order.
    let end = |h: f64| after(system, Gauss::<2>, h, system.at(BENT.0, BENT.1), (1.0 / h).round() as u64);
    let exact = after(system, Gauss::<6>, 0.02, system.at(BENT.0, BENT.1), 50);
    let order = (far(&end(0.04), &exact) / far(&end(0.02), &exact)).log2();
    assert!((order - 4.0).abs() < 0.2, "{order}");
    Ok(())
}

/// A mass that time changes.
#[test]
fn time_keeps_the_order() {
    let system = GrowingArm { m: [2.0, 1.0, 0.5], rate: 0.7 };
    let start = system.at(BENT.0, [0.7, 0.2, 1.0]);
    let exact = after(system, Gauss::<6>, 0.02, start, 50);
    let observed = |errors: [f64; 2]| (errors[0] / errors[1]).log2();
    let midpoint =
        observed([0.02, 0.01].map(|h| far(&after(system, ImplicitMidpoint, h, start, (1.0 / h) as u64), &exact)));
    let discrete =
        observed([0.02, 0.01].map(|h| far(&after(system, DiscreteGradient, h, start, (1.0 / h) as u64), &exact)));
    let gauss = observed([0.05, 0.025].map(|h| far(&after(system, Gauss::<2>, h, start, (1.0 / h) as u64), &exact)));
    assert!(
        (midpoint - 2.0).abs() < 0.1 && (discrete - 2.0).abs() < 0.1 && (gauss - 4.0).abs() < 0.2,
        "{midpoint} {discrete} {gauss}"
    );
    let explicit = observed([0.01, 0.005].map(|h| far(&after(system, RK4, h, start, (1.0 / h) as u64), &exact)));
    assert!((explicit - 4.0).abs() < 0.2, "{explicit}");
}

/// v⁴ + v², which no formula inverts: order, and energy kept as a symplectic method does.
#[test]
fn other_powers_of_velocities() -> Result<(), StepError> {
    let system = Quartic { k: 1.3 };
    let start = system.at([0.4, -0.2], [0.3, 0.9]);
    let end = |h: f64| {
        let mut sim = system.integrator(Gauss::<2>, h, start);
        sim.advance((2.0 / h).round() as u64).expect("steps");
        sim.state()
    };
    let mut sim = system.integrator(Gauss::<6>, 0.02, start);
    sim.advance(100)?;
    let exact = sim.state();
    let order = (far(&end(0.1), &exact) / far(&end(0.05), &exact)).log2();
    assert!((order - 4.0).abs() < 0.2, "{order}");
    // By the third identity of Legendre's transformation.
    let v = system.velocity(&exact);
    let p = system.momentum(0.0, exact.q, v);
    assert!((0..2).all(|i| (p[i] - exact.p[i]).abs() < 1e-14));
    assert!((sim.energy() - system.energy(&start)).abs() < 1e-13);
    Ok(())
}

/// v₀v₁ has no positive definite mass matrix, nor one with a diagonal.
#[test]
fn masses_of_both_signs() -> Result<(), StepError> {
    #[hamiltonian]
    fn by_hand(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
        p[0] * p[1] / m + q[0] * q[1] + (q[0] + 2.0 * q[1]).cos()
    }
    let system = Mixed { m: 0.7 };
    let start = system.at([0.3, 0.2], [-0.4, 0.5]);
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = system.integrator($method, 0.1, start);
            let mut other = ByHand { m: 0.7 }.integrator($method, 0.1, start);
            one.advance(30)?;
            other.advance(30)?;
            assert!(far(&one.state(), &other.state()) < 1e-13, "{:?} {:?}", one.state(), other.state());
        )* };
    }
    same!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>);
    let mut sim = system.integrator(DiscreteGradient, 0.1, start);
    let energy = sim.energy();
    sim.advance(30)?;
    assert!((sim.energy() - energy).abs() < 1e-14);
    Ok(())
}

/// No step leads across a singular mass matrix.
#[test]
fn no_step_leads_over_a_singular_mass_matrix() {
    let start = SINGULAR.at([1.0, 0.2, -0.1], [-1.5, 0.3, 0.2]);
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            for h in [0.02, 0.3, 1.5] {
                let mut sim = SINGULAR.integrator($method, h, start);
                let mut refused = false;
                for _ in 0..200 {
                    let before = sim.state();
                    if sim.step().is_err() {
                        assert_eq!(sim.state(), before);
                        refused = true;
                        break;
                    }
                    assert!(sim.state().q[0] > 0.0, "{:?} by {h}", sim.state());
                }
                assert!(refused, "{h}");
            }
        )* };
    }
    refuses!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>, DiscreteGradient);
}

const SINGULAR: Singular = Singular { m: 0.7 };

/// Other units of mass and time, by powers of two: the same bits.
#[test]
fn units_change_nothing() -> Result<(), StepError> {
    let scaled = Arm { m: ARM.m.map(|m| 4.0 * m), g: 16.0 * ARM.g, ..ARM };
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = ARM.integrator($method, 0.05, ARM.at(BENT.0, BENT.1));
            let mut other = scaled.integrator($method, 0.0125, scaled.at(BENT.0, BENT.1.map(|v| 4.0 * v)));
            one.advance(300)?;
            other.advance(300)?;
            assert_eq!(one.state().q, other.state().q);
            assert_eq!(one.state().p.map(|p| 16.0 * p), other.state().p);
        )* };
    }
    same!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>, DiscreteGradient, RK4);
    Ok(())
}

/// Explicit steps that are put right keep p·v − L, up to the rounding of its values in 500 steps.
#[test]
fn explicit_steps_are_put_right() -> Result<(), StepError> {
    fn strayed<M: Method<Arm>>(method: M) -> Result<f64, StepError> {
        let mut sim = ARM.integrator(method, 0.01, ARM.at(BENT.0, BENT.1));
        let energy = sim.energy();
        sim.advance(500)?;
        Ok((sim.energy() - energy).abs())
    }
    assert!(strayed(RK4)? > 1e-8, "{:e}", strayed(RK4)?);
    assert!(strayed(Projection(RK4, Energy))? < 3e-13, "{:e}", strayed(Projection(RK4, Energy))?);
    assert!(strayed(Relaxation(RK4))? < 3e-13, "{:e}", strayed(Relaxation(RK4))?);
    Ok(())
}

/// Adaptive steps and compensated sums reach the solution to 10⁻⁷ and 10⁻¹².
#[test]
fn runs_of_every_kind() -> Result<(), StepError> {
    let start = ARM.at(BENT.0, BENT.1);
    let exact = after(ARM, Gauss::<6>, 0.01, start, 100);
    let mut adaptive = ARM.adaptive(Gauss::<2>, 1e-9, start);
    adaptive.advance_to(1.0)?;
    assert!(far(&adaptive.state(), &exact) < 1e-7);
    let mut fine = ARM.integrator(Gauss::<3>, 1e-3, start).compensated();
    fine.advance(1000)?;
    assert!(far(&fine.state(), &exact) < 1e-12);
    Ok(())
}
