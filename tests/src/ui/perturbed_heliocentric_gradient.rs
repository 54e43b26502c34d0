use geoint_runtime::prelude::*;

#[hamiltonian(coordinates = heliocentric)]
fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3]) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            energy -= m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
        }
    }
    energy
}

fn main() {
    let start = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], [[0.0; 2]; 3]);
    let mut sim = Planets { m: [1.0, 0.1, 0.1] }.integrator(WisdomHolmanGradient, 0.1, start);
    let _ = sim.advance(10);
}
