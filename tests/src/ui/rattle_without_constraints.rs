use geoint_runtime::prelude::*;

#[hamiltonian]
fn pendulum(q: f64, p: f64, l: f64) -> f64 {
    p * p / 1.4 - 6.9 * q.cos() / l
}

fn main() {
    let _ = Pendulum { l: 1.0 }.integrator(Rattle, 0.1, State::new(0.6, 0.0));
}
