use geoint_runtime::prelude::*;

#[hamiltonian]
fn driven(q: f64, p: f64, t: f64) -> f64 {
    p * p / 2.0 - q.cos() * t.sin()
}

fn main() {
    let mut sim = Driven.adaptive(Projection(DOP853, Energy), 1e-9, State::new(1.0, 0.0)).steps_between(1e-3, 1.0);
    let start = sim.energy();
    sim.advance_to(10.0).unwrap();
    for state in sim.until(20.0) {
        println!("{}", state.unwrap().q);
    }
    println!("{} {:?} {}", sim.energy() - start, sim.state(), sim.rejections());
}
