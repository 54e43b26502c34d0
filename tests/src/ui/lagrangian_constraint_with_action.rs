use geoint_runtime::lagrangian;

#[lagrangian(constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
fn pendulum(q: [f64; 2], v: [f64; 2], s: f64, m: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - 9.81 * m * q[1] - 0.1 * s
}

fn main() {}
