use geoint_runtime::lagrangian;

#[lagrangian]
fn oscillator(q: [f64; 2], v: f64) -> f64 {
    0.5 * v * v - 0.5 * q[0] * q[1]
}

fn main() {}
