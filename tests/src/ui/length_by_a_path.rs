use geoint_runtime::prelude::*;

mod model {
    pub const N: usize = 2;
}

#[hamiltonian]
fn energy(q: [f64; model::N], p: [f64; model::N]) -> f64 {
    (0..2).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {
    println!("{}", energy([0.5; 2], [1.0; 2]));
}
