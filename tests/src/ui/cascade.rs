use geoint_runtime::prelude::*;

/// One wrong method, and everything that may be done with its run.
#[hamiltonian]
fn polar(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / 2.0 - 1.0 / q[0]
}

fn main() {
    let mut sim = Polar {}.integrator(BlanesMoan6, 0.1, State::new([1.0, 0.0], [0.0, 1.0]));
    let start = sim.energy();
    sim.advance(100).unwrap();
    for state in sim.sampled(3).take(4) {
        println!("{:?}", state.unwrap());
    }
    for state in sim.until(3.0) {
        println!("{}", state.unwrap().q[0]);
    }
    println!("{} {:?} {}", sim.energy() - start, sim.state(), sim.time());
    sim.set_step_size(0.2);
    sim.step().unwrap();
    sim.compensated().advance_to(3.0).unwrap();
}
