mod entropy_alone {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = canonical, entropy = x[0])]
    fn swing(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }
}

mod entropy_changed_by_structure {
    use geoint_runtime::prelude::*;

    /// The gas does no work on the piston.
    #[hamiltonian(
        structure = |i, j| if i == 0 && j == 1 { 1.0 } else { 0.0 },
        entropy = 1.5 * x[2].ln() + x[0].ln(),
        friction = [[0.0, 0.0, 0.0], [0.0, c, -c * x[1]], [0.0, -c * x[1], c * x[1] * x[1]]],
    )]
    fn gas(x: [f64; 3], c: f64) -> f64 {
        x[1] * x[1] / 2.0 + x[2]
    }
}

mod entropy_of_damping {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = canonical, entropy = 1.0, friction = 0.1, damping = 0.1)]
    fn swing(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }
}

mod entropy_of_momenta {
    use geoint_runtime::prelude::*;

    #[hamiltonian(entropy = q, friction = 0.1)]
    fn swing(q: f64, p: f64) -> f64 {
        p * p / 2.0 - q.cos()
    }
}

mod entropy_that_reads_time {
    use geoint_runtime::prelude::*;

    #[hamiltonian(
        structure = |_, _| 0.0,
        entropy = x[0].ln() + x[1].ln() + t,
        friction = [[1.0, -1.0], [-1.0, 1.0]],
    )]
    fn bodies(x: [f64; 2], t: f64) -> f64 {
        x[0] + x[1] + 0.0 * t
    }
}

mod friction_alone {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = canonical, friction = 0.1)]
    fn swing(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }
}

mod friction_indefinite {
    use geoint_runtime::prelude::*;

    #[hamiltonian(
        structure = |_, _| 0.0,
        entropy = x[0].ln() + x[1].ln(),
        friction = [[-1.0, 1.0], [1.0, -1.0]],
    )]
    fn negative(x: [f64; 2]) -> f64 {
        x[0] + x[1]
    }

    #[hamiltonian(
        structure = |_, _| 0.0,
        entropy = x.iter().map(|x| x.ln()).sum::<f64>(),
        friction = [[1.0, -2.0, 1.0], [-2.0, 1.0, 1.0], [1.0, 1.0, -2.0 + 2.0]],
    )]
    fn indefinite(x: [f64; 3]) -> f64 {
        x[0] + x[1]
    }
}

mod friction_not_symmetric {
    use geoint_runtime::prelude::*;

    #[hamiltonian(
        structure = |_, _| 0.0,
        entropy = x[0].ln() + x[1].ln(),
        friction = [[x[0], -x[0]], [-x[1], x[1]]],
    )]
    fn bodies(x: [f64; 2]) -> f64 {
        x[0] + x[1]
    }
}

mod friction_that_is_zero {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = so3, entropy = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], friction = 0.0)]
    fn body(x: [f64; 3]) -> f64 {
        x[0] * x[0] + x[1] * x[1] / 2.0
    }
}

mod friction_that_takes_energy {
    use geoint_runtime::prelude::*;

    /// The bath does not get what friction takes.
    #[hamiltonian(
        structure = |i, j| if i == 0 && j == 1 { 1.0 } else { 0.0 },
        entropy = 2.0 * x[2].ln(),
        friction = [[0.0, 0.0, 0.0], [0.0, c, 0.0], [0.0, 0.0, 0.0]],
    )]
    fn bath(x: [f64; 3], c: f64) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos() + x[2]
    }
}

fn main() {}
