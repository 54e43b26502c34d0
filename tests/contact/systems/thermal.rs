//! Heat.
use super::*;
#[test]
fn p_thermo() {
    for (k, h) in [(0.1, 0.1), (0.1, 0.01), (0.02, 0.1), (0.3, 0.01)] {
    for (q, p) in [(1.0, 0.5), (0.1, 0.0), (2.0, 3.0)] {
    let system = Thermostat { ground: 0.5, k };
    let start = ContactState::new(q, p, 0.3 / k);
    let mut sim = system.integrator(ContactSplitting, h, start);
    let mut bins = [0usize; 10];
    let mut mech = [0usize; 8];
    let n = 2_000_000;
    for _ in 0..n {
        if let Err(e) = sim.step() { println!("{e:?}"); break; }
        let x = sim.state();
        let i = ((x.s * k + 2.5) * 2.0).clamp(0.0, 9.9) as usize;
        bins[i] += 1;
        // quantile of energy: P(E > x) = ground/x
        let e = 0.5 + (x.q * x.q + x.p * x.p) / 2.0;
        mech[((1.0 - 0.5 / e) * 8.0) as usize] += 1;
    }
    let n = sim.steps();
    let expected: Vec<f64> = (0..10).map(|i| { let a = -2.5 + i as f64 / 2.0; (((a + 0.5) as f64).tanh() - a.tanh()) / 2.0 }).collect();
    println!("{k} {h} {q} {p} {:.4?}", bins.map(|b| b as f64 / n as f64));
    println!("{expected:.4?}");
    println!("{:.4?} {:?}", mech.map(|b| b as f64 / n as f64), sim.state());
    }}
}
