use geoint_runtime::lagrangian;

#[lagrangian(constraint = [v[0] * q[1].sin() - v[1] * q[1].cos()])]
fn skate(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1] + 0.3 * v[2] * v[2]) / 2.0
}

fn main() {}
