//! Names in the user's crate that generated code uses as well.
use geoint_runtime::prelude::{
    DiscreteGradient, StepError, StormerVerlet, contact_hamiltonian, hamiltonian, lagrangian, vector_field,
};
use geoint_runtime::{ContactState, FlowState, FourthOrder, Integrals, Projection, Taylor};

#[derive(Clone, Copy)]
struct Real;
struct Option;
struct Array;
mod slope {}
mod core {}
#[allow(non_camel_case_types)]
struct f64x;

#[hamiltonian]
fn oscillator(q: f64, p: f64, h: f64, v0: f64, prepared: f64, start: f64, increment: f64, dq: f64, new0: f64) -> f64 {
    0.5 * p * p * h + 0.5 * v0 * q * q * prepared + start * q.powi(4) + increment * q + dq * q.exp() + new0 * q
}

#[test]
fn compiles_and_means_what_it_says() {
    let _ = (Real, Option, Array, f64x);
    let system = Oscillator { h: 1.0, v0: 2.0, prepared: 1.0, start: 0.1, increment: 0.2, dq: 0.3, new0: 0.4 };
    let state = geoint_runtime::State::new(0.5, 0.25);
    let energy = oscillator(0.5, 0.25, 1.0, 2.0, 1.0, 0.1, 0.2, 0.3, 0.4);
    assert!((system.energy(&state) - energy).abs() < 1e-14);
    system.integrator(DiscreteGradient, 0.01, state).advance(10).unwrap();
    system.integrator(StormerVerlet, 0.01, state).advance(10).unwrap();
}

/// Structs with the names of generic parameters of generated code.
mod structs {
    use super::*;

    #[hamiltonian]
    pub(super) fn p(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + k * q[0].powi(4) + q[1].cos() + q[0] * p[1] - q[1] * p[0]
    }

    #[hamiltonian(name = NEARLY)]
    pub(super) fn nearly(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + k * q[0].powi(4) + q[1].abs()
    }

    #[contact_hamiltonian]
    pub(super) fn m(q: f64, p: f64, s: f64, k: f64) -> f64 {
        p * p / 2.0 + k * q * q + 0.1 * s
    }

    #[lagrangian]
    pub(super) fn t(q: f64, v: f64, k: f64) -> f64 {
        v * v / 2.0 - k * q * q
    }

    #[vector_field(keeps(radius = x[0] * x[0] + x[1] * x[1]))]
    pub(super) fn coefficients(x: [f64; 2], k: f64) -> [f64; 2] {
        [k * x[1], -k * x[0]]
    }

    #[hamiltonian]
    pub(super) fn scalar(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + k / (q[0] - q[1])
    }
}

/// Another type `P` in the scope of the function, which is an alias for its arguments.
mod aliases {
    use super::*;
    type P = [f64; 2];

    #[hamiltonian(type P = [f64; 2])]
    pub(super) fn pair(q: P, p: P) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0].powi(4) + q[1].cos()
    }
}

#[test]
fn structs_have_names_of_generic_parameters() -> Result<(), StepError> {
    let start = geoint_runtime::State::new([0.5, 0.2], [0.25, 0.1]);
    let (rotating, at_tolerance) = (structs::P { k: 0.1 }, Taylor::default());
    let mut series = rotating.taylor(at_tolerance, start);
    series.advance_to(1.0)?;
    assert!((rotating.energy(&series.state()) - rotating.energy(&start)).abs() < 1e-13);
    let mut fourth = rotating.integrator(FourthOrder(DiscreteGradient), 0.1, start);
    fourth.advance(10)?;
    assert!((rotating.energy(&fourth.state()) - rotating.energy(&start)).abs() < 1e-13);
    structs::NEARLY { k: 0.1 }.integrator(FourthOrder(DiscreteGradient), 0.1, start).advance(3)?;
    structs::M { k: 0.1 }.integrator(StormerVerlet, 0.1, ContactState::new(0.5, 0.2, 0.0)).advance(3)?;
    structs::T { k: 0.1 }.integrator(StormerVerlet, 0.1, geoint_runtime::State::new(0.5, 0.2)).advance(3)?;
    structs::Scalar { k: 0.1 }.integrator(DiscreteGradient, 0.1, start).advance(3)?;
    let turning = structs::Coefficients { k: 1.0 };
    turning.taylor(Projection(at_tolerance, Integrals), FlowState::new([1.0, 0.0])).advance_to(1.0)?;
    aliases::Pair.taylor(at_tolerance, start).advance_to(1.0)
}
