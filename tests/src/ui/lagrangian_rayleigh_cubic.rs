use geoint_runtime::lagrangian;

#[lagrangian(rayleigh = c * v.powi(3) / 3.0)]
fn oscillator(q: f64, v: f64, c: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q
}

#[lagrangian(rayleigh = c * v)]
fn pulled(q: f64, v: f64, c: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q
}

fn main() {}
