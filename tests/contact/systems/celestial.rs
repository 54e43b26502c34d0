//! Orbits, stars, and the rotation of satellites.

use super::*;
use core::f64::consts::PI;

fn ellipse(e: f64) -> ContactState<[f64; 2]> {
    ContactState::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()], 0.0)
}

#[test]
fn p_kepler() {
    let system = PerturbedKepler { alpha: -0.07, omega: 2.0 * PI };
    let truth = solution(&system, &ellipse(0.4), 10.0, 400);
    println!("{:.1e}", gap(&truth, &solution(&system, &ellipse(0.4), 10.0, 800)));
    for h in [0.1, 0.05, 0.025, 0.0125] {
        let e = |x: Result<Vec<f64>, StepError>| x.map(|x| gap(&x, &truth)).unwrap();
        println!("{h} {:.2e} {:.2e} {:.2e} {:.2e}", e(after(system, ContactSplitting, h, ellipse(0.4), 10.0)),
            e(after(system, Yoshida4.of(ContactSplitting), h, ellipse(0.4), 10.0)),
            e(after(system, Suzuki4.of(ContactSplitting), h, ellipse(0.4), 10.0)),
            e(after(system, Yoshida6a.of(ContactSplitting), h, ellipse(0.4), 10.0)));
    }
}

#[test]
fn p_lane() {
    for (abc, end) in [([1.0, 0.0, 0.0], 2.4), ([0.0, 1.0, 0.0], 3.4), ([0.0, 0.0, 1.0], 30.0)] {
        let [a, b, c] = abc;
        let system = LaneEmden { a, b, c };
        let exact = |t: f64| a * (1.0 - t * t / 6.0) + b * t.sin() / t + c / (1.0 + t * t / 3.0).sqrt();
        let mut sim = system.integrator(ContactSplitting, 0.01, ContactState::new(1.0, 0.0, 0.0));
        println!("{:?}", sim.step());
        let mut e = 0.0_f64;
        for x in sim.until(end) {
            let x = x.unwrap();
            e = e.max((x.q - exact(x.t)).abs());
        }
        println!("{e:.2e}");
    }
}

fn coefficients(e: f64) -> [f64; 15] {
    core::array::from_fn(|i| {
        let k = i as f64 - 5.0;
        let n = 64;
        (0..n).map(|j| {
            let u = 2.0 * PI * j as f64 / n as f64;
            let r = 1.0 - e * u.cos();
            let f = 2.0 * ((u / 2.0).sin() * (1.0 + e).sqrt()).atan2((u / 2.0).cos() * (1.0 - e).sqrt());
            (2.0 * f - k * (u - e * u.sin())).cos() / (r * r)
        }).sum::<f64>() / n as f64
    })
}

#[test]
fn p_spin() {
    println!("{:?}", coefficients(0.06));
    let system = SpinOrbit { delta: 1e-3, lambda: 1e-4, omega: 1.0, eps: 0.0075, mu: 1e-3, c: coefficients(0.01) };
    let mut sim = system.integrator(ContactSplitting, PI / 10.0, ContactState::new(2.7, 3.0, 0.0));
    let mut sections = vec![];
    for x in sim.sampled(20).take(1591) { sections.push(x.unwrap().p); }
    println!("{} {}", sections[159], sections[796]);
    let last = &sections[sections.len() - 500..];
    println!("{} {:?}", last.iter().sum::<f64>() / 500.0, last.iter().fold((9.0_f64, 0.0_f64), |(a, b), x| (a.min(*x), b.max(*x))));
}

#[test]
fn p_momentum() {
    let system = PerturbedKepler { alpha: -0.07, omega: 2.0 * PI };
    let h = 0.05;
    let mut sim = system.integrator(ContactSplitting, h, ellipse(0.4));
    let l = |x: ContactState<[f64; 2]>| x.q[0] * x.p[1] - x.q[1] * x.p[0];
    let l0 = l(sim.state());
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    for n in 0..2000 {
        sim.step().unwrap();
        sum += h * system.alpha * (system.omega * (n as f64 + 0.5) * h).sin();
        worst = worst.max((l(sim.state()) / (l0 * (-sum as f64).exp()) - 1.0).abs());
    }
    println!("{worst:.2e}");
}
