use geoint_runtime::lagrangian;

#[lagrangian(rayleigh = -v * v)]
fn oscillator(q: f64, v: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q
}

fn main() {}
