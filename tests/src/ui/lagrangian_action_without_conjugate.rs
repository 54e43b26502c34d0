use geoint_runtime::lagrangian;

#[lagrangian]
fn stiff(q: f64, v: f64, s: f64, c: f64) -> f64 {
    0.5 * v * v + 0.25 * v.powi(4) - 0.5 * q * q - c * s
}

fn main() {}
