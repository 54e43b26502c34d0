use geoint_runtime::prelude::*;

#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.cos()
}

fn main() {
    let _ = Pendulum { m: 1.0 }.integrator(FiveRotations, 0.1, State::new(1.0, 0.0));
}
