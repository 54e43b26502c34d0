//! Runs of contact systems whose steps adapt, and those whose sums compensate.

use crate::measure::{field, flat, run, solution, state};
use geoint_runtime::Contact;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, PerCoordinate, Snapshot};
use geoint_runtime::system::Rates;
use geoint_tests::measure::distance;
use geoint_tests::scalars::Double;

/// A damped oscillator.
#[contact_hamiltonian]
fn oscillator(q: f64, p: f64, s: f64, m: f64, k: f64, gamma: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + gamma * s
}

/// Coupled masses under friction and a force that comes and goes.
#[contact_hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64) -> f64 {
    let kinetic = p[0] * p[0] / 3.4 + p[1] * p[1] / 1.2 + 0.3 * p[0] * p[1];
    kinetic + a * s + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh() + t.cos() * q[1]
}

/// A relativistic oscillator with friction: T is not quadratic.
#[contact_hamiltonian]
fn relativistic(q: f64, p: f64, s: f64, m: f64, gamma: f64) -> f64 {
    (m * m + p * p).sqrt() + q * q / 2.0 + 0.1 * q.powi(4) + gamma * s
}

/// Of which no piece is a drift or a kick, and s acts back.
#[contact_hamiltonian]
fn tangled(q: f64, p: f64, s: f64, t: f64, a: f64) -> f64 {
    a * p * s + (0.3 + q * q) * s + q.sin() + 0.2 * (1.0 + 0.4 * (t * t).sin()) * p * p * q * q + 0.3 * p * p
}

/// Van der Pol's oscillator in (q, s).
#[contact_hamiltonian(lift)]
fn van_der_pol(q: f64, p: f64, s: f64, eps: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q
}

const COUPLED: (f64, [f64; 5]) = (0.2, [0.7, -0.4, 0.5, 0.8, 0.3]);

/// The largest error of a coordinate of an adaptive run, and its steps.
fn adapted<S, M>(
    system: S,
    exact: impl Contact<Double>,
    method: M,
    tolerance: f64,
    (t, x): (f64, &[f64]),
    duration: f64,
) -> (f64, u64)
where
    S: Contact,
    M: Method<S>,
{
    let mut sim = Adaptive::new(system, method, tolerance, state(t, x));
    sim.advance_to(t + duration).unwrap();
    assert_eq!(sim.time(), t + duration);
    let end: Vec<Double> = flat(&sim.state()).into_iter().map(Double::from).collect();
    (distance(&end, &solution(&exact, t, x, duration, 200)), sim.steps())
}

#[test]
fn steps_adapt_to_a_tolerance() {
    let exact = |x: f64| Double::from(x);
    let [wide, narrow] = [1e-5, 1e-8].map(|tolerance| {
        let own = Oscillator { m: 1.7, k: 2.3, gamma: 0.4 };
        let double = Oscillator { m: exact(1.7), k: exact(2.3), gamma: exact(0.4) };
        let start = (0.0, &[0.8, -0.5, 0.3][..]);
        let mut all = vec![
            adapted(own, double, StormerVerlet, tolerance, start, 5.0),
            adapted(own, double, BlanesMoan6, tolerance, start, 5.0),
            adapted(own, double, Suzuki4.of(ContactMidpoint), tolerance, start, 5.0),
        ];
        let (own, double) = (Coupled { a: 0.4 }, Coupled { a: exact(0.4) });
        let start = (COUPLED.0, &COUPLED.1[..]);
        all.extend([
            adapted(own, double, BlanesMoanSrkn14a, tolerance, start, 8.0),
            adapted(own, double, Suzuki4.of(ContactLeapfrog), tolerance, start, 4.0),
            adapted(own, double, Suzuki4.of(ContactDiscreteGradient), tolerance, start, 4.0),
        ]);
        let (own, double) = (Tangled { a: 0.7 }, Tangled { a: exact(0.7) });
        all.push(adapted(own, double, BlanesMoan6X, tolerance, (0.2, &[0.6, 0.4, 0.3]), 3.0));
        for (i, (error, steps)) in all.iter().enumerate() {
            println!("{i}: tolerance {tolerance:.0e}, {steps} steps: {error:.1e}");
            // A step may have the tolerance for error; over all steps errors add up.
            assert!(*error <= (1.0 + 0.1 * *steps as f64) * tolerance, "{i}: {error:.1e} of {tolerance:.0e}");
        }
        all
    });
    for ((rough, few), (fine, many)) in wide.into_iter().zip(narrow) {
        assert!(fine < 0.03 * rough && many > few && many < 100 * few, "{rough:.1e} {fine:.1e}, {few} {many}");
    }
}

/// The energy decays as its law says, whatever the steps are.
#[test]
fn the_law_of_decay_holds_for_steps_that_adapt() {
    let system = Oscillator { m: 1.7, k: 2.3, gamma: 0.4 };
    let mut sim = system.adaptive(ContactDiscreteGradient, 1e-4, ContactState::new(0.8, -0.5, 0.3));
    let energy = sim.energy();
    sim.advance_to(7.0).unwrap();
    assert!((sim.energy() / (energy * (-0.4 * 7.0_f64).exp()) - 1.0).abs() < 1e-13);
    assert!(sim.steps() > 20);
}

/// The action counts in the error like every other coordinate. Here only the action has an error, so it alone decides the steps.
#[test]
fn the_action_is_a_coordinate_of_the_error() {
    // Friction on a particle far from any force: q and p are exact in every step, s is not where H has s².
    #[contact_hamiltonian(split = "p * p / (2.0 * m) | 0.3 * s * s | 0.7")]
    fn squared(_q: f64, p: f64, s: f64, m: f64) -> f64 {
        p * p / (2.0 * m) + 0.3 * s * s + 0.7
    }
    let start = ContactState::new(0.4, 0.0, 0.9);
    let steps = |tolerance: f64, absolute: f64| {
        let run = Squared { m: 1.7 }.adaptive(ContactSplitting, tolerance, start);
        let mut run = run.absolute(ContactState::new(0.0, 0.0, absolute));
        run.advance_to(2.0).unwrap();
        run.steps()
    };
    let [wide, narrow] = [steps(1e-4, 0.0), steps(1e-8, 0.0)];
    assert!(narrow > 10 * wide, "{narrow} steps, {wide}");
    assert!(steps(1e-8, 1e-4) < 2 * wide);
    assert_eq!(
        Squared { m: 1.7 }
            .adaptive(ContactSplitting, 1e-4, start)
            .absolute(ContactState::new(0.0, 0.0, -1.0))
            .step()
            .unwrap_err()
            .failure,
        Failure::InvalidTolerance { tolerance: -1.0 }
    );
}

/// The momenta of a lift stand still.
#[test]
fn a_lift_adapts() {
    let system = VanDerPol { eps: 0.8 };
    let mut sim = system.adaptive(Suzuki4.of(ContactSplitting), 1e-9, ContactState::new(1.2, 0.0, 0.4));
    let mut fine = system.integrator(Suzuki4.of(ContactSplitting), 1e-3, sim.state());
    sim.advance_to(6.0).unwrap();
    fine.advance(6000).unwrap();
    let (x, y) = (sim.state(), fine.state());
    assert!((x.q - y.q).abs() < 1e-7 && (x.s - y.s).abs() < 1e-7 && sim.steps() < 3000, "{x:?} {y:?}");
}

/// q', p' and s' follow from the gradient.
#[test]
fn rates_are_those_of_the_equation() {
    fn check<S: Contact>(system: S, t: f64, x: &[f64]) {
        let (_, z, s) = state::<S::State>(t, x).parts();
        let rates = system.rates(t, &PerCoordinate { z, s });
        let rates = [rates.z[0].as_slice(), rates.z[1].as_slice(), &[rates.s]].concat();
        let gap = distance_of(&rates, &field(&system, t, x));
        assert!(gap < 1e-14, "{gap:.1e}");
    }
    check(Coupled { a: 0.4 }, COUPLED.0, &COUPLED.1);
    check(Tangled { a: 0.7 }, 0.2, &[0.6, 0.4, 0.3]);
    check(Relativistic { m: 0.8, gamma: 0.4 }, 0.2, &[0.7, 0.5, 0.3]);
}

fn distance_of(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Errors of rounding after many small steps, plain and compensated: against the same steps in twice the digits.
fn rounding<S, D, M>(system: S, double: D, method: M, (t, x): (f64, &[f64]), h: f64, steps: u64) -> [f64; 2]
where
    S: Contact,
    D: Contact<Double>,
    M: Method<S> + Method<D, Double>,
{
    let exact: Vec<Double> = x.iter().map(|x| Double::from(*x)).collect();
    let exact = run(double, method, (t, &exact), h, steps).unwrap();
    let error = |end: &ContactState<S::Coordinates>| {
        let end: Vec<Double> = flat(end).into_iter().map(Double::from).collect();
        distance(&end, &exact)
    };
    let mut plain = Integrator::new(system, method, h, state(t, x));
    let mut compensated = plain.clone().compensated();
    plain.advance(steps).unwrap();
    compensated.advance(steps).unwrap();
    [error(&plain.state()), error(&compensated.state())]
}

#[test]
fn sums_compensate() {
    let exact = |x: f64| Double::from(x);
    let steps = 40_000;
    let mut all: Vec<(&str, [f64; 2])> = vec![];
    macro_rules! check {
        ($own:expr, $double:expr, $start:expr; $($method:expr),*) => {
            $( all.push((stringify!($method), rounding($own, $double, $method, $start, 5e-5, steps))); )*
        };
    }
    check!(Oscillator { m: 1.7, k: 2.3, gamma: 0.1 }, Oscillator { m: exact(1.7), k: exact(2.3), gamma: exact(0.1) },
        (0.0, &[0.8, -0.5, 0.3]); ContactSplitting, StormerVerlet, ContactLeapfrog, ContactMidpoint, ContactDiscreteGradient);
    check!(Coupled { a: 0.1 }, Coupled { a: exact(0.1) }, (COUPLED.0, &COUPLED.1[..]);
        StormerVerlet, ContactLeapfrog, ContactSplitting, ContactMidpoint, ContactDiscreteGradient);
    check!(Relativistic { m: 0.8, gamma: 0.1 }, Relativistic { m: exact(0.8), gamma: exact(0.1) }, (0.2, &[0.7, 0.5, 0.3]);
        StormerVerlet, ContactSplitting);
    check!(Tangled { a: 0.7 }, Tangled { a: exact(0.7) }, (0.2, &[0.6, 0.4, 0.3]);
        ContactSplitting);
    for (name, [plain, compensated]) in &all {
        println!("{name:40} plain {plain:.1e}, compensated {compensated:.1e}");
    }
    for (name, [plain, compensated]) in all {
        assert!(compensated < 0.1 * plain, "{name}: plain {plain:.1e}, compensated {compensated:.1e}");
    }
}
