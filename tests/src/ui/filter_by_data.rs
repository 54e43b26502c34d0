use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
    p[0] * p[0] + q.iter().filter(|x| **x > 0.0).sum::<f64>()
}

fn main() {
    println!("{}", energy([0.5; 3], [1.0; 3]));
}
