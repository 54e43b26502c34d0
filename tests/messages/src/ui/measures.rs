mod density_of_an_energy {
    use geoint_runtime::prelude::*;

    #[hamiltonian(measure = (-q * q).exp())]
    fn oscillator(q: f64, p: f64) -> f64 {
        (p * p + q * q) / 2.0
    }
}

mod density_of_a_contact_energy {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(measure = (-q * q).exp())]
    fn damped(q: f64, p: f64, s: f64) -> f64 {
        (p * p + q * q) / 2.0 + s
    }
}

mod density_of_a_lagrangian {
    use geoint_runtime::prelude::*;

    #[lagrangian(measure = 1.0)]
    fn oscillator(q: f64, v: f64) -> f64 {
        (v * v - q * q) / 2.0
    }
}

mod density_that_is_not_kept {
    use geoint_runtime::prelude::*;

    /// The thermostat's own term of the density is missing.
    #[vector_field(measure = (-beta * (x[0] * x[0] + x[1] * x[1]) / 2.0).exp())]
    fn nose_hoover(x: [f64; 3], beta: f64) -> [f64; 3] {
        [x[1], -x[0] - x[2] * x[1], x[1] * x[1] - 1.0 / beta]
    }
}

mod density_of_a_lift_that_is_not_kept {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(lift, measure = 1.0 / q[0])]
    fn lotka_volterra(q: [f64; 2], p: [f64; 2], _s: f64, a: f64, b: f64) -> f64 {
        p[0] * q[0] * (a - q[1]) + p[1] * q[1] * (q[0] - b)
    }
}

mod density_of_a_lift_that_reads_momenta {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(lift, measure = p[0])]
    fn lotka_volterra(q: [f64; 2], p: [f64; 2], _s: f64, a: f64, b: f64) -> f64 {
        p[0] * q[0] * (a - q[1]) + p[1] * q[1] * (q[0] - b)
    }
}

mod density_that_reads_time {
    use geoint_runtime::prelude::*;

    #[vector_field(measure = (2.0 * t).exp())]
    fn sinking(x: [f64; 2], t: f64) -> [f64; 2] {
        [-x[0] + t.sin(), -x[1]]
    }
}

mod density_that_is_zero {
    use geoint_runtime::prelude::*;

    #[vector_field(measure = x[0].sin().powi(2) + x[0].cos().powi(2) - 1.0)]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod density_with_a_source_on_a_surface {
    use geoint_runtime::prelude::*;

    /// Each half keeps the area, but the flow gets faster where x[0] = 0.
    #[vector_field(measure = 1.0)]
    fn faster(x: [f64; 2]) -> [f64; 2] {
        [if x[0] > 0.0 { 2.0 } else { 1.0 }, x[0]]
    }
}

mod density_that_jumps_by_a_turn {
    use geoint_runtime::prelude::*;

    #[vector_field(measure = (k * x[1].atan2(x[0])).exp())]
    fn spiral(x: [f64; 2], k: f64) -> [f64; 2] {
        [-x[1] - k * x[0] / 2.0, x[0] - k * x[1] / 2.0]
    }
}

mod density_given_twice {
    use geoint_runtime::prelude::*;

    #[vector_field(measure = 1.0, measure = 2.0)]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

fn main() {}
