use geoint_runtime::prelude::*;
#[contact_hamiltonian]
fn pendulum(q: f64, p: f64, s: f64, g: f64, e: f64) -> f64 {
    p * p / 2.0 - q.cos() + g * s + e * s * s / 2.0
}
#[test]
fn first() {
    println!("{}", Pendulum::REPORT);
    for e in [0.0, 0.2] {
        for h in [0.1, 0.05] {
            let mut sim = Pendulum { g: 0.1, e }.integrator(ContactDiscreteGradient, h, ContactState::new(1.0, 0.5, 0.3));
            let h0 = sim.energy();
            sim.advance((4.0 / h) as u64).unwrap();
            println!("{:?} {:e}", sim.state(), sim.energy() - h0 * (-0.4_f64).exp());
            let mut sim = Pendulum { g: 0.1, e }.integrator(ContactMidpoint, h, ContactState::new(1.0, 0.5, 0.3));
            sim.advance((4.0 / h) as u64).unwrap();
            println!("{:?} {:e}", sim.state(), sim.energy() - h0 * (-0.4_f64).exp());
        }
    }
}
