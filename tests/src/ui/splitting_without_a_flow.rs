use geoint_runtime::prelude::*;

/// The products of inertia couple momenta that are not in involution.
#[hamiltonian(structure = so3)]
fn skew_body(x: [f64; 3], a: f64, b: f64) -> f64 {
    x[0] * x[0] / a + x[1] * x[1] + x[2] * x[2] / b + x[0] * x[1] / 10.0
}

fn main() {
    let mut sim = SkewBody { a: 1.2, b: 3.0 }.integrator(PoissonSplitting, 0.01, FlowState::new([1.0; 3]));
    sim.advance(10).unwrap();
}
