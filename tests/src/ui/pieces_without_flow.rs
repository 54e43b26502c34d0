use geoint_runtime::prelude::*;

#[hamiltonian]
fn rods(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 + (q[0] * p[1]).cos() + q[1].cos() * p[0].cos()) - q[1].cos()
}

fn main() {
    let mut sim = Rods.integrator(PieceSplitting, 0.1, State::new([1.0, 0.5], [0.0, 0.0]));
    let _ = sim.step();
}
