//! Checks of implicit steps of contact systems: poles between the start and a stage, jumps at the end, and units of the unknowns.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Contact, Method};

/// An oscillator with a pole at q = 0. Friction depends on time only, so s is no unknown.
#[contact_hamiltonian]
fn pole_beside_friction(q: f64, p: f64, s: f64, k: f64, g: f64) -> f64 {
    (p * p + q * q) / 2.0 + k / q + g * s
}

/// Two coupled oscillators with a full mass matrix, solved for velocities, and with a pole.
#[lagrangian]
fn pole_beside_coupling(q: [f64; 2], v: [f64; 2], s: f64, k: f64, g: f64) -> f64 {
    let kinetic = 0.5 * (v[0] * v[0] + v[1] * v[1]) + 0.3 * v[0] * v[1] * (0.1 * q[1]).cos();
    kinetic - 0.5 * (q[0] * q[0] + q[1] * q[1]) - k / q[0] - g * s
}

/// A step of most of a period ends on its side of the pole, but one of its stages lies beyond.
#[test]
fn no_stage_lies_beyond_a_pole() {
    fn refused(outcome: Result<(), StepError>) {
        let Err(StepError { failure: Failure::OutsideDomain { what }, .. }) = outcome else { panic!("{outcome:?}") };
        assert!(what.starts_with("a pole between the ends of the step: q"), "{what}");
    }
    let (k, g) = (1e-9, 0.01);
    let system = PoleBesideFriction { k, g };
    let mut sim = system.integrator(ContactGauss::<3>, 5.5, ContactState::new(1.0, 0.0, 0.0));
    refused(sim.step());
    sim.set_step_size(0.1);
    assert_eq!(sim.step(), Ok(()));

    let system = PoleBesideCoupling { k, g };
    let mut sim = system.integrator(ContactGauss::<3>, 5.5, system.at([1.0, 0.0], [0.0, 0.0], 0.0));
    refused(sim.step());
    sim.set_step_size(0.1);
    assert_eq!(sim.step(), Ok(()));
}

/// A jump of the potential at q = 0.
#[contact_hamiltonian]
fn jump_beside_friction(q: f64, p: f64, s: f64, m: f64, k: f64, g: f64) -> f64 {
    p * p / (2.0 * m) + if q < 0.0 { k } else { 0.0 } + g * s
}

/// Three coupled masses with a jump of the potential. A step is polarised.
#[lagrangian]
fn jump_beside_chain(q: [f64; 3], v: [f64; 3], s: f64, k: f64, g: f64) -> f64 {
    let mut kinetic = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    for i in 0..3 {
        for j in 0..i {
            kinetic += 0.6 * (q[i] - q[j]).cos() * v[i] * v[j];
        }
    }
    0.5 * kinetic - if q[0] < 0.0 { k } else { 0.0 } - g * s
}

/// The last correction, or rounding, may move the end of a step across a jump. The jumps are so small that the solver takes them for rounding.
#[test]
fn a_step_ends_on_the_side_that_was_evaluated() {
    /// Takes a step to within `beside` of a jump by `k`. Returns whether it was refused. A step may also have no solution.
    fn is_refused<S: Contact, M: Method<S>>(mut sim: Integrator<S, M>, factor: f64) -> bool {
        let expected = sim.energy() * factor;
        match sim.step() {
            Ok(()) => {
                let error = (sim.energy() - expected).abs();
                assert!(error < 4e-15, "{error:e}");
                false
            }
            Err(StepError { failure: Failure::OutsideDomain { what }, .. }) => {
                assert!(what.starts_with("the energy jumps where a condition changes"), "{what}");
                true
            }
            Err(StepError { failure: Failure::NotConverged { .. }, .. }) => false,
            Err(error) => panic!("{error}"),
        }
    }
    let (h, g) = (0.1_f64, 2.0);
    let (factor, mut refused) = ((-g * h).exp(), [0; 2]);
    let chain = |k: f64, q: f64| {
        let system = JumpBesideChain { k, g };
        system.integrator(ContactDiscreteGradient, h, system.at([q, 0.3, -0.2], [-1.7, 0.2, 0.1], 0.0))
    };
    // Without the jump, steps from these positions end at zero.
    let (m, p, mut start_of_chain) = (1.3, -1.7, 0.5);
    let start_of_one = -h * p / m / (1.0 + 0.5 * g * h);
    for _ in 0..6 {
        let mut free = chain(0.0, start_of_chain);
        free.step().unwrap();
        start_of_chain -= free.state().q[0];
    }
    for k in [-1e-10, 1e-10, -1e-13, 1e-13, -3e-14, 3e-14, -1e-14, 1e-14] {
        for beside in (20..34).flat_map(|n| [-1.0, 1.0].map(|sign| sign * 10_f64.powf(-0.5 * f64::from(n)))) {
            let start = ContactState::new(start_of_one + beside, p, 0.0);
            let one = JumpBesideFriction { m, k, g }.integrator(ContactDiscreteGradient, h, start);
            refused[0] += u32::from(is_refused(one, factor));
            refused[1] += u32::from(is_refused(chain(k, start_of_chain + beside), factor));
        }
    }
    assert!(refused.iter().all(|refused| *refused > 0), "{refused:?}");
}

/// Two degrees of freedom with friction that grows with s, which is therefore an unknown of each stage.
#[contact_hamiltonian]
fn growing_friction(q: [f64; 2], p: [f64; 2], s: f64, m: [f64; 2], k: f64, l: f64, g: f64, e: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    let cubic = l * (q[0] * q[0] * q[1] - q[1] * q[1] * q[1] / 3.0);
    kinetic + k * (q[0] * q[0] + q[1] * q[1]) / 2.0 + cubic + g * s + e * s * s
}

/// A change of units by powers of two changes no bit, even if steps are so long that the solver has to compare unknowns of one unit.
#[test]
fn long_steps_in_all_units() {
    /// Exponents of the units of q, p and t.
    fn run([q, p, t]: [i32; 3]) -> (Vec<u64>, u64, bool) {
        let power = |k: i32| 2.0_f64.powi(k);
        let (action, energy) = (q + p, q + p - t);
        let system = GrowingFriction {
            m: [1.7, 0.6].map(|m| m * power(p + t - q)),
            k: power(p - t - q),
            l: 0.8 * power(p - t - 2 * q),
            g: 0.1 * power(-t),
            e: 0.02 * power(energy - 2 * action),
        };
        let [qs, ps] = [[0.0, -0.2].map(|x| x * power(q)), [0.35, 0.3].map(|x| x * power(p))];
        let start = ContactState::new(qs, ps, 0.1 * power(action));
        let mut sim = system.integrator(ContactGauss::<2>, 8.0 * power(t), start);
        let outcome = sim.advance(30).is_ok();
        let ContactState { q: [q0, q1], p: [p0, p1], s, .. } = sim.state();
        let plain = [q0 * power(-q), q1 * power(-q), p0 * power(-p), p1 * power(-p), s * power(-action)];
        (plain.map(f64::to_bits).to_vec(), sim.steps(), outcome)
    }
    let expected = run([0; 3]);
    for units in [[3, -5, 1], [37, 97, 23], [-33, -80, -53], [100, -100, -7], [-100, 100, 40]] {
        assert_eq!(run(units), expected, "{units:?}");
    }
}
