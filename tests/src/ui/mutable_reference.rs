use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let mut x = q;
    {
        let y = &mut x;
        *y += 1.0;
    }
    p * p + x
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
