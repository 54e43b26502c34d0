//! Exact laws of implicit steps of contact systems: the decay of H, of the contact form, and of the angular momentum.

use super::cases::*;
use geoint_runtime::Contact;
use geoint_runtime::Real;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};
use geoint_tests::measure::{distance, extrapolated};
use geoint_tests::scalars::Double;

/// Returns the largest distance of H̄ = (p̄·Δq − Δs)/h from the logarithmic mean of H at both ends, over all steps. The mean is H(x₀)(e^z − 1)/z with
/// H(x₁) = H(x₀) e^z. The law holds for every choice of ∂H/∂s.
pub(super) fn decays<S: Contact>(system: S, start: &[f64], h: f64, steps: usize) -> f64
where
    ContactDiscreteGradient: Method<S>,
{
    let n = S::Array::LEN;
    let mut sim = system.integrator(ContactDiscreteGradient, h, state::<S, f64>(FROM, start));
    let (mut worst, mut change) = (0.0_f64, 0.0_f64);
    for _ in 0..steps {
        let before = sim.state();
        sim.step().unwrap();
        let after = sim.state();
        let middle = before.t + 0.5 * h;
        let energy = |x: &Point<S, f64>| system.hamiltonian(middle, &x.parts().1, &x.s);
        let [first, last] = [energy(&before), energy(&after)];
        let (x, y) = (flat(&before), flat(&after));
        let work: f64 = (0..n).map(|i| 0.5 * (x[n + i] + y[n + i]) * (y[i] - x[i])).sum();
        let mean = (work - (y[2 * n] - x[2 * n])) / h;
        let z = (last / first).ln();
        worst = worst.max((mean * z - (last - first)).abs() / (x[2 * n].abs() + 1.0));
        change = change.max(z.abs());
    }
    assert!(change > 1e-3, "H decays: {change:.1e}");
    worst
}
/// H₁ = H₀ exp(−h g_s) with g_s written by hand, in each step.
#[test]
fn the_law_of_decay() {
    for e in [0.0, 0.2] {
        let system = Pendulum { g: 0.1, e };
        for h in [0.01, 0.1, 0.7] {
            let mut sim = system.integrator(ContactDiscreteGradient, h, ContactState::new(1.0, 0.5, 0.3));
            for _ in 0..300 {
                let (before, first) = (sim.state(), sim.energy());
                sim.step().unwrap();
                let decay = h * (0.1 + e * 0.5 * (before.s + sim.state().s));
                let defect = (sim.energy() - first * (-decay).exp()).abs();
                let terms = 1.0 + before.p.powi(2) / 2.0 + 0.1 * before.s.abs() + e * before.s.powi(2);
                assert!(defect <= 3e-15 * terms, "e = {e}, h = {h}: {defect:.1e}");
            }
        }
    }
}

/// Figures that were computed beforehand by another program.
#[test]
fn figures() {
    let solution = |e: f64| {
        let field = |_, x: &[Double]| {
            let [q, p, s] = [x[0], x[1], x[2]];
            let sigma = Double::from(0.1) + s * e;
            vec![p, -q.sin() - p * sigma, p * p * 0.5 + q.cos() - s * 0.1 - s * s * (0.5 * e)]
        };
        extrapolated(field, 0.0.into(), over(vec![1.0, 0.5, 0.3]), 4.0.into(), 20)
            .iter()
            .map(|x| x.value())
            .collect::<Vec<_>>()
    };
    let run = |e: f64, h: f64| {
        let mut sim = Pendulum { g: 0.1, e }.integrator(ContactDiscreteGradient, h, ContactState::new(1.0, 0.5, 0.3));
        let first = sim.energy();
        sim.advance((4.0 / h).round() as u64).unwrap();
        (flat(&sim.state()), sim.energy(), first)
    };
    let exact = solution(0.0);
    for (h, expected) in [(0.1, 3.00e-3), (0.05, 7.50e-4), (0.025, 1.88e-4)] {
        let error = distance(&run(0.0, h).0, &exact);
        assert!((error / expected - 1.0).abs() < 0.05, "h = {h}: {error:.2e}");
    }
    let (_, last, first) = run(0.0, 0.1);
    assert!((last - first * (-0.4_f64).exp()).abs() <= 5e-15);
    let exact = solution(0.2);
    let energy = exact[1].powi(2) / 2.0 - exact[0].cos() + 0.1 * exact[2] + 0.1 * exact[2].powi(2);
    let gap = (run(0.2, 0.1).1 - energy).abs();
    assert!((gap / 7.7e-5 - 1.0).abs() < 0.05, "{gap:.2e}");
}

/// Every step keeps the level H = 0. Beside this level H keeps its sign.
#[test]
fn the_zero_level() {
    let system = Entangled { m: 1.6 };
    let energy = |s: f64| system.energy(&ContactState::new(0.3, -0.4, s));
    let (mut low, mut high) = (0.0, 4.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if energy(low) * energy(middle) <= 0.0 { high = middle } else { low = middle }
    }
    assert!(energy(low).abs() < 1e-14, "{low}: {}", energy(low));
    for h in [0.05, 0.2] {
        let mut sim = system.integrator(ContactDiscreteGradient, h, ContactState::new(0.3, -0.4, low));
        for _ in 0..10 {
            sim.step().unwrap();
            assert!(sim.energy().abs() <= 2e-13, "h = {h}: {:.1e}", sim.energy());
        }
        // The control.
        let mut sim = system.integrator(ContactMidpoint, h, ContactState::new(0.3, -0.4, low));
        sim.advance(10).unwrap();
        assert!(sim.energy().abs() > 1e-7, "h = {h}: {:.1e}", sim.energy());
    }
}

/// With constant damping the form shrinks by a number that is known.
#[test]
fn the_factor_of_the_form() {
    let (defect, factor) = contact_defect::<PendulumCase, _>(ContactMidpoint, 3);
    let (less, more): (f64, f64) = (1.0 - 0.15 * 0.4 / 2.0, 1.0 + 0.15 * 0.4 / 2.0);
    assert!(defect < 1e-13 && (factor - (less / more).powi(3)).abs() < 1e-14, "{defect:.1e}, {factor}");
}

/// θ q×p is a quadratic invariant one dimension up.
#[test]
fn angular_momentum_decays_with_the_form() {
    #[contact_hamiltonian(name = Planet)]
    fn planet(q: [f64; 2], p: [f64; 2], s: f64, m: f64, g: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + g * s
    }
    let momentum = |x: &ContactState<[f64; 2]>| x.q[0] * x.p[1] - x.q[1] * x.p[0];
    let (start, h, g) = (ContactState::new([1.0, 0.2], [0.1, 1.2], 0.0), 0.05, 0.01);
    let ratio = |n: i32| (1.0_f64 - h * g / 2.0).powi(n) / (1.0 + h * g / 2.0).powi(n);
    let mut sim = Planet { m: 1.3, g }.integrator(ContactMidpoint, h, start);
    for n in 1..=500 {
        sim.step().unwrap();
        let defect = momentum(&sim.state()) / momentum(&start) / ratio(n) - 1.0;
        assert!(defect.abs() < 1e-14 * f64::from(n).sqrt().max(3.0), "{n}: {defect:.1e}");
    }
    // The control.
    let mut sim = Planet { m: 1.3, g }.integrator(ContactDiscreteGradient, h, start);
    sim.advance(500).unwrap();
    assert!((momentum(&sim.state()) / momentum(&start) / ratio(500) - 1.0).abs() > 1e-7);
}
