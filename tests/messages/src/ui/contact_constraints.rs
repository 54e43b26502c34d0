mod action_and_constraint_under_contactgauss {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(ContactGauss::<2>, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod action_and_constraint_under_contactmidpoint {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(ContactMidpoint, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod action_and_constraint_under_a_table_of_kicks {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(BlanesMoan4, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod action_and_constraint_under_a_table_of_nystrom {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(BlanesMoanSrkn14a, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod action_and_constraint_under_a_table_of_pieces {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(BlanesMoan4X, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod action_and_constraint_under_dop853 {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(DOP853, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod action_and_constraint_under_rattle {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l + 0.2 * s
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(Rattle, 0.1, ContactState::new([0.6, -0.8], [0.0, 0.0], 0.0));
    }
}

mod splitting_beside_no_action {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(ContactSplitting, 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

fn main() {}
