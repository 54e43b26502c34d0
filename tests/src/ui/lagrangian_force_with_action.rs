use geoint_runtime::lagrangian;

#[lagrangian(force = 0.3 * t.sin())]
fn driven(q: f64, v: f64, s: f64, t: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - 0.1 * s
}

#[lagrangian(rayleigh = 0.3 * v * v)]
fn rubbed(q: f64, v: f64, s: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - 0.1 * s
}

fn main() {}
