use geoint_runtime::lagrangian;

#[lagrangian(damping = 0.1)]
fn oscillator(q: f64, v: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q
}

fn main() {}
