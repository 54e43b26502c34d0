use geoint_runtime::contact_hamiltonian;

#[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.1 * s
}

fn main() {}
