use geoint_runtime::prelude::*;

#[lagrangian]
fn arm(q: [f64; 3], v: [f64; 3], s: f64, m: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) - 0.1 * s
}

fn main() {
    let system = Arm { m: 0.7 };
    let start = system.at([0.3, -0.2, 0.5], [0.0; 3], 0.0);
    let _ = system.integrator(StormerVerlet, 0.1, start).advance(9);
    let _ = system.integrator(ContactSplitting, 0.1, start).advance(9);
}
