mod perturbed_coupled {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn rods(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] * q[0].cos()) / 2.0 - q[1].cos()
    }

    fn uses() {
        let mut sim = Rods.integrator(WisdomHolman, 0.1, State::new([1.0, 0.5], [0.0, 0.0]));
        let _ = sim.step();
    }
}

mod perturbed_heliocentric_gradient {
    use geoint_runtime::{methods::*, prelude::*};

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

    fn uses() {
        let start = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], [[0.0; 2]; 3]);
        let mut sim = Planets { m: [1.0, 0.1, 0.1] }.integrator(WisdomHolmanGradient, 0.1, start);
        let _ = sim.advance(10);
    }
}

mod perturbed_rest_is_no_kick {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(split = "q * q / 2.0 + q.powi(4) | p * p / 2.0")]
    fn duffing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + q.powi(4)
    }

    fn uses() {
        let mut sim = Duffing.integrator(WisdomHolman, 0.1, State::new(1.0, 0.0));
        let _ = sim.step();
    }
}

mod perturbed_three_parts {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(split = "p * p / 2.0 | q * q / 2.0 | q.powi(4)")]
    fn duffing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + q.powi(4)
    }

    fn uses() {
        let mut sim = Duffing.integrator(WisdomHolman, 0.1, State::new(1.0, 0.0));
        let _ = sim.step();
    }
}

mod perturbed_without_coordinates {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
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

    fn uses() {
        let start = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], [[0.0; 2]; 3]);
        let mut sim = Planets { m: [1.0, 0.1, 0.1] }.integrator(Aba10_6_4, 0.1, start);
        let _ = sim.advance(10);
    }
}

mod perturbed_without_gradient {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(split = "p.powi(4) | q.powi(4)")]
    fn quartic(q: f64, p: f64) -> f64 {
        p.powi(4) + q.powi(4)
    }

    fn uses() {
        let mut sim = Quartic.integrator(Saba3Gradient, 0.1, State::new(1.0, 0.5));
        let _ = sim.step();
    }
}

fn main() {}
