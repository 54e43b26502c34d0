use geoint_runtime::prelude::*;

#[contact_hamiltonian(lift)]
fn decay(q: f64, p: f64, _s: f64) -> f64 {
    p * (q - q.powi(3))
}

fn main() {
    let _ = Decay.integrator(ContactMidpoint, 0.1, ContactState::new(1.0, 0.0, 0.0));
}
