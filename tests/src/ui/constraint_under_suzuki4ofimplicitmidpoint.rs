use geoint_runtime::prelude::*;

#[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
}

fn main() {
    let _ = Pendulum { l: 1.0 }.integrator(Suzuki4.of(ImplicitMidpoint), 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
}
