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
