use geoint_runtime::prelude::*;

#[lagrangian]
fn chain(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) + q[0].cos()
}

fn main() -> Result<(), StepError> {
    let system = Chain { m: 0.7 };
    let mut sim = system.integrator(StormerVerlet, 0.1, system.at([0.1, 0.2, 0.3], [0.0; 3]));
    sim.advance(10)
}
