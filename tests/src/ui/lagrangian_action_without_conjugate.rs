use geoint_runtime::prelude::*;

#[lagrangian]
fn stiff(q: f64, v: f64, s: f64, c: f64) -> f64 {
    0.5 * v * v + 0.25 * v.powi(4) - 0.5 * q * q - c * s
}

fn main() {
    let system = Stiff { c: 0.1 };
    let _ = system.integrator(ContactGauss::<2>, 0.1, system.at(0.1, 0.2, 0.0)).advance(9);
    let _ = system.integrator(ContactDiscreteGradient, 0.1, system.at(0.1, 0.2, 0.0)).advance(9);
}
