use geoint_runtime::prelude::*;

#[hamiltonian]
fn tangent(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q.tan()
}

fn main() {
    let _ = Tangent.integrator(DiscreteGradient, 0.01, State::new(0.5, 1.0));
}
