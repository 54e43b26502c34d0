use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn swing(q: f64, p: f64, z: f64) -> f64 {
    p * p / 2.0 + q.cos() + 0.1 * z
}

fn main() {
    println!("{}", swing(1.0, 0.0, 0.0));
}
