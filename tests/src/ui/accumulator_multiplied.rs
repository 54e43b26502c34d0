use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
    let mut e = p[0] * p[0];
    for i in 0..3 {
        e *= q[i];
    }
    e
}

fn main() {
    println!("{}", energy([0.5; 3], [1.0; 3]));
}
