use geoint_runtime::prelude::*;

#[hamiltonian]
fn pendulum(q: f64, p: f64) -> f64 {
    p * p / 2.0 - q.cos()
}

fn main() {
    let mut sim = Pendulum.integrator(PieceSplitting, 0.1, State::new(1.0, 0.0));
    let _ = sim.step();
}
