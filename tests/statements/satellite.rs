//! S43: sections of a satellite in resonance for four couplings λ. S44: without resonance λ = 0.01 gives a ring and λ = 0.2 gives chaos.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::f64::consts::PI;

/// The angle q of a satellite on an ellipse whose moment of inertia is C = 1 + λ cos Ωt, as d(C q')/dt = torque. Torques belong to 2q − kt for
/// k = −5, …, 9.
#[contact_hamiltonian]
fn satellite(q: f64, p: f64, s: f64, t: f64, lambda: f64, omega: f64, torque: [f64; 15]) -> f64 {
    let inertia = 1.0 + lambda * (omega * t).cos();
    let potential = (0..15).map(|i| torque[i] * (2.0 * q - (i as f64 - 5.0) * t).cos()).sum::<f64>();
    p * p / 2.0 - lambda * omega * (omega * t).sin() / inertia * s - potential / (2.0 * inertia)
}

/// Coefficients of (a/r)³ cos(2f − 2q) = Σ cₖ cos(2q − kt), times a strength. They are means over the orbit in the eccentric anomaly u.
fn torque(strength: f64, e: f64) -> [f64; 15] {
    std::array::from_fn(|i| {
        let mean = (0..64).map(|j| {
            let u = 2.0 * PI * f64::from(j) / 64.0;
            let r = 1.0 - e * u.cos();
            let f = ((1.0 - e * e).sqrt() * u.sin()).atan2(u.cos() - e);
            (2.0 * f - (i as f64 - 5.0) * (u - e * u.sin())).cos() / (r * r)
        });
        strength * mean.sum::<f64>() / 64.0
    })
}

/// Returns (q − t, q') at the first `count` sections t = 2πk, with `steps` steps from section to section.
fn sections<M: Method<Satellite<f64>>>(
    system: Satellite<f64>,
    method: M,
    steps: u64,
    start: (f64, f64),
    count: usize,
) -> Vec<(f64, f64)> {
    let h = 2.0 * PI / steps as f64;
    let mut sim = system.integrator(method, h, ContactState::new(start.0, start.1, 0.0));
    let point = |x: ContactState<f64>| (x.q - x.t, x.p);
    sim.sampled(steps).take(count).map(|x| point(x.expect("a step"))).collect()
}

/// Expected sections of one coupling from q = 0.
struct Coupling {
    lambda: f64,
    /// q' at the start, and by how many half turns q − t changes: by steps of order 2 and of order 4.
    turning: [(f64, f64, f64); 2],
    /// q' at the start, and the largest |q − t|.
    librating: &'static [(f64, f64)],
    /// q' at the centre of the island without torque.
    centre: f64,
}

impl Coupling {
    fn holds(&self) {
        let system = Satellite { lambda: self.lambda, omega: 1.0, torque: torque(0.0075, 0.01) };
        let two = |p: f64| sections(system, ContactSplitting, 20, (0.0, p), 600);
        let four = |p: f64| sections(system, Suzuki4.of(ContactSplitting), 40, (0.0, p), 600);
        for (p, coarse, fine) in self.turning {
            let turned = |sections: Vec<(f64, f64)>| (sections[599].0 - sections[0].0) / PI;
            let (two, four) = (turned(two(p)), turned(four(p)));
            assert!((four - fine).abs() < 0.06, "λ = {}, q' = {p}: {four}, not {fine}", self.lambda);
            // The other program has friction as a piece of its own. The library has two pieces, and its error is not larger. Both columns are rounded.
            let [found, noted] = [two - four, coarse - fine];
            assert!(found.abs() <= noted.abs() + 0.11, "λ = {}, q' = {p}: {two}, not {coarse}", self.lambda);
        }
        for (p, noted) in self.librating {
            // Control of the name: a libration never reaches half of π, where a rotation of 600 turns has passed a hundred times.
            let far = four(*p).iter().map(|x| x.0.abs()).fold(0.0, f64::max);
            assert!((far - noted).abs() < 1.1e-3 && far < PI / 2.0, "λ = {}, q' = {p}: {far}", self.lambda);
        }

        // Without torque C q' is constant and the mean of 1/C is 1/√(1 − λ²): q' = √((1 − λ)/(1 + λ)) turns once an orbit.
        let free = Satellite { torque: [0.0; 15], ..system };
        let centre = ((1.0 - self.lambda) / (1.0 + self.lambda)).sqrt();
        assert!((centre - self.centre).abs() < 5.1e-6, "{centre}");
        let away = |p: f64| sections(free, Suzuki4.of(ContactSplitting), 40, (0.0, p), 600)[599].0;
        let drift = away(centre);
        assert!(drift.abs() < 1e-2, "{drift:e}");
        // Control: a start above the centre turns ahead.
        assert!(away(centre * 1.001) > 3.0, "{}", away(centre * 1.001));
    }
}

#[test]
fn sections_close_to_a_constant_moment_of_inertia() {
    let turning = [(1.137, 117.6, 117.6), (0.86, -118.2, -118.2)];
    let librating = &[(1.112, 1.186), (1.0, 0.011), (0.96, 0.322), (0.91, 0.811)];
    Coupling { lambda: 0.001, turning, librating, centre: 0.99900 }.holds();
}

#[test]
fn sections_with_a_hundredth() {
    let turning = [(1.135, 134.0, 134.0), (0.845, -132.2, -132.2)];
    let librating = &[(0.98, 0.079), (0.93, 0.515), (0.9, 0.833), (0.878, 1.171)];
    Coupling { lambda: 0.01, turning, librating, centre: 0.99005 }.holds();
}

#[test]
fn sections_with_a_tenth() {
    let turning = [(1.029, 122.2, 121.1), (0.773, -127.6, -128.3)];
    let librating = &[(0.8, 1.205), (0.82, 0.850), (0.84, 0.608), (0.9, 0.026), (0.92, 0.157)];
    Coupling { lambda: 0.1, turning, librating, centre: 0.90453 }.holds();
}

#[test]
fn sections_with_a_fifth() {
    let turning = [(0.917, 96.9, 94.1), (0.7, -120.3, -121.5)];
    let librating = &[(0.81, 0.036), (0.795, 0.190), (0.785, 0.296), (0.765, 0.518), (0.73, 1.016)];
    Coupling { lambda: 0.2, turning, librating, centre: 0.81650 }.holds();
}

#[test]
fn without_resonance_a_ring_becomes_chaos() {
    let rates = |lambda: f64| {
        let system = Satellite { lambda, omega: 2.0_f64.sqrt(), torque: torque(0.045, 0.06) };
        let found = sections(system, ContactSplitting, 20, (PI, 1.0), 3000);
        found.iter().fold([f64::MAX, f64::MIN], |[low, high], x| [low.min(x.1), high.max(x.1)])
    };
    let [low, high] = rates(0.01);
    assert!((low - 0.953).abs() < 5e-3 && (high - 1.022).abs() < 5e-3, "{low} {high}");
    let [low, high] = rates(0.2);
    assert!(low < 0.7 && high > 1.5, "{low} {high}");
}
