use geoint_runtime::lagrangian;

#[lagrangian]
fn oscillator(q: f64, qdot: f64) -> f64 {
    0.5 * qdot * qdot - 0.5 * q * q
}

fn main() {}
