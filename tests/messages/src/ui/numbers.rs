mod division_by_zero {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p / (2.0 * (1.0 - 1.0)) + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod exponent_from_data {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q.powi(q as i32)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod infinite_literal {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q * 1e400
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod integer_times_number {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p / 2 + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod mixed_floats {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, g: f32) -> f64 {
        p * p + q + f64::from(g)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 2.0));
    }
}

mod mixed_floats_cast {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + f64::from(q as f32)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod power_by_a_caret {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p^2 / 2.0 + q
    }

    #[hamiltonian]
    fn quartic(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q^4.0
    }
}

mod power_by_two_stars {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p ** 2 / 2.0 + q
    }
}

mod angle_of_two_zeros {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn spiral(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + k * (q[0] * q[1]).atan2(q[0])
    }
}

fn main() {}

mod half_as_integers {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + 1 / 2 * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod name_with_a_slip {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, mass: f64, omega: f64) -> f64 {
        p * p / (2.0 * mas) + omgea * q + Omega * q
    }
}
