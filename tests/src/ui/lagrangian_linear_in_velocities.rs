use geoint_runtime::lagrangian;

#[lagrangian]
fn vortices(q: [f64; 2], v: [f64; 2], k: f64) -> f64 {
    k * q[0] * v[1] - (q[0] * q[0] + q[1] * q[1]).ln()
}

fn main() {}
