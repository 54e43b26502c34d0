use geoint_runtime::lagrangian;

#[lagrangian]
fn one_mass(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
    0.5 * m * (v[0] + v[1] * q[0].cos()).powi(2) - q[1] * q[1]
}

fn main() {}
