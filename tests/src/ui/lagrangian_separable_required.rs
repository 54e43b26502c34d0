use geoint_runtime::lagrangian;

#[lagrangian(require(separable))]
fn bead(q: f64, v: f64) -> f64 {
    0.5 * (1.0 + 4.0 * q * q) * v * v - 9.81 * q * q
}

#[lagrangian(rayleigh = 0.3 * v * v, require(separable))]
fn rubbed(q: f64, v: f64, s: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - 0.1 * s
}

fn main() {}
