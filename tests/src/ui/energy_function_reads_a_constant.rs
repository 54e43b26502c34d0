use geoint_runtime::prelude::*;

mod forces {
    use geoint_runtime::prelude::*;

    const DEPTH: f64 = 0.5;

    #[energy_function]
    pub fn potential(q: f64) -> f64 {
        DEPTH * q * q
    }
}
use forces::potential;

const DEPTH: f64 = 2.0;

#[hamiltonian(with(potential))]
fn energy(q: f64, p: f64) -> f64 {
    DEPTH * p * p + potential(q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
