//! Amplitudes from 10⁻²⁹⁰ to 10²⁹⁰ are units: steps have the same digits, or the refusal names the scale of the energy.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn oscillator(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0
}

#[hamiltonian]
fn quartic(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q.powi(4) / 4.0
}

/// Exponents of the units. The energy is a normal number for the first four exponents, and out of range for the others.
const ORDINARY: [i32; 4] = [-498, -332, 332, 498];
const EXTREME: [i32; 6] = [-964, -664, -532, 532, 664, 964];

/// Returns the state after 200 steps from the amplitude 2ᵏ, in units of the amplitude.
fn motion<M: Method<Oscillator>>(method: M, k: i32) -> Result<[f64; 2], StepError> {
    let unit = 2.0_f64.powi(k);
    let system = Oscillator { m: 1.3, k: 0.7 };
    let mut sim = system.integrator(method, 0.1, State::new(unit, 0.5 * unit));
    sim.advance(200)?;
    Ok([sim.state().q / unit, sim.state().p / unit])
}

/// Checks that a method needs the energy where `needs_energy`, and has the same digits at all other amplitudes.
fn check<M: Method<Oscillator>>(name: &str, method: M, needs_energy: bool) {
    let expected = motion(method, 0).unwrap();
    for k in ORDINARY.into_iter().chain(EXTREME) {
        match motion(method, k) {
            Ok(found) => {
                let off = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
                assert!(off < 1e-13, "{name}, 2^{k}: off by {off:.1e}");
                assert!(!(needs_energy && EXTREME.contains(&k)), "{name}, 2^{k}");
            }
            Err(StepError { t: 0.0, failure: Failure::OutOfRange, .. }) if needs_energy && EXTREME.contains(&k) => {}
            Err(error) => panic!("{name}, 2^{k}: {error}"),
        }
    }
}

#[test]
fn amplitudes_are_units() {
    check("RK4", RK4, false);
    check("StormerVerlet", StormerVerlet, false);
    check("Gauss", Gauss::<2>, false);
    check("DiscreteGradient", DiscreteGradient, false);
    check("MeanValue", MeanValue::<3>, false);
    check("Projection", Projection(RK4, Energy), true);
    check("Relaxation", Relaxation(RK4), true);
    check("FourthOrder", FourthOrder(DiscreteGradient), true);
    check("Gonzalez", Gonzalez, true);
    check("composed", Yoshida4.of(Gonzalez), true);
}

#[test]
fn other_runs_name_the_scale() {
    let system = Oscillator { m: 1.3, k: 0.7 };
    for unit in [1e-290, 1e-160, 1e160, 1e290] {
        let start = State::new(unit, 0.5 * unit);
        let refused = system.adaptive(Projection(DOP853, Energy), 1e-9, start).advance_to(5.0);
        assert_eq!(refused.map_err(|error| (error.t, error.failure)), Err((0.0, Failure::OutOfRange)), "{unit}");
        let refused = system.taylor(Projection(Taylor::default(), Energy), start).advance_to(5.0).unwrap_err();
        assert!(refused.to_string().contains("is too small or too large for the scalar"), "{refused}");
    }
    // The energy has the fourth power of the amplitude.
    for unit in [1e-100, 1e100] {
        let mut sim = Quartic.integrator(Projection(RK4, Energy), 0.05 / unit, State::new(unit, 0.5 * unit * unit));
        assert_eq!(sim.step(), Err(StepError::new(Failure::OutOfRange, 0.0, 0.05 / unit)), "{unit}");
    }
    let mut sim = Integrator::new(Quartic, Relaxation(RK4), 1e9_f32, State::new(1e-10_f32, 0.0));
    assert_eq!(sim.step(), Err(StepError::new(Failure::OutOfRange, 0.0, 1e9)));
}

/// An energy of zero at rest is not reported as out of range.
#[test]
fn rest_is_no_matter_of_scale() {
    let system = Oscillator { m: 1.3, k: 0.7 };
    for start in [State::new(0.0, 0.0), State::new(0.0, 1.0), State::new(1e-300, 1.0)] {
        system.integrator(Projection(RK4, Energy), 0.1, start).advance(10).unwrap();
    }
}

/// The shortest step of an adaptive run scales with the unit of time.
#[test]
fn fast_oscillations_adapt() {
    for rate in [1e-100, 1.0, 1e60, 1e100, 1e150] {
        let system = Oscillator { m: 1.0 / rate, k: rate };
        let mut sim = system.adaptive(DOP853, 1e-9, State::new(1.0, 0.0));
        sim.advance_to(3.0 / rate).unwrap();
        let error = (sim.state().q - 3.0_f64.cos()).abs();
        assert!(error < 1e-10, "{rate}: {error:.1e}");
    }
}
