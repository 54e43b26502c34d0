use geoint_runtime::prelude::*;

const N: usize = 3;

#[hamiltonian]
fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
    let mut e = 0.0;
    for i in 0..N {
        e += p[i] * p[i] + q[i] * q[i];
    }
    e
}

fn main() {
    println!("{}", energy([0.5; 3], [1.0; 3]));
}
