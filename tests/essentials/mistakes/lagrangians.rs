mod lagrangian_constraint_reads_velocities {
    use geoint_runtime::lagrangian;

    #[lagrangian(constraint = [v[0] * q[1].sin() - v[1] * q[1].cos()])]
    fn skate(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        m * (v[0] * v[0] + v[1] * v[1] + 0.3 * v[2] * v[2]) / 2.0
    }
}

mod lagrangian_constraint_reads_time {
    use geoint_runtime::lagrangian;

    #[lagrangian(constraint = [q[1] - a * (w * t).cos()])]
    fn lifted(q: [f64; 3], v: [f64; 3], t: f64, a: f64, w: f64) -> f64 {
        (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2.0 - 9.81 * q[1]
    }
}

mod lagrangian_constraint_with_action_and_friction {
    use geoint_runtime::lagrangian;

    #[lagrangian(constraint = [q[0] * q[0] + q[1] * q[1] - 1.0], rayleigh = 0.1 * (v[0] * v[0] + v[1] * v[1]))]
    fn pendulum(q: [f64; 2], v: [f64; 2], s: f64, m: f64) -> f64 {
        m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - 9.81 * m * q[1] - 0.1 * s
    }
}

mod lagrangian_constraint_with_friction_of_positions {
    use geoint_runtime::lagrangian;

    #[lagrangian(constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
    fn pendulum(q: [f64; 2], v: [f64; 2], s: f64, m: f64) -> f64 {
        m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - 9.81 * m * q[1] - 0.1 * q[1].exp() * s
    }
}

mod lagrangian_linear_with_action {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn vortex(q: [f64; 2], v: [f64; 2], s: f64, m: f64) -> f64 {
        m * (q[0] * v[1] - q[1] * v[0]) / 2.0 - (q[0] * q[0] + q[1] * q[1]).ln() - 0.1 * s
    }
}

mod lagrangian_damping {
    use geoint_runtime::lagrangian;

    #[lagrangian(damping = 0.1)]
    fn oscillator(q: f64, v: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }
}

mod lagrangian_force_of_what_is_conservative {
    use geoint_runtime::lagrangian;

    #[lagrangian(require(conservative), force = -q)]
    fn pushed(q: f64, v: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }

    #[lagrangian(require(conservative), rayleigh = c * v * v)]
    fn rubbed(q: f64, v: f64, c: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }
}

mod lagrangian_force_with_action {
    use geoint_runtime::lagrangian;

    #[lagrangian(rayleigh = 0.3 * v * v, require(separable))]
    fn rubbed(q: f64, v: f64, s: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q - 0.1 * s
    }
}

mod lagrangian_linear_in_velocities {
    use geoint_runtime::prelude::*;

    #[lagrangian]
    fn odd(q: [f64; 3], v: [f64; 3]) -> f64 {
        q[1] * v[0] - q[2] * v[1] - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    }

    #[lagrangian]
    fn total_derivative(q: [f64; 2], v: [f64; 2]) -> f64 {
        q[1] * v[0] + q[0] * v[1] - (q[0] * q[0] + q[1] * q[1])
    }

    #[lagrangian]
    fn singular(q: [f64; 4], v: [f64; 4]) -> f64 {
        (q[1] + q[3]) * v[0] + (q[1] + q[3]) * v[2] - q[0] * q[0] - q[2] * q[3]
    }

    #[lagrangian]
    fn timed(q: [f64; 2], v: [f64; 2], t: f64) -> f64 {
        (1.0 + t) * q[1] * v[0] - (q[0] * q[0] + q[1] * q[1])
    }

    #[lagrangian(rayleigh = v[0] * v[0], require(separable))]
    fn rubbed(q: [f64; 2], v: [f64; 2]) -> f64 {
        q[1] * v[0] - (q[0] * q[0] + q[1] * q[1])
    }
}

mod lagrangian_momentum_that_jumps {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn dry(q: f64, v: f64, c: f64) -> f64 {
        0.5 * v * v - c * v.abs() - 0.5 * q * q
    }
}

mod lagrangian_of_momenta {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn oscillator(q: f64, p: f64) -> f64 {
        0.5 * p * p - 0.5 * q * q
    }
}

mod lagrangian_rayleigh_cubic {
    use geoint_runtime::lagrangian;

    #[lagrangian(rayleigh = c * v.powi(3) / 3.0)]
    fn oscillator(q: f64, v: f64, c: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }

    #[lagrangian(rayleigh = c * v)]
    fn pulled(q: f64, v: f64, c: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }
}

mod lagrangian_rayleigh_jumps_at_rest {
    use geoint_runtime::lagrangian;

    #[lagrangian(rayleigh = c * v.abs())]
    fn dry(q: f64, v: f64, c: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }

    #[lagrangian(rayleigh = c * (v[0] * v[0] + v[1] * v[1]).sqrt())]
    fn dry_in_the_plane(q: [f64; 2], v: [f64; 2], c: f64) -> f64 {
        0.5 * (v[0] * v[0] + v[1] * v[1]) - 0.5 * (q[0] * q[0] + q[1] * q[1])
    }
}

mod lagrangian_rayleigh_that_feeds {
    use geoint_runtime::lagrangian;

    #[lagrangian(rayleigh = -v * v)]
    fn oscillator(q: f64, v: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q
    }
}

mod lagrangian_linear_in_some_velocities {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn vortex_and_mass(q: [f64; 3], v: [f64; 3]) -> f64 {
        0.5 * v[0] * v[0] + q[1] * v[2] - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    }
}

mod lagrangian_requirements {
    use geoint_runtime::lagrangian;

    #[lagrangian(require(quadratic, constant_mass))]
    fn bead(q: f64, v: f64) -> f64 {
        0.5 * (1.0 + 4.0 * q * q) * v * v - 9.81 * q * q
    }

    #[lagrangian(require(quadratic))]
    fn stiff(q: f64, v: f64) -> f64 {
        0.5 * v * v + 0.25 * v.powi(4) - q * q
    }

    #[lagrangian(require(regular))]
    fn vortex(q: [f64; 2], v: [f64; 2]) -> f64 {
        q[0] * v[1] - q[0] * q[0] - q[1] * q[1]
    }
}

mod lagrangian_separable_required {
    use geoint_runtime::lagrangian;

    #[lagrangian(require(separable))]
    fn bead(q: f64, v: f64) -> f64 {
        0.5 * (1.0 + 4.0 * q * q) * v * v - 9.81 * q * q
    }
}

mod lagrangian_singular_mass_matrix {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn one_mass(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        0.5 * m * (v[0] + v[1] * q[0].cos()).powi(2) - q[1] * q[1]
    }
}

mod lagrangian_types_differ {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn oscillator(q: [f64; 2], v: f64) -> f64 {
        0.5 * v * v - 0.5 * q[0] * q[1]
    }
}

mod lagrangian_velocities_by_another_name {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn oscillator(q: f64, qdot: f64) -> f64 {
        0.5 * qdot * qdot - 0.5 * q * q
    }
}

mod lagrangian_velocity_not_read {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn slider(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        0.5 * m * v[0] * v[0] - (q[0] - q[1]).powi(2)
    }
}

mod lagrangian_without_velocities {
    use geoint_runtime::lagrangian;

    #[lagrangian]
    fn still(q: f64, m: f64) -> f64 {
        -m * q * q
    }
}

fn main() {}
