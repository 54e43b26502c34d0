use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
    let mut e = 0.0;
    for i in 0..3 {
        e += p[i] * p[i] / 2.0;
        if q[i] < 0.0 {
            continue;
        }
        e += q[i].powi(4);
    }
    e
}

fn main() {
    println!("{}", energy([0.5; 3], [1.0; 3]));
}
