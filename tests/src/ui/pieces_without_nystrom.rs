use geoint_runtime::prelude::*;

#[hamiltonian]
fn charge(q: [f64; 2], p: [f64; 2], b: f64) -> f64 {
    (p[0] * p[0] + (p[1] - b * q[0] * q[0]).powi(2)) / 2.0 + q[1].cos()
}

fn main() {
    let mut sim = Charge { b: 1.0 }.integrator(BlanesMoanSrkn14a.of(PieceSplitting), 0.1, State::new([1.0, 0.5], [0.0, 0.0]));
    let _ = sim.step();
}
