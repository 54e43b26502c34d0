use geoint_runtime::prelude::*;

#[hamiltonian(coordinates = jacobi)]
fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 {
    let kinetic = (p[0][0].powi(2) + p[0][1].powi(2) + p[1][0].powi(2) + 2.0 * p[1][1].powi(2)) / 2.0;
    kinetic - 1.0 / ((q[0][0] - q[1][0]).powi(2) + (q[0][1] - q[1][1]).powi(2)).sqrt()
}

fn main() {}
