mod pieces_group_without_flow {
    use geoint_runtime::prelude::*;

    #[hamiltonian(split = "p[0] * p[0] / 2.0 | (q[0] * p[1]).cos() * q[1].cosh()")]
    fn tangle(q: [f64; 2], p: [f64; 2]) -> f64 {
        p[0] * p[0] / 2.0 + (q[0] * p[1]).cos() * q[1].cosh()
    }
}

mod structure_missing {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn free_body(x: [f64; 3]) -> f64 {
        x[0] * x[0] + x[1] * x[1] / 2.0 + x[2] * x[2] / 3.0
    }
}

mod structure_missing_of_another_name {
    use geoint_runtime::prelude::*;

    #[hamiltonian(x = l)]
    fn free_body(l: [f64; 3]) -> f64 {
        l[0] * l[0] + l[1] * l[1] / 2.0 + l[2] * l[2] / 3.0
    }
}

mod structure_not_skew {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = [[0.0, x[0] * x[1]], [x[0] * x[1], 0.0]])]
    fn species(x: [f64; 2]) -> f64 {
        x[0] + x[1]
    }

    #[hamiltonian(structure = [[x[0], 1.0], [-1.0, 0.0]])]
    fn leaking(x: [f64; 2]) -> f64 {
        x[0] * x[0] + x[1] * x[1]
    }
}

mod structure_of_another_length {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = so3)]
    fn four(x: [f64; 4]) -> f64 {
        x[0] * x[1] + x[2] * x[3]
    }

    #[hamiltonian(structure = [[0.0, 1.0], [-1.0, 0.0]])]
    fn three(x: [f64; 3]) -> f64 {
        x[0] * x[1] + x[2]
    }

    #[hamiltonian(structure = nambu(x[0]))]
    fn two(x: [f64; 2]) -> f64 {
        x[0] * x[1]
    }
}

mod structure_of_another_name {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = so4)]
    fn four(x: [f64; 6]) -> f64 {
        x[0] * x[1] + x[2] * x[3]
    }

    #[hamiltonian(structure = "so3")]
    fn three(x: [f64; 3]) -> f64 {
        x[0] * x[1] + x[2]
    }

    /// A second function would be the energy.
    #[hamiltonian(structure = nambu(x[0], x[1]))]
    fn two_functions(x: [f64; 3]) -> f64 {
        x[0] * x[1]
    }
}

mod structure_of_one_index {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = |i| gamma[i])]
    fn vortices(x: [f64; 4], gamma: [f64; 4]) -> f64 {
        x.iter().map(|x| x * x).sum()
    }

    /// A row is too short.
    #[hamiltonian(structure = [[0.0, 1.0], [-1.0]])]
    fn swing(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }
}

mod structure_se3_of_another_length {
    use geoint_runtime::prelude::*;

    /// (m, γ) are six numbers.
    #[hamiltonian(structure = se3)]
    fn top(x: [f64; 4]) -> f64 {
        x[0] * x[0] + x[3]
    }
}

mod structure_that_moves_nothing {
    use geoint_runtime::prelude::*;

    /// Given below the diagonal, where nobody asks.
    #[hamiltonian(structure = |i, j| if i > j { 1.0 } else { 0.0 })]
    fn swing(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }

    #[hamiltonian(structure = [[0.0, 0.0], [0.0, 0.0]])]
    fn still(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }

    #[hamiltonian(structure = nambu(k))]
    fn alone(x: [f64; 3], k: f64) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }

    /// With friction it is a way downhill.
    #[hamiltonian(structure = |_, _| 0.0, damping = k)]
    fn downhill(x: [f64; 2], k: f64) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }
}

mod structure_with_momenta {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = canonical)]
    fn pendulum(q: f64, p: f64) -> f64 {
        p * p / 2.0 - q.cos()
    }
}

mod structure_with_requirements {
    use geoint_runtime::prelude::*;

    #[hamiltonian(structure = canonical, require(separable))]
    fn pendulum(x: [f64; 2]) -> f64 {
        x[1] * x[1] / 2.0 - x[0].cos()
    }
}

fn main() {}
