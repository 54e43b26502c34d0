use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let e = p * p;
    if q > 0.0 {
        let _unused = q;
    }
    e
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
