use geoint_runtime::lagrangian;

#[lagrangian(require(separable))]
fn bead(q: f64, v: f64) -> f64 {
    0.5 * (1.0 + 4.0 * q * q) * v * v - 9.81 * q * q
}

fn main() {}
