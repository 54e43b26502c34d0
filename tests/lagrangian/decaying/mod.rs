//! Herglotz' principle where steps are solved for velocities: against energies by hand, orders, and laws.

mod scenes;

use geoint_runtime::Contact;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};
use scenes::*;

const M: [f64; 3] = [1.0, 0.8, 0.5];
const CHAIN: Chain = Chain { m: M, c: 0.3 };
const BENT: ([f64; 3], [f64; 3]) = ([0.5, 1.4, -0.3], [0.2, -0.5, 1.0]);

/// q, p and s at the end of a run.
fn end<S: Contact, T: Method<S>>(system: S, method: T, start: S::State, h: f64, time: f64) -> Vec<f64> {
    let mut sim = Integrator::new(system, method, h, start);
    sim.advance((time / h).round() as u64).expect("steps");
    let (_, z, s) = sim.state().parts();
    [Array::as_slice(&z), &[s]].concat()
}

fn far(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs()))
}

#[test]
fn reports_say_how_steps_are_solved() {
    let report = Chain::<f64>::REPORT;
    for line in [
        "steps are solved for v",
        "s acts back",
        "with 4 unknowns a stage",
        "the polarised one",
        "- H: it does not read time",
    ] {
        assert!(report.contains(line), "{line}: {report}");
    }
    let report = BrakedChain::<f64>::REPORT;
    for line in ["with 3 unknowns a stage", "`without_action` leaves it out"] {
        assert!(report.contains(line), "{line}: {report}");
    }
    assert!(!report.contains("Decaying by"), "{report}");
    let report = FadingTelescope::<f64>::REPORT;
    for line in
        ["- total momentum along x: ", "- total momentum along y: ", "- angular momentum: ", "exp(−∫ (s/10 + 0.2) dt)"]
    {
        assert!(report.contains(line), "{line}: {report}");
    }
    assert!(Stiff::<f64>::REPORT.contains("there is no discrete gradient"), "{}", Stiff::<f64>::REPORT);
}

/// A Lagrangian and its energy give the same map. The Lagrangian needs half of the unknowns.
#[test]
fn steps_are_those_of_the_energy() {
    let by_hand = ChainByHand { m: M, c: 0.3 };
    let start = CHAIN.at(BENT.0, BENT.1, 0.1);
    assert!((CHAIN.energy(&start) - by_hand.energy(&start)).abs() < 1e-14);
    macro_rules! same {
        ($($method:expr),*) => { $(
            let (one, other) = (end(CHAIN, $method, start, 0.05, 2.0), end(by_hand, $method, start, 0.05, 2.0));
            assert!(far(&one, &other) < 1e-12, "{one:?} {other:?}");
        )* };
    }
    same!(ContactMidpoint, ContactGauss::<1>, ContactGauss::<2>, ContactGauss::<3>);
    // The discrete gradient differs from the discrete gradient of the tree of H.
    let (one, other) = (
        end(CHAIN, ContactDiscreteGradient, start, 0.05, 2.0),
        end(by_hand, ContactDiscreteGradient, start, 0.05, 2.0),
    );
    let difference = far(&one, &other);
    assert!(difference > 1e-6 && difference < 0.05, "{difference:e}");
    let mut slopes = ([[0.0_f64; 3]; 2], 0.0);
    let mut expected = slopes;
    let z = [start.q, start.p];
    CHAIN.gradient(0.0, &z, &start.s, &mut slopes.0, &mut slopes.1);
    by_hand.gradient(0.0, &z, &start.s, &mut expected.0, &mut expected.1);
    assert!(far(Array::as_slice(&slopes.0), Array::as_slice(&expected.0)) < 1e-14);
    assert!((slopes.1 - expected.1).abs() < 1e-14);
}

/// Observes the order in all unknowns, with explicit time. In some steps s is solved for, in others it follows.
#[test]
fn orders() {
    fn observed<S: Contact, T: Method<S>>(system: S, method: T, start: S::State, h: f64) -> f64
    where
        ContactGauss<6>: Method<S>,
    {
        let exact = end(system, ContactGauss::<6>, start, 0.05, 1.0);
        let [one, two] = [h, h / 2.0].map(|h| far(&end(system, method, start, h, 1.0), &exact));
        (one / two).log2()
    }
    let braked = BrakedChain { m: M, c: 0.3 };
    let start = CHAIN.at(BENT.0, BENT.1, 0.1);
    let timed = braked.at(BENT.0, BENT.1, 0.1);
    macro_rules! orders {
        ($($method:expr, $order:literal, $h:literal;)*) => { $(
            for found in [observed(CHAIN, $method, start, $h), observed(braked, $method, timed, $h)] {
                assert!((found - $order).abs() < 0.1, "{} {found}", stringify!($method));
            }
        )* };
    }
    orders! {
        ContactMidpoint, 2.0, 0.025;
        ContactGauss::<2>, 4.0, 0.05;
        ContactGauss::<3>, 6.0, 0.1;
        ContactDiscreteGradient, 2.0, 0.025;
        Suzuki4.of(ContactDiscreteGradient), 4.0, 0.05;
    }
    let stiff = Stiff { c: 0.2 };
    let start = stiff.at(1.0, 0.3, 0.1);
    let found = observed(stiff, ContactGauss::<2>, start, 0.1);
    assert!((found - 4.0).abs() < 0.1, "{found}");
}

/// Numbers that were found by another program, in (q, p, s).
#[test]
fn errors_of_the_polarised_discrete_gradient() -> Result<(), StepError> {
    let system = PendulumWithAnother { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81 };
    let start = ContactState::new([0.0, 1.4, 0.0], [1.4, 0.0, 0.0], 0.1);
    assert!(far(&system.velocity(&start), &[0.0; 3]) < 1e-15, "{:?}", system.velocity(&start));
    let exact = end(system, ContactGauss::<6>, start, 0.01, 2.0);
    for (h, expected) in [(0.04, 7.74e-3), (0.02, 1.94e-3), (0.01, 4.84e-4), (0.005, 1.21e-4)] {
        let mut found = end(system, ContactDiscreteGradient, start, h, 2.0);
        assert!(found[5].abs() < 1e-14, "{}", found[5]);
        found[2] = exact[2];
        let error = far(&found, &exact);
        assert!((error / expected - 1.0).abs() < 0.05, "{error:.3e} in place of {expected:.3e}");
    }
    Ok(())
}

/// ds − p dq is multiplied by a factor, whatever reads s.
#[test]
fn steps_are_contact_maps() {
    fn defect<T: Method<Chain>>(method: T) -> f64 {
        let start = CHAIN.at(BENT.0, BENT.1, 0.1);
        let x = [start.q, start.p].concat().into_iter().chain([start.s]).collect::<Vec<f64>>();
        let step = |x: &[f64]| {
            let state = ContactState::new([x[0], x[1], x[2]], [x[3], x[4], x[5]], x[6]);
            end(CHAIN, method, state, 0.2, 0.2)
        };
        let after = step(&x);
        let form: Vec<f64> = (0..7)
            .map(|k| {
                let at = |by: f64| {
                    let mut x = x.clone();
                    x[k] += 2e-3 * by;
                    step(&x)
                };
                let weights = [(1.0, 0.75), (2.0, -0.15), (3.0, 1.0 / 60.0)];
                let values = weights.map(|(by, w)| (at(by), at(-by), w));
                let slope = |i: usize| values.iter().map(|(a, b, w)| w * (a[i] - b[i])).sum::<f64>() / 2e-3;
                slope(6) - (0..3).map(|i| after[3 + i] * slope(i)).sum::<f64>()
            })
            .collect();
        let before = [-x[3], -x[4], -x[5], 0.0, 0.0, 0.0, 1.0];
        (0..7).fold(0.0, |far, k| f64::max(far, (form[k] - form[6] * before[k]).abs()))
    }
    let [one, two, other] = [defect(ContactMidpoint), defect(ContactGauss::<2>), defect(ContactDiscreteGradient)];
    assert!(one < 1e-10 && two < 1e-10, "{one:e} {two:e}");
    assert!(other > 1e-5, "{other:e}");
}

/// Momenta decay by one common factor. The angular momentum is among them.
#[test]
fn dissipated_momenta_decay_alike() -> Result<(), StepError> {
    let system = FadingTelescope { m: [1.3, 0.7], c: 0.4 };
    let start = system.at([[0.1, 0.2], [0.9, -0.3]], [[0.2, 0.5], [0.4, 0.1]], 0.3);
    let momenta = |state: &ContactState<[[f64; 2]; 2]>| {
        let (q, p) = (state.q, state.p);
        let about = (0..2).map(|i| q[i][0] * p[i][1] - q[i][1] * p[i][0]).sum::<f64>();
        [p[0][0] + p[1][0], p[0][1] + p[1][1], about]
    };
    macro_rules! alike {
        ($($method:expr),*) => { $(
            let mut sim = system.integrator($method, 0.1, start);
            sim.advance(50)?;
            let (before, after) = (momenta(&start), momenta(&sim.state()));
            let factor = after[0] / before[0];
            assert!(factor < 0.6, "{factor}");
            assert!((0..3).all(|i| (after[i] - factor * before[i]).abs() < 1e-13), "{before:?} {after:?}");
        )* };
    }
    alike!(ContactMidpoint, ContactGauss::<2>, ContactGauss::<3>);
    Ok(())
}

/// The energy decays by H₁ = H₀ exp(hΛ_s). The factor is e^(−ch) if c is constant. Otherwise a step back restores the state.
#[test]
fn the_energy_decays_as_the_equation_says() -> Result<(), StepError> {
    let system = FadingChain { m: M, c: 0.3 };
    for h in [0.02, 0.1] {
        let mut sim = system.integrator(ContactDiscreteGradient, h, system.at(BENT.0, BENT.1, 0.1));
        let mut energy = sim.energy();
        for _ in 0..100 {
            sim.step()?;
            let expected = energy * (-0.3 * h).exp();
            assert!((sim.energy() - expected).abs() < 2e-14, "{:e}", sim.energy() - expected);
            energy = sim.energy();
        }
    }
    let start = CHAIN.at(BENT.0, BENT.1, 0.1);
    let mut sim = CHAIN.integrator(ContactDiscreteGradient, 0.05, start);
    let before = sim.energy();
    sim.step()?;
    assert!((sim.energy() / before).ln().abs() > 1e-3, "{}", sim.energy() / before);
    sim.set_step_size(-0.05);
    sim.step()?;
    let state = sim.state();
    assert!(
        far(&[&state.q[..], &state.p, &[state.s]].concat(), &[&start.q[..], &start.p, &[start.s]].concat()) < 1e-14
    );
    Ok(())
}

/// Friction in proportion to the kinetic energy equals friction by the action. Then s need not be solved for.
#[test]
fn friction_is_that_of_the_action() {
    let (braked, rubbed) = (FadingChain { m: M, c: 0.3 }, RubbedChain { m: M, c: 0.3 });
    let found = end(braked, ContactGauss::<4>, braked.at(BENT.0, BENT.1, 0.0), 0.05, 2.0);
    let mut sim = rubbed.integrator(Gauss::<4>, 0.05, rubbed.at(BENT.0, BENT.1));
    sim.advance(40).expect("steps");
    let expected = [sim.state().q, sim.state().p].concat();
    assert!(far(&found, &expected) < 1e-10, "{found:?} {expected:?}");
    assert!(RubbedChain::<f64>::REPORT.contains("with γ = c,"), "{}", RubbedChain::<f64>::REPORT);
}

/// A step over a singular mass matrix is refused, and so is a step that is too long. The state is kept.
#[test]
fn refused_steps_leave_the_state() {
    let system = Vanishing { m: 0.7 };
    let start = system.at([1.0, 0.2, -0.1], [-1.5, 0.3, 0.2], 0.0);
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            for h in [0.02, 0.3, 1.5] {
                let mut sim = system.integrator($method, h, start);
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
    refuses!(ContactMidpoint, ContactGauss::<2>, ContactGauss::<3>, ContactDiscreteGradient);
    // The form would change its sign.
    let system = FadingChain { m: M, c: 3.0 };
    let start = system.at(BENT.0, BENT.1, 0.0);
    let mut sim = system.integrator(ContactMidpoint, 1.0, start);
    assert!(sim.step().is_err());
    assert_eq!(sim.state(), start);
}
