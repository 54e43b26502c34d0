//! Numbers in messages: very large and very small ones have an exponent.

use geoint_runtime::prelude::*;

#[hamiltonian]
fn oscillator(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0
}

#[test]
fn tolerances() {
    let message = |tolerance: f64| {
        let error = Oscillator.adaptive(DOP853, tolerance, State::new(1.0, 0.0)).step().unwrap_err();
        error.to_string()
    };
    assert!(message(1e300).contains("the tolerance 1e300 allows"), "{}", message(1e300));
    assert!(message(-3e-9).contains("the tolerance -3e-9 is not"), "{}", message(-3e-9));
    // Controls.
    assert!(message(2.5).contains("the tolerance 2.5 allows"));
    assert!(message(0.0).contains("the tolerance 0 is not"));
    assert!(message(f64::INFINITY).contains("the tolerance inf is not"));
}

#[test]
fn times_and_lengths() {
    let at = |t: f64| Oscillator.integrator(RK4, 0.1, State::at(t, 1.0, f64::NAN)).step().unwrap_err().to_string();
    assert!(at(1e-300).contains("the state at t = 1e-300 has"), "{}", at(1e-300));
    assert!(at(-2e40).contains("the state at t = -2e40 has"), "{}", at(-2e40));
    assert!(at(123_456.5).contains("the state at t = 123456.5 has"), "{}", at(123_456.5));
    let mut sim = Oscillator.adaptive(DOP853, 1e-6, State::new(1.0, 0.0)).steps_between(1e200, 1e100);
    let message = sim.step().unwrap_err().to_string();
    assert!(
        message.contains("longer than 1e200 and shorter than 1e100") && message.contains("(1e100, 1e200)"),
        "{message}"
    );
}
