use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn entangled(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.0 + (q * p).sin() * s
}

fn main() {
    let _ = Entangled.integrator(ContactSplitting, 0.1, ContactState::new(1.0, 0.0, 0.0));
}
