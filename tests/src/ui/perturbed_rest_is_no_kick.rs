use geoint_runtime::prelude::*;

#[hamiltonian(split = "q * q / 2.0 + q.powi(4) | p * p / 2.0")]
fn duffing(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + q.powi(4)
}

fn main() {
    let mut sim = Duffing.integrator(WisdomHolman, 0.1, State::new(1.0, 0.0));
    let _ = sim.step();
}
