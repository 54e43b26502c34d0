use geoint_runtime::prelude::*;

#[hamiltonian]
fn lorenz(q: [f64; 3], sigma: f64, rho: f64, beta: f64) -> [f64; 3] {
    [sigma * (q[1] - q[0]), q[0] * (rho - q[2]) - q[1], q[0] * q[1] - beta * q[2]]
}

fn main() {
    println!("{:?}", lorenz([1.0; 3], 10.0, 28.0, 2.7));
}
