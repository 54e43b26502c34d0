mod contact_action_is_a_vector {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn swing(q: [f64; 2], p: [f64; 2], s: [f64; 2]) -> f64 {
        p[0] * p[0] / 2.0 + q[0].cos() + 0.1 * s[0]
    }
}

mod contact_action_missing {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn swing(q: f64, p: f64, z: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * z
    }

    fn uses() {
        println!("{}", swing(1.0, 0.0, 0.0));
    }
}

mod contact_constrained_lift {
    use geoint_runtime::contact_hamiltonian;

    #[contact_hamiltonian(lift, constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
    fn turning(q: [f64; 2], p: [f64; 2], _s: f64, w: f64) -> f64 {
        w * (p[1] * q[0] - p[0] * q[1])
    }
}

mod contact_constrained_split {
    use geoint_runtime::contact_hamiltonian;

    #[contact_hamiltonian(split = "p[0] * p[0] | gamma * s", constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
        p[0] * p[0] + p[1] * p[1] + gamma * s
    }
}

mod contact_constraint_reads_action {
    use geoint_runtime::contact_hamiltonian;

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - s])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
        p[0] * p[0] + p[1] * p[1] + gamma * s
    }
}

mod contact_constraint_reads_momenta {
    use geoint_runtime::contact_hamiltonian;

    #[contact_hamiltonian(constraint = [q[0] * p[0] + q[1] * p[1]])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
        p[0] * p[0] + p[1] * p[1] + gamma * s
    }
}

mod contact_constraint_with_square_of_action {
    use geoint_runtime::contact_hamiltonian;

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
        p[0] * p[0] + p[1] * p[1] + gamma * s * s
    }
}

mod contact_damping {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(damping = 0.1)]
    fn swing(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * s
    }
}

mod contact_unknown_argument {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(friction = 0.1)]
    fn swing(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * s
    }
}

fn main() {}
