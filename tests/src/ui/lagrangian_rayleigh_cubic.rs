use geoint_runtime::lagrangian;

#[lagrangian(rayleigh = c * v.abs().powi(3) / 3.0)]
fn oscillator(q: f64, v: f64, c: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q
}

fn main() {}
