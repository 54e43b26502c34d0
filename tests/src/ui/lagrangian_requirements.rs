use geoint_runtime::lagrangian;

#[lagrangian(require(quadratic, constant_mass))]
fn bead(q: f64, v: f64) -> f64 {
    0.5 * (1.0 + 4.0 * q * q) * v * v - 9.81 * q * q
}

#[lagrangian(require(quadratic))]
fn stiff(q: f64, v: f64) -> f64 {
    0.5 * v * v + 0.25 * v.powi(4) - q * q
}

#[lagrangian(require(regular))]
fn vortex(q: [f64; 2], v: [f64; 2]) -> f64 {
    q[0] * v[1] - q[0] * q[0] - q[1] * q[1]
}

fn main() {}
