//! Every family of pieces with a flow in closed form, against the differential equation solved to 30 digits.

use geoint_runtime::prelude::*;

#[test]
fn reports() {
    #[contact_hamiltonian]
    fn damped(q: f64, p: f64, s: f64, g: f64) -> f64 {
        p * p / 2.0 - q.cos() + g * s
    }
    println!("{}", Damped::REPORT);
    #[contact_hamiltonian]
    fn perturbed(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64, w: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + a * (w * t).sin() * s
    }
    println!("{}", Perturbed::REPORT);
    #[contact_hamiltonian]
    fn lane_emden(q: f64, p: f64, s: f64, t: f64) -> f64 {
        p * p / 2.0 + 2.0 / t * s + q.powi(6) / 6.0
    }
    println!("{}", LaneEmden::REPORT);
    #[contact_hamiltonian]
    fn vdp(q: f64, p: f64, s: f64, eps: f64) -> f64 {
        p * s - eps * (1.0 - q * q) * s + q
    }
    println!("{}", Vdp::REPORT);
    #[contact_hamiltonian]
    fn cosmo(q: f64, p: f64, s: f64, r: f64) -> f64 {
        (p * p + q * q + s * s) / 2.0 - r
    }
    println!("{}", Cosmo::REPORT);
    #[contact_hamiltonian]
    fn thermostat(q: f64, p: f64, s: f64) -> f64 {
        (p * p / 2.0 - q.cos()) * (0.6 * s).exp()
    }
    println!("{}", Thermostat::REPORT);
    let mut sim = Damped { g: 0.1 }.integrator(ContactSplitting, 0.1, ContactState::new(1.0, 0.5, 0.3));
    sim.advance(100).unwrap();
    println!("{:?}", sim.state());
    panic!();
}
