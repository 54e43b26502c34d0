use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn van_der_pol(q: f64, p: f64, s: f64, e: f64) -> f64 {
    p * s - e * (1.0 - q * q) * s + q
}

fn main() {
    let mut sim = VanDerPol { e: 5.0 }.integrator(Suzuki4.of(ContactLeapfrog), 0.1, ContactState::new(1.0, 0.0, 0.0));
    let start = sim.energy();
    sim.advance(100).unwrap();
    for state in sim.until(3.0) {
        println!("{}", state.unwrap().s);
    }
    println!("{} {:?}", sim.energy() - start, sim.state());
    sim.step().unwrap();
}
