use geoint_runtime::lagrangian;

#[lagrangian]
fn slider(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
    0.5 * m * v[0] * v[0] - (q[0] - q[1]).powi(2)
}

fn main() {}
