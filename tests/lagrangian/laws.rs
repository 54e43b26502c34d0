//! Conserved quantities of steps, the work of friction, and refusals.

use crate::references::{BRAKED, DOUBLE_PENDULUM};
use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[test]
fn discrete_gradients_keep_the_energy() -> Result<(), StepError> {
    macro_rules! keeps {
        ($($system:expr, $start:expr, $h:literal;)*) => { $(
            let system = $system;
            let start = $start(&system);
            let mut sim = system.integrator(DiscreteGradient, $h, start);
            let energy = sim.energy();
            sim.advance(500)?;
            assert!((sim.energy() - energy).abs() < 1e-13 * (1.0 + energy.abs()), "{} {energy}", sim.energy() - energy);
        )* };
    }
    keeps! {
        Cubic { epsilon: 0.2, delta: 0.1 }, |s: &Cubic| s.at(0.8, 0.5), 0.1;
        DOUBLE_PENDULUM, |s: &DoublePendulum| s.at([0.0, 1.4], [0.0, 0.0]), 0.05;
        SphericalPendulum { m: 0.7, l: 1.2, g: 9.81 }, |s: &SphericalPendulum| s.at([1.0, 0.0], [0.0, 2.0]), 0.05;
        Hoop { omega: 4.0, g: 9.81 }, |s: &Hoop| s.at(0.5, 0.0), 0.1;
        Parabola { omega: 2.0, g: 9.81 }, |s: &Parabola| s.at(1.0, 0.0), 0.05;
        Relativistic { m: 0.7, c: 1.3, k: 0.9 }, |s: &Relativistic| s.at(2.0, 0.0), 0.3;
        Charge { k: 0.25 }, |s: &Charge| s.at([1.0, 0.0], [0.0, 0.5]), 0.2;
    }
    Ok(())
}

/// L does not read the angle, so its momentum is constant to the last bit.
#[test]
fn momenta_of_angles_that_are_not_read_stay() -> Result<(), StepError> {
    let system = SphericalPendulum { m: 0.7, l: 1.2, g: 9.81 };
    let start = system.at([1.0, 0.0], [0.0, 2.0]);
    macro_rules! keeps {
        ($($method:expr),*) => { $(
            let mut sim = system.integrator($method, 0.05, start);
            sim.advance(200)?;
            assert_eq!(sim.state().p[1], start.p[1]);
        )* };
    }
    keeps!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>, DiscreteGradient, RK4);
    assert!(SphericalPendulum::<f64>::REPORT.contains("p[1]: H does not read q[1]"));
    Ok(())
}

/// The bead on the hoop: H is conserved, but H is not T + V.
#[test]
fn the_energy_of_a_moving_frame_is_not_mechanical() -> Result<(), StepError> {
    let system = Hoop { omega: 4.0, g: 9.81 };
    let mut sim = system.integrator(DiscreteGradient, 0.01, system.at(0.5, 0.0));
    let energy = sim.energy();
    let mechanical = |q: f64, v: f64| 0.5 * v * v + 0.5 * (4.0 * q.sin()).powi(2) - 9.81 * q.cos();
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for _ in 0..300 {
        sim.step()?;
        assert!((sim.energy() - energy).abs() < 1e-13);
        let now = mechanical(sim.state().q, sim.velocity());
        (least, most) = (least.min(now), most.max(now));
    }
    assert!(most - least > 5.0, "{least} {most}");
    Ok(())
}

/// Friction in proportion to the kinetic energy equals friction by the action: p' = ∂L/∂q − γp.
#[test]
fn friction_is_that_of_herglotz() -> Result<(), StepError> {
    let Braked { m, l, g, gamma } = BRAKED;
    let system = Rubbed { m, l, g, gamma };
    let mut rubbed = system.integrator(Gauss::<4>, 0.01, system.at([0.0, 1.4], [0.0, 0.0]));
    rubbed.advance(200)?;
    let expected = [0.333_568_811_836_901_52, -0.382_021_839_677_322_04];
    assert!((0..2).all(|i| (rubbed.state().q[i] - expected[i]).abs() < 1e-13), "{:?}", rubbed.state());

    // A step of the discrete gradient loses h times the power of friction at its mean velocity.
    let mut sim = system.integrator(DiscreteGradient, 0.05, system.at([0.0, 1.4], [0.0, 0.0]));
    for _ in 0..100 {
        let (before, energy) = (sim.state(), sim.energy());
        sim.step()?;
        let after = sim.state();
        let mean = [0, 1].map(|i| (after.q[i] - before.q[i]) / 0.05);
        let middle = [0, 1].map(|i| (after.q[i] + before.q[i]) / 2.0);
        let rayleigh = gamma * (system.lagrangian(0.0, middle, mean) - system.lagrangian(0.0, middle, [0.0; 2]));
        assert!((sim.energy() - energy + 0.05 * 2.0 * rayleigh).abs() < 1e-13);
    }
    Ok(())
}

/// ½(1 + 2εq)q'²: beyond q = −1/(2ε) the mass is negative, and no step leads there.
#[test]
fn no_step_leads_over_a_singular_mass() {
    let system = Cubic { epsilon: 0.2, delta: 0.1 };
    let start = system.at(-2.0, -3.0);
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            for h in [0.05, 0.3, 1.0] {
                let mut sim = system.integrator($method, h, start);
                let refused = (0..100).any(|_| sim.step().is_err());
                assert!(sim.state().q > -2.5, "{:?}", sim.state());
                assert!(refused, "{:?}", sim.state());
            }
        )* };
    }
    refuses!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>, DiscreteGradient);
    // A single long step over the pole is refused.
    let mut sim = system.integrator(ImplicitMidpoint, 1.0, system.at(-2.0, -3.0));
    assert!(sim.step().is_err());
}

/// H decays at the rate ∂L/∂s.
#[test]
fn the_energy_of_herglotz_decays() -> Result<(), StepError> {
    let mut sim = BRAKED.integrator(ContactDiscreteGradient, 0.05, BRAKED.at([0.0, 1.4], [0.0, 0.0], 0.0));
    let mut energy = sim.energy();
    for _ in 0..100 {
        sim.step()?;
        assert!((sim.energy() / energy - (-0.3_f64 * 0.05).exp()).abs() < 1e-12);
        energy = sim.energy();
    }
    Ok(())
}
