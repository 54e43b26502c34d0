//! Corrections of invariants where a coordinate hardly moves. A coordinate that the energy does not read must not correct the rounding of the energy.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A hill of height 1. Far from it the flight is free, and the force on the momentum is below its last digit.
#[hamiltonian]
fn hill(q: f64, p: f64) -> f64 {
    p * p / 2.0 + (-q * q).exp()
}

/// The same motion as a field.
#[vector_field(keeps(energy = x[1] * x[1] / 2.0 + (-x[0] * x[0]).exp()))]
fn slope(x: [f64; 2]) -> [f64; 2] {
    [x[1], 2.0 * x[0] * (-x[0] * x[0]).exp()]
}

/// The start of the flights, and their end: e⁻³⁶ is below the last digit of the energy.
const START: f64 = -9.5;
const END: f64 = -6.0;

/// Returns the largest distance of a flight with unit speed from q₀ + t, in units of the rounding of a position.
fn error<M: Method<Hill>>(method: M, h: f64) -> f64 {
    let mut sim = Hill.integrator(method, h, State::new(START, 1.0));
    let mut error = 0.0_f64;
    while sim.state().q < END - h {
        sim.step().unwrap();
        error = error.max((sim.state().q - START - sim.time()).abs());
    }
    error / (f64::EPSILON * START.abs())
}

/// Returns the largest distance of a flight of the field from q₀ + t, in units of the rounding of a position.
fn error_of_field<M: Method<Slope>>(method: M, h: f64) -> f64 {
    let mut sim = Slope.integrator(method, h, FlowState::new([START, 1.0]));
    let mut error = 0.0_f64;
    while sim.state().x[0] < END - h {
        sim.step().unwrap();
        error = error.max((sim.state().x[0] - START - sim.time()).abs());
    }
    error / (f64::EPSILON * START.abs())
}

/// Errors of some 10¹¹ roundings if a rounding of the energy moves the position. The drift of many steps is removed after the step 1024.
#[test]
fn free_flights_stay_free() {
    for h in [0.35, 0.05, 0.0034] {
        // Sums of positions are rounded once a step.
        let most = 4.0 + (END - START) / h;
        let errors = [
            error(Projection(DOP853, Energy), h),
            error(Projection(RK4, Energy), h),
            error(Relaxation(RK4), h),
            error(DiscreteGradient, h),
            error(FourthOrder(DiscreteGradient), h),
            error(Gonzalez, h),
            error_of_field(Projection(RK4, Integrals), h),
            error_of_field(Relaxation(RK4), h),
            error_of_field(DiscreteGradient, h),
            error_of_field(FourthOrder(DiscreteGradient), h),
        ];
        assert!(errors.iter().all(|error| *error <= most), "{h}: {errors:?}");
    }
}

/// Errors of 4·10⁻³ in single precision otherwise, where positions are rounded by 10⁻⁶.
#[test]
fn free_flights_stay_free_in_single_precision() {
    for h in [0.15_f32, 0.01] {
        let (mut error, start) = (0.0_f32, -5.0);
        let mut sim = Integrator::new(Hill, Projection(RK4, Energy), h, State::new(start, 1.0_f32));
        while sim.state().q < -3.9 - h {
            sim.step().unwrap();
            error = error.max((sim.state().q - start - sim.time()).abs());
        }
        assert!(error <= f32::EPSILON * 5.0 * (4.0 + 1.1 / h), "{h}: {error:.1e}");
    }
}

#[test]
fn series_of_free_flights_stay_free() {
    for start in [-7.0, -8.0, START] {
        let mut sim = Hill.taylor(Projection(Taylor::default(), Energy), State::new(start, 1.0));
        sim.advance_to(END - start).unwrap();
        let error = (sim.state().q - END).abs();
        assert!(error <= 4.0 * f64::EPSILON * start.abs(), "{start}: {error:.1e}");
    }
}

/// Control: where the hill turns the motion round, the energy is led back by all methods, and by RK4 alone it is not.
#[test]
fn energies_at_the_hill_are_corrected() {
    fn change<M: Method<Hill>>(method: M) -> f64 {
        let mut sim = Hill.integrator(method, 0.05, State::new(-4.0, 1.0));
        let energy = sim.energy();
        sim.advance(200).unwrap();
        assert!(sim.state().q < -4.0 && sim.state().p < 0.0);
        (sim.energy() - energy).abs()
    }
    assert!(change(RK4) > 1e-9);
    let corrected = [change(Projection(RK4, Energy)), change(Relaxation(RK4)), change(DiscreteGradient)];
    assert!(corrected.iter().all(|change| *change < 1e-15), "{corrected:?}");
}
