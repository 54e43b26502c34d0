use geoint_runtime::prelude::*;

/// None of 15 planes has a flow in closed form.
#[hamiltonian(structure = |_, _| 1.0)]
fn quartic(x: [f64; 6], k: f64) -> f64 {
    x.iter().map(|x| k * x.powi(4)).sum()
}

fn main() {
    let mut sim = Quartic { k: 1.3 }.integrator(Suzuki4.of(PlanarSplitting), 0.01, FlowState::new([1.0; 6]));
    sim.advance(10).unwrap();
}
