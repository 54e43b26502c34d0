use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn swing(q: f64, p: f64, s: f64, t: f64) -> f64 {
    p * p / 2.0 + q.cos() + 0.1 * t.sin() * s
}

fn main() {
    let _ = Swing.integrator(BlanesMoanSrkn14a, 0.1, ContactState::new(1.0, 0.0, 0.0));
}
