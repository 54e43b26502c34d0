use geoint_runtime::prelude::*;

#[lagrangian(force = 0.3 * t.sin())]
fn driven(q: f64, v: f64, s: f64, t: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - 0.1 * s
}

fn main() {
    let _ = Driven.integrator(ContactSplitting, 0.1, Driven.at(1.0, 0.0, 0.0));
    let _ = Driven.integrator(ContactGauss::<2>, 0.1, Driven.at(1.0, 0.0, 0.0));
    let _ = Driven.integrator(StormerVerlet, 0.1, Driven.at(1.0, 0.0, 0.0));
}
