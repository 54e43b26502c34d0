//! Steps in other numbers, other units, back in time, and in compensated sums.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Runs a test for both methods and for a composition of each.
macro_rules! every {
    ($visit:ident) => {
        $visit!(Rattle, DiscreteGradient, Suzuki4.of(Rattle), Suzuki4.of(DiscreteGradient));
    };
}

#[test]
fn there_and_back() -> Result<(), StepError> {
    macro_rules! back {
        ($($method:expr),*) => { $(
            for (steps, rounding) in [(1, 1e-13), (50, 1e-12)] {
                let mut sim = DOUBLE.integrator($method, 0.02, released());
                sim.advance(steps)?;
                sim.set_step_size(-0.02);
                sim.advance(steps)?;
                assert!(far(&sim.state(), &released()) < rounding, "{:e}", far(&sim.state(), &released()));
            }
        )* };
    }
    every!(back);
    Ok(())
}

/// A ladder between a wall and the floor.
#[hamiltonian(constraint = [((q[0] - q[2]).powi(2) + (q[1] - q[3]).powi(2) - l * l) / 2.0, q[0], q[3]])]
fn ladder(q: [f64; 4], p: [f64; 4], m: [f64; 2], l: f64, g: f64) -> f64 {
    let kinetic = (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0]) + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1]);
    kinetic + g * (m[0] * q[1] + m[1] * q[3])
}

/// In a short substep multipliers are large compared with their effect. A residual keeps its digits only if it is never subtracted from the unknown.
#[test]
fn short_steps_are_solved_to_rounding() -> Result<(), StepError> {
    macro_rules! solved {
        ($($method:expr),*) => { $(
            for h in [0.003, 0.001, 0.0003] {
                let start = State::new([0.0, 0.8, 0.6, 0.0], [0.0; 4]);
                let mut sim = Ladder { m: [1.3, 0.7], l: 1.0, g: 9.81 }.integrator($method, h, start);
                let energy = sim.energy();
                sim.advance(100)?;
                assert!((sim.energy() - energy).abs() < 1e-13, "{h}: {:e}", sim.energy() - energy);
            }
        )* };
    }
    solved!(DiscreteGradient, McLachlan4.of(DiscreteGradient), KahanLi8_17a.of(DiscreteGradient));
    solved!(SofroniouSpaletta10_35.of(DiscreteGradient));
    Ok(())
}

#[test]
fn many_steps_are_as_single_ones() -> Result<(), StepError> {
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut many = DOUBLE.integrator($method, 0.02, released());
            let mut single = DOUBLE.integrator($method, 0.02, released());
            many.advance(1500)?;
            for _ in 0..1500 {
                single.step()?;
            }
            assert_eq!(many.state(), single.state());
        )* };
    }
    every!(same);
    Ok(())
}

/// Other units of length, mass and time, by powers of two: the same bits.
#[test]
fn units_change_nothing() -> Result<(), StepError> {
    // Lengths × 8, masses × 4, times / 2.
    let other = DoublePendulum { m: M.map(|m| 4.0 * m), l: L.map(|l| 8.0 * l), g: 32.0 * 9.81 };
    let State { q, .. } = released();
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = DOUBLE.integrator($method, 0.02, released());
            let mut scaled = other.integrator($method, 0.01, State::new(q.map(|x| 8.0 * x), [0.0; 4]));
            one.advance(300)?;
            scaled.advance(300)?;
            assert_eq!(one.state().q.map(|x| 8.0 * x), scaled.state().q);
            assert_eq!(one.state().p.map(|p| 64.0 * p), scaled.state().p);
            let shown = [one.state_on_constraint()?.p.map(|p| 64.0 * p), scaled.state_on_constraint()?.p];
            assert_eq!(shown[0], shown[1]);
        )* };
    }
    every!(same);
    Ok(())
}

/// Constraints in other units, each in its own: the same bits.
#[test]
fn constraints_have_units_of_their_own() -> Result<(), StepError> {
    #[hamiltonian(constraint = [
        512.0 * (q[0] * q[0] + q[1] * q[1] - l[0] * l[0]) / 2.0,
        ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - l[1] * l[1]) / 256.0
    ])]
    fn other(q: [f64; 4], p: [f64; 4], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0])
            + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1])
            + g * (m[0] * q[1] + m[1] * q[3])
    }
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = DOUBLE.integrator($method, 0.02, released());
            let mut scaled = Other { m: M, l: L, g: 9.81 }.integrator($method, 0.02, released());
            one.advance(300)?;
            scaled.advance(300)?;
            assert_eq!(one.state(), scaled.state());
        )* };
    }
    every!(same);
    Ok(())
}

#[test]
fn single_precision() -> Result<(), StepError> {
    #[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] - l * l) / 2.0])]
    fn short(q: [f32; 2], p: [f32; 2], m: f32, l: f32, g: f32) -> f32 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
    }
    let system = Short { m: 0.7, l: 1.0, g: 9.81 };
    macro_rules! keeps {
        ($($method:expr => $energy:literal),*) => { $(
            let mut sim = system.integrator($method, 0.01_f32, State::new([0.6, -0.8], [0.0, 0.0]));
            let energy = sim.energy();
            sim.advance(10_000)?;
            let q = sim.state().q;
            assert!((q[0].hypot(q[1]) - 1.0).abs() < 3e-7, "{q:?}");
            assert!((sim.energy() - energy).abs() < $energy, "{}", sim.energy() - energy);
        )* };
    }
    keeps!(Rattle => 1e-3, DiscreteGradient => 1e-5);
    Ok(())
}

#[test]
fn compensated_sums() -> Result<(), StepError> {
    let mut sim = DOUBLE.integrator(Suzuki4.of(Rattle), 0.005, released()).compensated();
    sim.advance(400)?;
    assert!(far(&sim.state(), &at_two()) < 1e-7);
    let mut sim = DOUBLE.integrator(DiscreteGradient, 0.02, released()).compensated();
    let energy = sim.energy();
    sim.advance(1000)?;
    assert!((sim.energy() - energy).abs() < 3e-14);
    Ok(())
}
