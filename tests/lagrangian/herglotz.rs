//! Herglotz' principle: orders of the methods, and quantities that decay by a known law.

use crate::references::BRAKED;
use crate::systems::*;
use geoint_runtime::Contact;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{MixedDerivatives, VelocityForm, VelocityStage};
use geoint_runtime::space::{Array, Snapshot, Square};

/// The talk's damped oscillator.
#[lagrangian]
fn oscillator(q: f64, v: f64, s: f64, a: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - a * s
}

/// The same as the talk's second picture has it.
#[contact_hamiltonian]
fn oscillator_by_hand(q: f64, p: f64, s: f64, a: f64) -> f64 {
    0.5 * p * p + 0.5 * q * q + a * s
}

/// A particle under a central force, with friction that grows with the action.
#[lagrangian]
fn central(q: [f64; 3], v: [f64; 3], s: f64, m: f64, a: f64) -> f64 {
    let r2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
    0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 0.25 * r2 * r2 - a * s - 0.05 * s * s
}

/// q, p and s at the end of a run.
fn end<S: Contact, M: Method<S>>(system: S, method: M, start: S::State, h: f64, time: f64) -> Vec<f64> {
    let mut sim = Integrator::new(system, method, h, start);
    sim.advance((time / h).round() as u64).expect("steps");
    let (_, z, s) = sim.state().parts();
    [Array::as_slice(&z), &[s]].concat()
}

fn far(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs()))
}

/// Errors in (q, p, s) at h = 0.1, 0.05 and 0.025, as another program found them.
#[test]
fn every_order_has_the_published_errors() {
    fn same(found: [f64; 3], expected: [f64; 3], within: f64) {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < within * expected + 2e-14, "{found:.3e} in place of {expected:.3e}");
        }
    }
    fn rows<S: Contact>(system: S, start: S::State, time: f64, two: [f64; 3], three: [f64; 3])
    where
        ContactGauss<2>: Method<S>,
        ContactGauss<3>: Method<S>,
        ContactGauss<6>: Method<S>,
    {
        let exact = end(system, ContactGauss::<6>, start, 0.0125, time);
        let errors = |method: &dyn Fn(f64) -> Vec<f64>| [0.1, 0.05, 0.025].map(|h| far(&method(h), &exact));
        same(errors(&|h| end(system, ContactGauss::<2>, start, h, time)), two, 0.05);
        same(errors(&|h| end(system, ContactGauss::<3>, start, h, time)), three, 0.1);
    }
    let system = Growing { a: 0.1 };
    rows(system, system.at(1.0, 0.5, 0.3), 2.0, [5.90e-8, 3.68e-9, 2.30e-10], [1.8e-11, 2.8e-13, 5e-15]);
    let system = Fading { a: 0.1 };
    rows(system, system.at([1.0, 0.2], [0.1, 0.8], 0.0), 3.0, [1.55e-6, 9.69e-8, 6.06e-9], [6.0e-10, 9.3e-12, 1.5e-13]);
    rows(BRAKED, BRAKED.at([0.0, 1.4], [0.0, 0.0], 0.0), 2.0, [5.6e-4, 1.2e-5, 8.0e-7], [2.4e-5, 2.1e-7, 3.0e-9]);
}

/// The largest error of q in the talk's damped oscillator.
#[test]
fn the_oscillator_of_the_talk() {
    fn error<M: Method<Oscillator>>(method: M, a: f64) -> f64 {
        let system = Oscillator { a };
        let mut sim = system.integrator(method, 0.1, system.at(-0.25, 0.75, 0.0));
        let mut error: f64 = 0.0;
        for n in 1..=if a < 1.0 { 500 } else { 150 } {
            sim.step().expect("a step");
            let t = 0.1 * f64::from(n);
            let (q, v) = (-0.25, 0.75);
            let rate = 1.0 - a * a / 4.0;
            let exact = if rate > 0.0 {
                let w = rate.sqrt();
                (-a * t / 2.0).exp() * (q * (w * t).cos() + (v + a * q / 2.0) / w * (w * t).sin())
            } else {
                (-a * t / 2.0).exp() * (q + (v + a * q / 2.0) * t)
            };
            error = error.max((sim.state().q - exact).abs());
        }
        error
    }
    for (a, one, two, three) in [
        (0.01, 2.46e-2, 4.10e-6, 2.93e-10),
        (0.1, 4.75e-3, 7.82e-7, 5.43e-11),
        (1.0, 9.82e-4, 2.59e-7, 4.81e-12),
        (2.0, 2.51e-3, 2.92e-6, 1.28e-9),
    ] {
        let found = [error(ContactGauss::<1>, a), error(ContactGauss::<2>, a), error(ContactGauss::<3>, a)];
        for (found, expected) in found.into_iter().zip([one, two, three]) {
            assert!((found - expected).abs() < 0.05 * expected, "{found:.3e} in place of {expected:.3e} for {a}");
        }
    }
}

/// The talk's exercise: both pictures are one system.
#[test]
fn two_pictures_are_one() {
    let (system, by_hand) = (Oscillator { a: 0.3 }, OscillatorByHand { a: 0.3 });
    let start = system.at(-0.25, 0.75, 0.1);
    let one = end(system, ContactGauss::<2>, start, 0.1, 10.0);
    assert!(far(&one, &end(by_hand, ContactGauss::<2>, start, 0.1, 10.0)) < 1e-15);
    assert!(far(&one, &end(system, BlanesMoanSrkn14a, start, 0.02, 10.0)) < 1e-5);
}

#[test]
fn one_stage_is_the_midpoint_rule() {
    let start = BRAKED.at([0.0, 1.4], [0.0, 0.0], 0.0);
    let found = far(&end(BRAKED, ContactGauss::<1>, start, 0.02, 2.0), &end(BRAKED, ContactMidpoint, start, 0.02, 2.0));
    assert!(found < 1e-13, "{found:e}");
    let system = Growing { a: 0.1 };
    let start = system.at(1.0, 0.5, 0.3);
    let found = far(&end(system, ContactGauss::<1>, start, 0.1, 2.0), &end(system, ContactMidpoint, start, 0.1, 2.0));
    assert!(found < 1e-14, "{found:e}");
}

/// A step of `ContactGauss` multiplies ds − p dq by a factor. Control: the contact discrete gradient is no contact map.
#[test]
fn steps_are_contact_maps() {
    let system = Fading { a: 0.1 };
    let defect = |step: &dyn Fn([f64; 5]) -> [f64; 5]| {
        let x = [1.0, 0.2, 0.1, 0.8, 0.3];
        let slope = |k: usize| {
            let d = 2e-3;
            let at = |by: f64| {
                let mut x = x;
                x[k] += by * d;
                step(x)
            };
            let weights = [(1.0, 0.75), (2.0, -0.15), (3.0, 1.0 / 60.0)];
            std::array::from_fn::<f64, 5, _>(|i| {
                weights.iter().map(|(by, w)| w * (at(*by)[i] - at(-by)[i])).sum::<f64>() / d
            })
        };
        let end = step(x);
        // The form pulled back, an entry a coordinate: all are multiples of that before.
        let form: Vec<f64> = (0..5)
            .map(|k| {
                let slope = slope(k);
                slope[4] - end[2] * slope[0] - end[3] * slope[1]
            })
            .collect();
        let before = [-x[2], -x[3], 0.0, 0.0, 1.0];
        (0..5).fold(0.0, |far, k| f64::max(far, (form[k] - form[4] * before[k]).abs()))
    };
    fn stepped<M: Method<Fading>>(system: Fading, method: M, x: [f64; 5]) -> [f64; 5] {
        let start = ContactState::new([x[0], x[1]], [x[2], x[3]], x[4]);
        end(system, method, start, 0.4, 0.4).try_into().expect("five")
    }
    let found = defect(&|x| stepped(system, ContactGauss::<2>, x));
    assert!(found < 1e-11, "{found:e}");
    let found = defect(&|x| stepped(system, ContactGauss::<3>, x));
    assert!(found < 1e-11, "{found:e}");
    let found = defect(&|x| stepped(system, ContactDiscreteGradient, x));
    assert!(found > 1e-5, "{found:e}");
}

/// The angular momentum keeps its direction while it decays: all its entries fall by one factor.
#[test]
fn dissipated_momenta_decay_alike() -> Result<(), StepError> {
    let system = Central { m: 1.3, a: 0.2 };
    let momentum = |state: &ContactState<[f64; 3]>| {
        let (q, p) = (state.q, state.p);
        [q[1] * p[2] - q[2] * p[1], q[2] * p[0] - q[0] * p[2], q[0] * p[1] - q[1] * p[0]]
    };
    let start = system.at([1.0, 0.2, -0.1], [0.1, 0.8, 0.3], 0.0);
    let mut sim = system.integrator(ContactGauss::<2>, 0.2, start);
    let before = momentum(&start);
    sim.advance(50)?;
    let after = momentum(&sim.state());
    let factor = after[2] / before[2];
    assert!(factor < 0.7, "{factor}");
    assert!((0..3).all(|i| (after[i] - factor * before[i]).abs() < 1e-14), "{before:?} {after:?}");
    // H decays by the same factor to the order of the method alone.
    let strayed = |h: f64| -> Result<f64, StepError> {
        let mut sim = system.integrator(ContactGauss::<2>, h, start);
        let (energy, before) = (sim.energy(), momentum(&start));
        sim.advance((4.0 / h).round() as u64)?;
        Ok((sim.energy() / energy - momentum(&sim.state())[2] / before[2]).abs())
    };
    let order = (strayed(0.1)? / strayed(0.05)?).log2();
    assert!((order - 4.0).abs() < 0.2, "{order}");
    Ok(())
}

/// A step that is so long that the contact form would change its sign is refused.
#[test]
fn long_steps_are_refused() {
    let system = Oscillator { a: 3.0 };
    let start = system.at(-0.25, 0.75, 0.0);
    let mut sim = system.integrator(ContactGauss::<1>, 1.0, start);
    assert!(sim.step().is_err());
    assert_eq!(sim.state(), start);
}

#[test]
fn reports_name_what_decays() {
    let report = Central::<f64>::REPORT;
    let decaying = report.split("\nDecaying by the factor ").nth(1).expect("a section");
    assert!(decaying.starts_with("exp(−∫ (s/10 + a) dt)"), "{report}");
    assert_eq!(decaying.lines().filter(|line| line.contains("angular momentum")).count(), 3, "{report}");
    assert!(decaying.contains("- H: it does not read time"), "{report}");
    assert!(!Braked::<f64>::REPORT.contains("angular momentum"));
    assert!(Braked::<f64>::REPORT.contains("Decaying by the factor e^(−(gamma)·t)"), "{}", Braked::<f64>::REPORT);
    // Time in H, and a position everywhere.
    assert!(!Driven::<f64>::REPORT.contains("Decaying by the factor"), "{}", Driven::<f64>::REPORT);
}

/// Friction in proportion to the mass.
#[lagrangian(rayleigh = 0.5 * c * v * v)]
fn proportional(q: f64, v: f64, m: f64, c: f64) -> f64 {
    0.5 * m * v * v - 0.25 * q.powi(4)
}

/// −½v²: what is wrong with its sign is said, and nothing else is.
#[lagrangian]
fn concave(q: f64, v: f64) -> f64 {
    0.5 * q * q - 0.5 * v * v
}

#[test]
fn reports_say_what_is_unusual() -> Result<(), StepError> {
    assert!(Concave::REPORT.contains("negative definite: −L has the same equations"), "{}", Concave::REPORT);
    assert!(!Oscillator::<f64>::REPORT.contains("negative definite"));
    assert!(Growing::<f64>::REPORT.contains("momenta read the action"), "{}", Growing::<f64>::REPORT);
    assert!(!Fading::<f64>::REPORT.contains("momenta read the action"));
    assert!(Proportional::<f64>::REPORT.contains("with γ = c/m,"), "{}", Proportional::<f64>::REPORT);
    assert!(!RubbedArm::<f64>::REPORT.contains("with γ = "));
    let mut sim = Concave.integrator(Gauss::<3>, 0.05, Concave.at(1.0, 0.0));
    sim.advance(40)?;
    assert!((sim.state().q - 2_f64.cos()).abs() < 1e-10);
    Ok(())
}

/// Where the action acts on the force, and on nothing else that moves.
#[lagrangian]
fn pulled(q: f64, v: f64, s: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - 0.1 * s * q
}

/// Second derivatives of all kinds.
#[lagrangian]
fn woven(q: f64, v: f64, s: f64) -> f64 {
    0.5 * v * v * (1.0 + q * q) * (1.0 + 0.2 * s) - 0.5 * q * q - 0.1 * s * q
}

/// A particle whose inertia grows with its speed.
#[lagrangian]
fn stiffening(q: f64, v: f64) -> f64 {
    0.5 * v * v + 0.1 * v.powi(4) + 0.03 * v.powi(6) - 0.5 * q * q
}

/// The same with friction.
#[lagrangian(rayleigh = c * v * v / 2.0)]
fn rubbing(q: f64, v: f64, c: f64) -> f64 {
    0.5 * v * v + 0.1 * v.powi(4) + 0.03 * v.powi(6) - 0.5 * q * q
}

/// `MIXED` lists the mixed second derivatives of L that do not vanish. Steps do not multiply by the other derivatives, so these must be zero.
#[test]
fn second_derivatives_that_are_left_out_are_zero() {
    fn check<S: VelocityForm>(system: S, s: S::Action, expected: MixedDerivatives) {
        let none = S::Array::zero();
        let mut stage = VelocityStage {
            lagrangian: 0.0,
            momentum: none,
            force: none,
            decay: 0.0,
            derivatives: [S::Array::fill(none); 4],
            by_action: [none; 2],
            decay_by_action: 0.0,
        };
        let (mut q, mut v) = (none, none);
        for (i, (q, v)) in q.as_mut_slice().iter_mut().zip(v.as_mut_slice()).enumerate() {
            (*q, *v) = (0.7 + 0.5 * i as f64, 0.4 - 0.9 * i as f64);
        }
        system.stage(&system.stage_constants(), 0.2, &q, &v, &s, &mut stage);
        let moves = |matrix: &Square<S::Array>| {
            S::Array::entries_of::<S::Array>(matrix).iter().any(|row| row.as_slice().iter().any(|x| *x != 0.0))
        };
        let [by_q, _, _, by_v] = &stage.derivatives;
        let [momentum_by_s, force_by_s] = stage.by_action.map(|by| by.as_slice().iter().any(|x| *x != 0.0));
        let [momentum_by_q, force_by_v] = [moves(by_q), moves(by_v)];
        assert_eq!(MixedDerivatives { momentum_by_q, momentum_by_s, force_by_v, force_by_s }, expected);
        assert_eq!(S::MIXED, expected);
    }
    let none = MixedDerivatives { momentum_by_q: false, momentum_by_s: false, force_by_v: false, force_by_s: false };
    let of_position = MixedDerivatives { momentum_by_q: true, force_by_v: true, ..none };
    check(Fading { a: 0.1 }, 0.3, none);
    check(BRAKED, 0.3, of_position);
    check(Growing { a: 0.1 }, 0.3, MixedDerivatives { momentum_by_s: true, ..none });
    check(Pulled, 0.3, MixedDerivatives { force_by_s: true, ..none });
    check(Woven, 0.3, MixedDerivatives { momentum_by_s: true, force_by_s: true, ..of_position });
    // Without an action. Friction alone is ∂f/∂v.
    check(Stiffening, (), none);
    check(Rubbing { c: 0.1 }, (), MixedDerivatives { force_by_v: true, ..none });
}
