use geoint_runtime::prelude::*;

mod model {
    pub type Pair = [f64; 2];
}

#[hamiltonian]
fn energy(q: model::Pair, p: model::Pair) -> f64 {
    (0..2).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {
    println!("{}", energy([0.5; 2], [1.0; 2]));
}
