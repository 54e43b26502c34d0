mod rolling_is_quadratic {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(rolling = [v[0] * v[0] - q[1] * v[1]])]
    fn blade(q: [f64; 3], p: [f64; 3], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + 6.9 * q[2] / l
    }
}

mod rolling_reads_momenta {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(rolling = [p[0] - q[1] * v[1]])]
    fn blade(q: [f64; 3], p: [f64; 3], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + 6.9 * q[2] / l
    }
}

mod rolling_reads_no_velocity {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(rolling = [q[0] * q[1] - l])]
    fn blade(q: [f64; 3], p: [f64; 3], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + 6.9 * q[2] / l
    }
}

mod rolling_is_a_rate {
    use geoint_runtime::lagrangian;

    #[lagrangian(rolling = [v[0] - l * v[2]])]
    fn blade(q: [f64; 3], v: [f64; 3], l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[2] / l
    }
}

mod rolling_is_a_rate_of_a_product {
    use geoint_runtime::lagrangian;

    #[lagrangian(rolling = [q[1] * v[0] + q[0] * v[1]])]
    fn blade(q: [f64; 3], v: [f64; 3], l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[2] / l
    }
}

mod rolling_rows_dependent {
    use geoint_runtime::lagrangian;

    #[lagrangian(rolling = [v[0] - q[1] * v[2], q[0] * v[0] - q[0] * q[1] * v[2]])]
    fn blade(q: [f64; 3], v: [f64; 3], l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[2] / l
    }
}

mod rolling_depends_on_a_constraint {
    use geoint_runtime::lagrangian;

    #[lagrangian(constraint = [q[0] * q[1] - l], rolling = [q[2] * (q[1] * v[0] + q[0] * v[1])])]
    fn blade(q: [f64; 3], v: [f64; 3], l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[2] / l
    }
}

mod rolling_leaves_nothing {
    use geoint_runtime::lagrangian;

    #[lagrangian(rolling = [v[0] - q[1] * v[2], v[1] - q[2] * v[0], v[2] - q[0] * v[1]])]
    fn blade(q: [f64; 3], v: [f64; 3], l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[2] / l
    }
}

mod rolling_none {
    use geoint_runtime::lagrangian;

    #[lagrangian(rolling = [])]
    fn blade(q: [f64; 3], v: [f64; 3], l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[2] / l
    }
}

mod rolling_with_a_force {
    use geoint_runtime::hamiltonian;

    #[hamiltonian(rolling = [v[0] - q[1] * v[2]], force = [l, 0.0, 0.0])]
    fn blade(q: [f64; 3], p: [f64; 3], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + 6.9 * q[2] / l
    }
}

mod rolling_beside_an_action {
    use geoint_runtime::lagrangian;

    #[lagrangian(rolling = [v[0] - q[1] * v[2]])]
    fn blade(q: [f64; 3], v: [f64; 3], s: f64, l: f64) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - l * s
    }
}

mod rolling_of_a_contact_hamiltonian {
    use geoint_runtime::contact_hamiltonian;

    #[contact_hamiltonian(rolling = [v[0] - q[1] * v[2]])]
    fn blade(q: [f64; 3], p: [f64; 3], s: f64, l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 1.4 + l * s
    }
}

fn main() {}
