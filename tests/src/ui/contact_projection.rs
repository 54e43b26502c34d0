use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn swing(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.0 + q.cos() + 0.1 * s
}

fn main() {
    let _ = Swing.integrator(Projection(RK4, Energy), 0.1, ContactState::new(1.0, 0.0, 0.0));
}
