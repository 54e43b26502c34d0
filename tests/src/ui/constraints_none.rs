use geoint_runtime::hamiltonian;

#[hamiltonian(constraint = [])]
fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
}

fn main() {}
