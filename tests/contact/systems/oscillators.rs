//! Oscillators whose solution is known, or an invariant set.

use super::*;
use core::f64::consts::PI;
use geoint_runtime::methods::*;

/// q of q'' + γ q' + q = 0 from (q, p), of which the characteristic roots are complex, or −1 both.
fn exact([q, p]: [f64; 2], gamma: f64, t: f64) -> f64 {
    let omega = (1.0 - gamma * gamma / 4.0).sqrt();
    let sine = if omega == 0.0 { t } else { (omega * t).sin() / omega };
    (-gamma * t / 2.0).exp() * (q * (omega * t).cos() + (p + gamma * q / 2.0) * sine)
}

/// The largest |q − exact| from (−0.25, 0.75) on.
fn off<S, M: Method<S, f64>>(system: S, method: M, gamma: f64, h: f64) -> f64
where
    S: Contact<Coordinates = f64>,
{
    let mut sim = system.integrator(method, h, ContactState::new(-0.25, 0.75, 0.0));
    let states = sim.until(if gamma > 0.5 { 15.0 } else { 50.0 });
    largest(states.map(|x| x.unwrap()).map(|x| x.q - exact([-0.25, 0.75], gamma, x.t)))
}

#[test]
fn one_piece_is_exact_and_three_have_known_errors() {
    for (gamma, error) in [(0.01, 1.21e-2), (0.1, 2.33e-3), (1.0, 4.8e-4), (2.0, 6.1e-4)] {
        for h in [1.3, 0.1] {
            let one = off(DampedOscillator { gamma }, ContactSplitting, gamma, h);
            assert!(one < 3e-14, "γ = {gamma}, h = {h}: {one:.1e}");
        }
        let three = [0.1, 0.05].map(|h| off(ThreePieces { gamma }, ContactSplitting, gamma, h));
        assert!(three[0] < error && three[0] > error / 4.0, "γ = {gamma}: {:.2e}", three[0]);
        assert!((order(three) - 2.0).abs() < 0.05, "γ = {gamma}: {three:?}");
    }
}

#[test]
fn the_variational_leapfrog_has_known_errors() {
    for (gamma, error) in [(0.01, 1.26e-2), (0.1, 2.56e-3), (1.0, 4.28e-4), (2.0, 1.82e-3)] {
        let found = off(DampedOscillator { gamma }, ContactLeapfrog, gamma, 0.1);
        assert!((found / error - 1.0).abs() < 0.02, "γ = {gamma}: {found:.3e}");
    }
}

/// Contact leapfrog has order 2. The control, leapfrog for (q, p) with friction as one more force, has order 1 and larger errors.
#[test]
fn contact_leapfrog_is_compared_with_leapfrog() {
    let leapfrog = |gamma: f64, h: f64| {
        let ([mut q, mut p], duration) = ([-0.25, 0.75], if gamma > 0.5 { 15.0 } else { 50.0 });
        let errors = (1..=(duration / h).round() as u32).map(|n| {
            p -= h / 2.0 * (q + gamma * p);
            q += h * p;
            p -= h / 2.0 * (q + gamma * p);
            q - exact([-0.25, 0.75], gamma, h * f64::from(n))
        });
        largest(errors)
    };
    for gamma in [0.1, 1.0] {
        let contact = [0.1, 0.05].map(|h| off(DampedOscillator { gamma }, ContactLeapfrog, gamma, h));
        let plain = [0.1, 0.05].map(|h| leapfrog(gamma, h));
        assert!(
            (order(contact) - 2.0).abs() < 0.05 && contact[0] < plain[0] / 3.0,
            "γ = {gamma}: {contact:?} {plain:?}"
        );
        assert!(order(plain) < 1.25, "γ = {gamma}: {plain:?}");
    }
}

/// M. Vermeeren, A. Bravetti & M. Seri (2019): β = 0.3, ω = π/3.
#[test]
fn a_driven_oscillator_stays_on_its_periodic_solution() {
    let (beta, omega) = (0.3, PI / 3.0);
    for gamma in [0.01, 0.1, 1.0, 2.0] {
        let amplitude = -beta / (gamma * omega).hypot(1.0 - omega * omega);
        let phase = (gamma * omega).atan2(omega * omega - 1.0);
        let q = |t: f64| amplitude * (omega * t + phase).sin();
        let start = ContactState::new(q(0.0), amplitude * omega * phase.cos(), 0.0);
        let system = Driven { gamma, beta, omega };
        let [whole, half] = [0.1, 0.05].map(|h| {
            let (mut a, mut b) =
                (system.integrator(ContactSplitting, h, start), system.integrator(BlanesMoanSrkn11b, 2.0 * h, start));
            let off = |x: Result<ContactState<f64>, StepError>| x.map(|x| x.q - q(x.t)).unwrap();
            [largest(a.until(50.0).map(off)), largest(b.until(50.0).map(off))]
        });
        let errors = format!("γ = {gamma}: {whole:?} {half:?}");
        assert!(half[0] < 0.013 && (order([whole[0], half[0]]) - 2.0).abs() < 0.05, "{errors}");
        assert!(half[1] < 1e-10 && (order([whole[1], half[1]]) - 6.0).abs() < 0.5, "{errors}");
    }
}

const COSMOS: Cosmological = Cosmological { r: 1.0 };

#[test]
fn the_axis_is_kept_exactly() {
    for s in [-1.3, -1.0, 2.5] {
        let end = after(COSMOS, ContactSplitting, 0.1, ContactState::new(0.0, 0.0, s), 20.0);
        assert_eq!(end[..2], [0.0, 0.0]);
        assert!((end[2] - 2.0_f64.sqrt()).abs() < 1e-10, "{end:?}");
    }
}

#[test]
fn the_sphere_is_kept_to_the_order_of_the_method() {
    let radius = (2.0_f64 - 0.36).sqrt();
    let start = ContactState::new(0.6 * radius, 0.8 * radius, -0.6);
    let errors = [0.2, 0.1, 0.05].map(|h| {
        let mut sim = COSMOS.integrator(ContactSplitting, h, start);
        largest(sim.until(20.0).map(|x| COSMOS.energy(&x.unwrap())))
    });
    for (found, known) in errors.iter().zip([3.5e-3, 8.8e-4, 2.2e-4]) {
        assert!((found / known - 1.0).abs() < 0.02, "{errors:?}");
    }
    let [whole, half] = [0.1, 0.05].map(|h| {
        let mut sim = COSMOS.integrator(Suzuki4.of(ContactSplitting), h, start);
        largest(sim.until(20.0).map(|x| COSMOS.energy(&x.unwrap())))
    });
    assert!((order([whole, half]) - 4.0).abs() < 0.1 && half < 5e-8, "{whole:.1e} {half:.1e}");
    let mut sim = COSMOS.integrator(ContactDiscreteGradient, 0.2, start);
    assert!(largest(sim.until(20.0).map(|x| COSMOS.energy(&x.unwrap()))) < 1e-14);
}

/// From the lower point of rest to the upper one, and inside of the sphere: dH/dt = −H s.
#[test]
fn orbits_lead_from_one_point_of_rest_to_the_other() {
    for angle in 0..5 {
        let (sin, cos) = (1.2566 * f64::from(angle)).sin_cos();
        let radius = (2.0 - 1.414_f64.powi(2)).sqrt();
        let start = ContactState::new(radius * cos, radius * sin, -1.414);
        let end = after(COSMOS, ContactSplitting, 0.1, start, 30.0);
        assert!((end[2] - 2.0_f64.sqrt()).abs() < 1e-6, "{end:?}");
    }
    let start = ContactState::new(0.3, 0.2, -1.2);
    let law = [0.1, 0.05].map(|h| {
        let mut sim = COSMOS.integrator(ContactSplitting, h, start);
        let (mut exponent, mut before) = (0.0, start);
        largest(sim.until(5.0).map(|x| {
            let x = x.unwrap();
            exponent -= h * (before.s + x.s) / 2.0;
            before = x;
            COSMOS.energy(&x) - COSMOS.energy(&start) * f64::exp(exponent)
        }))
    });
    assert!((order(law) - 2.0).abs() < 0.1 && law[1] < 1e-3, "{law:?}");
}

#[test]
fn friction_that_grows_with_the_action_is_explicit() {
    let start = ContactState::new(0.5, 0.5, -0.2);
    for (a, bound) in [(0.1, 5.2e-4), (1.5, 4e-4)] {
        let system = QuadraticDissipation { a };
        let truth = solution(&QuadraticDissipation { a: Double::from(a) }, &flat(&start), 50.0, 200);
        let errors = [0.1, 0.05].map(|h| gap(&after(system, ContactSplitting, h, start, 50.0), &truth));
        assert!(errors[0] < bound && (order(errors) - 2.0).abs() < 0.2, "a = {a}: {errors:?}");
        let errors = [0.1, 0.05].map(|h| gap(&after(system, BlanesMoan4X, h, start, 50.0), &truth));
        assert!((order(errors) - 4.0).abs() < 0.2, "a = {a}: {errors:?}");
    }
    // The flow of s²/2 has a pole at 2/20.
    let mut sim = QuadraticDissipation { a: 1.0 }.integrator(ContactSplitting, 0.2, ContactState::new(0.5, 0.5, -20.0));
    assert!(matches!(sim.step(), Err(StepError { t: 0.0, failure: Failure::Pole { .. }, .. })));
    // If a step may not be shorter, the error names the reason of the refusal.
    let start = ContactState::new(0.5, 0.5, -20.0);
    let mut sim = QuadraticDissipation { a: 1.0 }.adaptive(ContactSplitting, 1e-6, start).steps_between(0.2, 0.2);
    let refused = sim.step();
    assert!(matches!(refused, Err(StepError { failure: Failure::Pole { .. }, .. })), "{refused:?}");
}
