use geoint_runtime::prelude::*;

#[hamiltonian]
fn spiral(q: f64, p: f64, b: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + b * q * p
}

fn main() {
    let system = Spiral { b: 0.1 };
    let mut sim = system.integrator(StormerVerlet, 0.01, State::new(0.5, 1.0));
    sim.advance(10).unwrap();
}
