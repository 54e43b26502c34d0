use geoint_runtime::lagrangian;

#[lagrangian]
fn oscillator(q: f64, p: f64) -> f64 {
    0.5 * p * p - 0.5 * q * q
}

fn main() {}
