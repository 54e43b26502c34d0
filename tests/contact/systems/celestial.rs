//! Orbits, stars, and the rotation of satellites.

use super::*;
use core::f64::consts::PI;
use geoint_runtime::methods::*;

type Body = ContactState<[f64; 2]>;

const KEPLER: PerturbedKepler = PerturbedKepler { alpha: -0.07, omega: 2.0 * PI };

fn pericentre(e: f64) -> Body {
    ContactState::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()], 0.0)
}

fn truth(duration: f64) -> Vec<f64> {
    let system = PerturbedKepler { alpha: Double::from(KEPLER.alpha), omega: Double::from(KEPLER.omega) };
    solution(&system, &flat(&pericentre(0.4)), duration, 40)
}

/// A. Bravetti, M. Seri, M. Vermeeren & F. Zadra (2020), e = 0.4.
#[test]
fn perturbed_kepler_has_known_errors() {
    let truth = truth(10.0);
    let errors = |run: &dyn Fn(f64) -> Vec<f64>| [0.025, 0.0125].map(|h| gap(&run(h), &truth));
    let start = pericentre(0.4);
    let two = errors(&|h| after(KEPLER, ContactSplitting, h, start, 10.0));
    assert!(two[1] < 1.56e-3 && (order(two) - 2.0).abs() < 0.02, "{two:?}");
    let triple = errors(&|h| after(KEPLER, Yoshida4.of(ContactSplitting), h, start, 10.0));
    assert!(triple[1] < 1.7e-6 && (order(triple) - 4.0).abs() < 0.05, "{triple:?}");
    let four = errors(&|h| after(KEPLER, Suzuki4.of(ContactSplitting), h, start, 10.0));
    assert!(four[1] < 1.95e-8 && (order(four) - 4.0).abs() < 0.05, "{four:?}");
    let six = errors(&|h| after(KEPLER, Yoshida6a.of(ContactSplitting), h, start, 10.0));
    assert!(six[1] < 8.3e-11 && (order(six) - 6.0).abs() < 0.2, "{six:?}");
    let best = errors(&|h| after(KEPLER, BlanesMoan6, 2.0 * h, start, 10.0));
    assert!(best[1] < 8e-11 && (order(best) - 6.0).abs() < 0.2, "{best:?}");
}

/// Friction acts at both ends of a step, not twice at one end. The errors of friction at one end would cancel after a multiple of the period of
/// friction. The time is no such multiple.
#[test]
fn the_leapfrog_is_of_order_two_where_friction_changes() {
    let (start, duration) = (pericentre(0.4), 9.3);
    let truth = truth(duration);
    let errors = [0.0125, 0.00625].map(|h| gap(&after(KEPLER, ContactLeapfrog, h, start, duration), &truth));
    assert!(errors[1] < 5e-4 && (order(errors) - 2.0).abs() < 0.02, "{errors:?}");
}

/// L is multiplied by e^(−hg) at the time in the middle. At h = 0.05 the same twenty factors come again and again: a rounding of theirs
/// would add up.
#[test]
fn angular_momentum_decays_by_its_law_whatever_the_error_of_the_orbit() {
    let momentum = |x: &Body| x.q[0] * x.p[1] - x.q[1] * x.p[0];
    for h in [0.0125, 0.037, 0.05, 0.053] {
        let mut worst = 0.0_f64;
        let mut sim = KEPLER.integrator(ContactSplitting, h, pericentre(0.4));
        let start = momentum(&sim.state());
        let mut exponent = 0.0;
        for n in 0..2000 {
            sim.step().unwrap();
            exponent -= h * KEPLER.alpha * (KEPLER.omega * (f64::from(n) + 0.5) * h).sin();
            let defect = momentum(&sim.state()) / (start * f64::exp(exponent)) - 1.0;
            worst = worst.max(defect.abs());
        }
        println!("h = {h}: {worst:.1e}");
        assert!(worst <= 2e-14, "h = {h}: {worst:.1e}");
    }
}

/// Index, potential, end, solution.
type Star = (f64, LaneEmden, f64, fn(f64) -> f64);

const STARS: [Star; 3] = [
    (0.0, LaneEmden { a: 1.0, b: 0.0, c: 0.0 }, 2.4, |t| 1.0 - t * t / 6.0),
    (1.0, LaneEmden { a: 0.0, b: 1.0, c: 0.0 }, 3.4, |t| t.sin() / t),
    (5.0, LaneEmden { a: 0.0, b: 0.0, c: 1.0 }, 30.0, |t| 1.0 / (1.0 + t * t / 3.0).sqrt()),
];

#[test]
fn stars_from_their_singular_centre() {
    for (n, system, end, exact) in STARS {
        for (h, bound) in [(0.2, 3.5e-3), (0.01, 8.5e-6)] {
            let mut sim = system.integrator(ContactSplitting, h, ContactState::new(1.0, 0.0, 0.0));
            let error = largest(sim.until(end).map(|x| x.map(|x| x.q - exact(x.t)).unwrap()));
            assert!(error < bound && error > bound / 2.0, "n = {n}, h = {h}: {error:.2e}");
        }
    }
}

#[test]
fn stars_by_order_six_with_a_series_for_the_centre() {
    for (n, system, end, exact) in STARS {
        let t = 0.1_f64;
        // Coefficients of the series 1 − t²/6 + n t⁴/120 − …
        let series = [
            -1.0 / 6.0,
            n / 120.0,
            -n * (8.0 * n - 5.0) / 15120.0,
            n * (122.0 * n * n - 183.0 * n + 70.0) / 3_265_920.0,
        ];
        let (mut q, mut p) = (1.0, 0.0);
        for (k, c) in (1..).zip(series) {
            q += c * t.powi(2 * k);
            p += c * f64::from(2 * k) * t.powi(2 * k - 1);
        }
        let mut sim = system.integrator(Yoshida6a.of(ContactSplitting), 0.01, ContactState::at(t, q, p, 0.0));
        let error = largest(sim.until(end).map(|x| x.map(|x| x.q - exact(x.t)).unwrap()));
        assert!(error < 2e-12, "n = {n}: {error:.1e}");
    }
}

/// Returns the coefficients of (a/r)³ cos(2f − 2q) = Σ cₖ cos(2q − kt), k = −5, …, 9, as series in e up to e⁷. They follow in exact arithmetic from
/// the exponential of ike sin u, from r = 1 − e cos u and from Kepler's equation. The first number of each row belongs to e^|k − 2|, the others to
/// every second power after it.
fn cayley(e: f64) -> [f64; 15] {
    let rows: [&[f64]; 15] = [
        &[15625.0 / 129_024.0],
        &[4.0 / 45.0],
        &[81.0 / 1280.0, 81.0 / 2048.0],
        &[1.0 / 24.0, 7.0 / 240.0],
        &[1.0 / 48.0, 11.0 / 768.0, 313.0 / 30_720.0],
        &[],
        &[-1.0 / 2.0, 1.0 / 16.0, -5.0 / 384.0, -143.0 / 18_432.0],
        &[1.0, -5.0 / 2.0, 13.0 / 16.0, -35.0 / 288.0],
        &[7.0 / 2.0, -123.0 / 16.0, 489.0 / 128.0, -1763.0 / 2048.0],
        &[17.0 / 2.0, -115.0 / 6.0, 601.0 / 48.0],
        &[845.0 / 48.0, -32_525.0 / 768.0, 208_225.0 / 6144.0],
        &[533.0 / 16.0, -13_827.0 / 160.0],
        &[228_347.0 / 3840.0, -3_071_075.0 / 18_432.0],
        &[73_369.0 / 720.0],
        &[12_144_273.0 / 71_680.0],
    ];
    core::array::from_fn(|i| {
        let lowest = (i as i32 - 7).abs();
        (0..).zip(rows[i]).map(|(j, c)| c * e.powi(lowest + 2 * j)).sum()
    })
}

/// Returns these coefficients as mean values over an orbit in the eccentric anomaly, by the trapezoidal rule.
fn hansen(e: f64) -> [f64; 15] {
    core::array::from_fn(|i| {
        let mean = (0..64).map(|j| {
            let u = 2.0 * PI * f64::from(j) / 64.0;
            let r = 1.0 - e * u.cos();
            let f = ((1.0 - e * e).sqrt() * u.sin()).atan2(u.cos() - e);
            (2.0 * f - (i as f64 - 5.0) * (u - e * u.sin())).cos() / (r * r)
        });
        mean.sum::<f64>() / 64.0
    })
}

#[test]
fn the_series_of_the_coefficients_errs_like_e_to_the_eighth() {
    for e in [0.01, 0.06, 0.12] {
        let error = gap(&cayley(e), &hansen(e));
        assert!(error < 400.0 * f64::powi(e, 8) + 1e-15, "e = {e}: {error:.1e}");
    }
}

/// θ' at sections t = 2πk.
fn sections(system: SpinOrbit, q: f64, p: f64, n: usize) -> Vec<f64> {
    let mut sim = system.integrator(ContactSplitting, PI / 10.0, ContactState::new(q, p, 0.0));
    sim.sampled(20).take(n).map(|x| x.unwrap().p).collect()
}

#[test]
fn friction_captures_a_satellite_in_synchronous_rotation() {
    let torque = cayley(0.01).map(|c| 0.0075 * c);
    let system = SpinOrbit { tide: [1e-3; 2], inertia: [1e-4, 1.0], torque };
    let spin = sections(system, 2.7, 3.0, 1591);
    assert!((spin[159] - 1.74).abs() < 0.02, "{}", spin[159]);
    let last = &spin[spin.len() - 500..];
    let mean = last.iter().sum::<f64>() / 500.0;
    assert!((mean - 1.0).abs() < 0.005, "{mean}");
    assert!(last.iter().all(|p| (p - 1.0).abs() < 0.03));
}

#[test]
fn without_resonance_rotation_is_bounded() {
    for lambda in [0.01, 0.2] {
        let torque = cayley(0.06).map(|c| 0.045 * c);
        let system = SpinOrbit { tide: [0.0; 2], inertia: [lambda, 2.0_f64.sqrt()], torque };
        assert!(sections(system, PI, 1.0, 3000).iter().all(|p| (0.0..2.5).contains(p)), "λ = {lambda}");
    }
}
