use geoint_runtime::prelude::*;

#[hamiltonian(split = "p.powi(4) | q.powi(4)")]
fn quartic(q: f64, p: f64) -> f64 {
    p.powi(4) + q.powi(4)
}

fn main() {
    let mut sim = Quartic.integrator(Saba3Gradient, 0.1, State::new(1.0, 0.5));
    let _ = sim.step();
}
