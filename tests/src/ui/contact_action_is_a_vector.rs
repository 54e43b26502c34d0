use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn swing(q: [f64; 2], p: [f64; 2], s: [f64; 2]) -> f64 {
    p[0] * p[0] / 2.0 + q[0].cos() + 0.1 * s[0]
}

fn main() {}
