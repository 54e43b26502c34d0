//! S31: the two lines of the contact leapfrog as the slide prints them, with friction a(t) and a force f(t). S32: without friction they are leapfrog. S50: a
//! problem on which its errors are smaller.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::Dual;
use std::f64::consts::PI;

/// A mass on a quartic spring under friction a(t) = a₀ + a₁ sin t and a force f(t) = 0.3 sin ωt.
#[contact_hamiltonian]
fn driven(q: f64, p: f64, s: f64, t: f64, a: [f64; 2], omega: f64) -> f64 {
    p * p / 2.0 + q.powi(4) / 4.0 - 0.3 * (omega * t).sin() * q + (a[0] + a[1] * t.sin()) * s
}

/// The same mass without friction.
#[hamiltonian]
fn undamped(q: f64, p: f64, t: f64, omega: f64) -> f64 {
    p * p / 2.0 + q.powi(4) / 4.0 - 0.3 * (omega * t).sin() * q
}

const OMEGA: f64 = PI / 3.0;
const H: f64 = 0.2;
const FROM: f64 = 0.4;

fn friction(t: f64) -> f64 {
    0.3 + 0.2 * t.sin()
}

/// V'(q, t).
fn slope(q: f64, t: f64) -> f64 {
    q.powi(3) - 0.3 * (OMEGA * t).sin()
}

/// Position, momentum and action after one step of the library.
fn step() -> [f64; 3] {
    let system = Driven { a: [0.3, 0.2], omega: OMEGA };
    let mut sim = system.integrator(ContactLeapfrog, H, ContactState::at(FROM, -0.25, 0.75, 0.1));
    sim.step().expect("a step");
    let ContactState { q, p, s, .. } = sim.state();
    [q, p, s]
}

#[test]
fn a_step_is_the_two_lines_of_the_slide() {
    let ([q0, p0], [t0, t1]) = ([-0.25, 0.75], [FROM, FROM + H]);
    let lines = |a0: f64, a1: f64| {
        let q1 = q0 + H * (1.0 - H * a0 / 2.0) * p0 - H * H / 2.0 * slope(q0, t0);
        let p1 = ((1.0 - H * a0 / 2.0) * p0 - H / 2.0 * (slope(q0, t0) + slope(q1, t1))) / (1.0 + H * a1 / 2.0);
        [q1, p1]
    };
    let expected = [-0.102_915_335_168_471_15, 0.723_298_816_053_486_2, 0.139_576_643_466_645_17];
    let found = step();
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() <= 2e-16, "{found} in place of {expected}");
    }
    let [q, p] = lines(friction(t0), friction(t1));
    assert!((found[0] - q).abs() <= 2e-16 && (found[1] - p).abs() <= 2e-16, "{found:?} {q} {p}");
    // Control: friction at the start in both places is another step, of order 1.
    let [_, p] = lines(friction(t0), friction(t0));
    assert!((found[1] - p).abs() > 1e-3, "{p}");
}

/// The lines follow from the trapezoidal L_d: p₀ = −h D₁/(1 + h D₃), p₁ = h D₂/(1 − h D₄), s₁ = s₀ + h L_d.
#[test]
fn the_two_lines_follow_from_the_discrete_lagrangian() {
    let ([q1, p1, s1], [q0, p0, s0]) = (step(), [-0.25, 0.75, 0.1]);
    let potential = |q: Dual, t: f64| q.powi(4) / 4.0 - q * (0.3 * (OMEGA * t).sin());
    let discrete = |x: [Dual; 4]| {
        let v = (x[1] - x[0]) / H;
        let energy = potential(x[0], FROM) + potential(x[1], FROM + H);
        v * v / 2.0 - energy / 2.0 - (x[2] * friction(FROM) + x[3] * friction(FROM + H)) / 2.0
    };
    let x = [q0, q1, s0, s1];
    let slopes: [f64; 4] = std::array::from_fn(|i| {
        let mut x = x.map(Dual::from);
        x[i] = Dual::variable(x[i].value());
        discrete(x).derivative()
    });
    assert!((-H * slopes[0] / (1.0 + H * slopes[2]) - p0).abs() < 1e-15);
    assert!((H * slopes[1] / (1.0 - H * slopes[3]) - p1).abs() < 1e-15);
    assert!((s0 + H * discrete(x.map(Dual::from)).value() - s1).abs() < 1e-15);
}

#[test]
fn without_friction_contact_leapfrog_is_leapfrog() {
    let contact = |a: f64, x: State<f64>| {
        let start = ContactState::at(x.t, x.q, x.p, 0.1);
        let mut sim = Driven { a: [a, 0.0], omega: OMEGA }.integrator(ContactLeapfrog, H, start);
        sim.step().expect("a step");
        [sim.state().q, sim.state().p]
    };
    let (mut x, mut largest, mut control) = (State::at(FROM, 0.9, -0.4), 0.0_f64, 0.0_f64);
    for _ in 0..500 {
        // Every step begins anew, so that both methods have the same time.
        let mut plain = Undamped { omega: OMEGA }.integrator(StormerVerlet, H, x);
        plain.step().expect("a step");
        let after = plain.state();
        let off = |[q, p]: [f64; 2]| (q - after.q).abs().max((p - after.p).abs());
        largest = largest.max(off(contact(0.0, x)));
        control = control.max(off(contact(1e-3, x)));
        x = after;
    }
    // One unit in the last place of numbers between 1 and 2.
    assert!(largest <= 2.3e-16 && control > 1e-4, "{largest:e} {control:e}");
}

/// A body that falls through a medium.
#[contact_hamiltonian]
fn falling(q: f64, p: f64, s: f64, m: f64, g: f64, gamma: f64) -> f64 {
    p * p / (2.0 * m) + m * g * q + gamma * s
}

/// S50, a problem on which the variational integrator is more accurate at the same order: its terminal momentum mg/γ is exact, because the friction is that of
/// ½(p₀ + p₁). The splitting has the exact mean speed, but its momenta at the ends of steps are mgh/(2 sinh(γh/2)).
#[test]
fn the_variational_step_has_the_exact_terminal_momentum() -> Result<(), StepError> {
    let (m, g, gamma, h) = (1.7, 9.81, 0.5, 0.2);
    let system = Falling { m, g, gamma };
    let start = ContactState::new(0.0, 0.0, 0.0);
    let (mut leapfrog, mut splitting) =
        (system.integrator(ContactLeapfrog, h, start), system.integrator(ContactSplitting, h, start));
    leapfrog.advance(1000)?;
    splitting.advance(1000)?;
    let relative = |p: f64| -p * gamma / (m * g) - 1.0;
    assert!(relative(leapfrog.state().p).abs() < 1e-14, "{:e}", relative(leapfrog.state().p));
    let expected = gamma * h / (2.0 * (gamma * h / 2.0).sinh()) - 1.0;
    assert!((relative(splitting.state().p) / expected - 1.0).abs() < 1e-10, "{:e}", relative(splitting.state().p));
    // The mean speed between two positions is exact for both.
    let mut fallen = [0.0; 2];
    fallen[0] = leapfrog.state().q;
    leapfrog.step()?;
    fallen[0] -= leapfrog.state().q;
    fallen[1] = splitting.state().q;
    splitting.step()?;
    fallen[1] -= splitting.state().q;
    let errors = fallen.map(|way| (way / h * gamma / g - 1.0).abs());
    assert!(errors.iter().all(|error| *error < 1e-11), "{errors:?}");
    Ok(())
}
