use geoint_runtime::prelude::*;

/// Of degree 4 in the second position, in more than three coordinates.
#[hamiltonian(structure = canonical)]
fn quartic(x: [f64; 4], k: f64) -> f64 {
    (x[0] * x[0] + x[2] * x[2] + x[3] * x[3]) / 2.0 + k * x[1].powi(4)
}

fn main() {
    let mut sim = Quartic { k: 1.3 }.integrator(Suzuki4.of(PlanarSplitting), 0.01, FlowState::new([1.0; 4]));
    sim.advance(10).unwrap();
}
