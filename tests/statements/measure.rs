//! S15: |H|⁻⁽ⁿ⁺¹⁾ η∧(dη)ⁿ is an invariant measure of a contact flow where H ≠ 0, and of a contact map with H₁ = λH₀.

use crate::derivative::Derivative;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::Dual;
use geoint_tests::scenes::contact_field;

/// An oscillator whose friction grows with the action: the piece as²/2 has the factor H₁/H₀ of its own energy, and the oscillator has the factor 1.
#[contact_hamiltonian(split = "p * p / 2.0 + q * q / 2.0 | a * s * s / 2.0")]
fn quadratic_dissipation(q: f64, p: f64, s: f64, a: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + a * s * s / 2.0
}

/// An oscillator with friction, one piece with an exact flow.
#[contact_hamiltonian]
fn damped_oscillator(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

/// An oscillator whose sphere H = 0 is invariant.
#[contact_hamiltonian]
fn cosmological(q: f64, p: f64, s: f64, r: f64) -> f64 {
    (p * p + q * q + s * s) / 2.0 - r
}

/// Differentiates one step of an integrator for one degree of freedom.
fn step_of<S, M>(system: S, method: M, h: f64, [q, p, s]: [f64; 3]) -> Derivative
where
    S: geoint_runtime::Contact<Dual, Coordinates = Dual>,
    M: Method<S, Dual>,
{
    Derivative::of(vec![q, p, s], |x| {
        let mut sim = system.integrator(method, h.into(), ContactState::new(x[0], x[1], x[2]));
        sim.step().expect("a step");
        let ContactState { q, p, s, .. } = sim.state();
        vec![q, p, s]
    })
}

#[test]
fn a_piece_has_the_factor_of_its_own_energy() {
    let (a, h, [q, p, s]) = (0.7, 0.3, [0.5, 0.4, 1.2]);
    let step = step_of(QuadraticDissipation { a: Dual::from(a) }, ContactSplitting, h, [q, p, s]);
    // The action after half a step of the oscillator: s + (q₁p₁ − q₀p₀)/2. A step of as²/2 then divides it by 1 + ahs/2.
    let (sin, cos) = (h / 2.0).sin_cos();
    let half = s + ((q * cos + p * sin) * (p * cos - q * sin) - q * p) / 2.0;
    let outside = 1.0 / (1.0 + a * h * half / 2.0).powi(2);
    let factor = step.factor();
    assert!((factor - outside).abs() < 1e-15 && step.excess() < 1e-14, "{factor} {outside} {:e}", step.excess());
    // Control: the energy of the whole system has another ratio.
    let energy = |x: &[f64]| QuadraticDissipation { a }.energy(&ContactState::new(x[0], x[1], x[2]));
    let ratio = energy(&step.after) / energy(&step.before);
    assert!((ratio - factor).abs() > 1e-4, "{ratio} {factor}");
}

/// S15: det DΦ (H₀/H₁)ⁿ⁺¹ = 1 for a flow. A contact map keeps this measure if and only if H₁ = λH₀.
#[test]
fn a_flow_keeps_the_measure_and_no_other_power() {
    let start = [0.4, -0.3, 0.2];
    let system = Cosmological { r: Dual::from(1.0) };
    let flow = Derivative::of(start.to_vec(), |x| {
        extrapolated(|t, x| contact_field(&system, t, x), 0.0.into(), x.to_vec(), 1.0.into(), 8)
    });
    let energy = |x: &[f64]| Cosmological { r: 1.0 }.energy(&ContactState::new(x[0], x[1], x[2]));
    let decay = energy(&flow.after) / energy(&flow.before);
    assert!((flow.volume() - 0.280_007_51).abs() < 5e-9, "{}", flow.volume());
    let off = [decay.powi(2) - flow.volume(), decay - flow.factor()];
    assert!(off.iter().all(|off| off.abs() < 1e-12), "{off:?}");
    assert!(Cosmological::REPORT.contains("|H|^−2 is the density of an invariant measure where H ≠ 0"));
    // Controls: the volume itself, and the power n, are not invariant.
    assert!((flow.volume() - 1.0).abs() > 0.7 && (flow.volume() / decay - 1.0).abs() > 0.4);
    // Steps of two pieces are contact maps, but H₁ = λH₀ holds to their order only.
    let defect = |h: f64| {
        let step = step_of(system, ContactSplitting, h, start);
        assert!(step.excess() < 1e-14, "{:e}", step.excess());
        (step.volume() * (energy(&step.before) / energy(&step.after)).powi(2) - 1.0).abs()
    };
    let order = (defect(0.05) / defect(0.025)).log2();
    assert!((order - 3.0).abs() < 0.05, "{order}");
}

/// A method with an exact flow keeps the measure at any step. The discrete gradient has H₁ = λH₀ and no contact form, so its volume is not λ².
#[test]
fn the_law_of_decay_is_the_invariance_of_the_measure() {
    let (gamma, h, start) = (0.4, 1.3, [0.7, 0.5, 0.3]);
    let energy = |x: &[f64]| DampedOscillator { gamma }.energy(&ContactState::new(x[0], x[1], x[2]));
    let off = |step: &Derivative| {
        let decay = energy(&step.after) / energy(&step.before);
        assert!((decay - (-gamma * h).exp()).abs() < 1e-14, "{decay}");
        (step.volume() / decay.powi(2) - 1.0).abs()
    };
    let system = DampedOscillator { gamma: Dual::from(gamma) };
    let exact = step_of(system, ContactSplitting, h, start);
    assert!(off(&exact) < 1e-14, "{:e}", off(&exact));
    let control = step_of(system, ContactDiscreteGradient, h, start);
    assert!(off(&control) > 1e-3, "{:e}", off(&control));
}
