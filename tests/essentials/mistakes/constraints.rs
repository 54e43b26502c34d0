mod constraint_reads_momenta {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l + 0.1 * p[0] * q[0]])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }
}

mod constraint_reads_no_position {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(constraint = [l * l - 1.0])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }
}

mod constraint_with_structure {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(structure = so3, constraint = [x[0] * x[0] - 1.0])]
    fn top(x: [f64; 3], a: f64) -> f64 {
        x[0] * x[0] / a + x[1] * x[1] + x[2] * x[2] / 3.0
    }
}

mod constraints_dependent {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l, ((q[0] * q[0] + q[1] * q[1]) / (l * l)).ln()])]
    fn pendulum(q: [f64; 3], p: [f64; 3], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + 6.9 * q[2] / l
    }
}

mod constraints_none {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(constraint = [])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }
}

mod constraints_of_all_coordinates {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l, q[0] - q[1]])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }
}

mod constraint_more_than_coordinates {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(constraint = [q[0] - t * l, q[1] - t, q[0] * q[1] - t])]
    fn driven(q: [f64; 2], p: [f64; 2], t: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4
    }
}

fn main() {}
