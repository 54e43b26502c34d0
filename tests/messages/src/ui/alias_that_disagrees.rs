use geoint_runtime::prelude::*;

type Plane = [f64; 3];

#[hamiltonian(type Plane = [f64; 2])]
fn energy(q: Plane, p: Plane) -> f64 {
    p[0] * p[0] + p[1] * p[1] + q[0] * q[1]
}

fn main() {
    println!("{}", energy([0.5; 3], [1.0; 3]));
}
