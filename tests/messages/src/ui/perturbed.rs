mod perturbed_coordinates_coupled {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = jacobi)]
    fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 {
        let kinetic = (p[0][0].powi(2) + p[0][1].powi(2) + p[1][0].powi(2) + p[1][1].powi(2)) / 2.0;
        kinetic + p[0][0] * q[1][0]
    }
}

mod perturbed_coordinates_of_one_body {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = jacobi)]
    fn oscillator(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / q[0].hypot(q[1])
    }
}

mod perturbed_coordinates_without_centre {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = jacobi)]
    fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 {
        let kinetic = (p[0][0].powi(2) + p[0][1].powi(2) - p[1][0].powi(2) - p[1][1].powi(2)) / 2.0;
        kinetic - 1.0 / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }
}

mod perturbed_coordinates_without_mass {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = heliocentric)]
    fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2], m: f64) -> f64 {
        (p[1][0].powi(2) + p[1][1].powi(2)) / (2.0 * m) - m / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }
}

mod perturbed_damped {
    use geoint_runtime::prelude::*;

    #[hamiltonian(split = "p * p / 2.0 + q * q / 2.0 | q.powi(4)", damping = 0.1)]
    fn duffing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + q.powi(4)
    }
}

mod perturbed_mass_matrix {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = jacobi)]
    fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2], m: f64) -> f64 {
        let kinetic = (p[0][0].powi(2) + p[0][1].powi(2) + p[1][0].powi(2) + p[1][1].powi(2)) / (2.0 * m);
        kinetic + p[0][0] * p[1][0] / m - 1.0 / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }
}

mod perturbed_no_attraction {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = jacobi)]
    fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 {
        let kinetic = (p[0][0].powi(2) + p[0][1].powi(2) + p[1][0].powi(2) + p[1][1].powi(2)) / 2.0;
        kinetic + ((q[0][0] - q[1][0]).powi(2) + (q[0][1] - q[1][1]).powi(2)) / 2.0
    }
}

mod perturbed_parts_are_not_the_sum {
    use geoint_runtime::prelude::*;

    #[hamiltonian(split = "p * p / 2.0 + q * q / 2.0 | 2.0 * q.powi(4)")]
    fn duffing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + q.powi(4)
    }
}

mod perturbed_two_masses_a_body {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = heliocentric)]
    fn pair(q: [[f64; 2]; 2], p: [[f64; 2]; 2], m: [f64; 2]) -> f64 {
        let kinetic = (p[0][0].powi(2) + p[0][1].powi(2)) / (2.0 * m[0]) + p[1][0].powi(2) / (2.0 * m[1]);
        kinetic + p[1][1].powi(2) / m[1] - 1.0 / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }
}

mod perturbed_two_ways {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = jacobi, split = "p | q")]
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
}

mod perturbed_unknown_coordinates {
    use geoint_runtime::prelude::*;

    #[hamiltonian(coordinates = polar)]
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
}

mod perturbed_without_flow {
    use geoint_runtime::prelude::*;

    #[hamiltonian(split = "p * p / 2.0 + q.powi(4) | q * q / 2.0")]
    fn duffing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + q.powi(4)
    }
}

fn main() {}
