use geoint_runtime::prelude::*;

/// Every plane would have an equation of its own: 15.
#[hamiltonian(structure = |_, _| 1.0)]
fn quartic(x: [f64; 6], k: f64) -> f64 {
    x.iter().map(|x| k * x.powi(4)).sum()
}

fn main() {
    let mut sim = Quartic { k: 1.3 }.integrator(PlanarItohAbePair, 0.01, FlowState::new([1.0; 6]));
    sim.advance(10).unwrap();
}
