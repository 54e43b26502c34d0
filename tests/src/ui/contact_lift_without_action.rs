use geoint_runtime::prelude::*;

#[contact_hamiltonian(lift)]
fn growth(q: f64, p: f64, rate: f64) -> f64 {
    p * rate * q
}

fn main() {
    println!("{}", growth(1.0, 0.0, 0.5));
}
