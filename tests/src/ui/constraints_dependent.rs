use geoint_runtime::hamiltonian;

#[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l, ((q[0] * q[0] + q[1] * q[1]) / (l * l)).ln()])]
fn pendulum(q: [f64; 3], p: [f64; 3], l: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + 6.9 * q[2] / l
}

fn main() {}
