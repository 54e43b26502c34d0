use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; 2], p: [f64; 2]) -> f64 {
    let mut reach = [1.0; 2];
    for i in 0..2 {
        if q[i] > 0.0 {
            reach[i] = 2.0;
        }
    }
    p[0] * p[0] + p[1] * p[1] + reach[0] * q[0].powi(4) + reach[1] * q[1].powi(4)
}

fn main() {
    println!("{}", energy([0.5; 2], [1.0; 2]));
}
