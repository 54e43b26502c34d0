mod require_quadratic_kinetic {
    use geoint_runtime::prelude::*;

    #[hamiltonian(require(separable, quadratic_kinetic))]
    fn energy(q: f64, p: f64, m: f64, k: f64) -> f64 {
        let kinetic = (m * m + p * p).sqrt();
        kinetic + k * q * q / 2.0
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 1.0, 1.0));
    }
}

mod require_quadratic_of_coupled {
    use geoint_runtime::prelude::*;

    #[hamiltonian(require(quadratic_kinetic))]
    fn energy(q: f64, p: f64) -> f64 {
        p * p / (2.0 * q * q) + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod require_separable {
    use geoint_runtime::prelude::*;

    #[hamiltonian(require(separable))]
    fn energy(q: f64, p: f64, m: f64, k: f64, b: f64) -> f64 {
        p * p / (2.0 * m) + k * q * q / 2.0 + b * q * p
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 1.0, 1.0, 1.0));
    }
}

mod require_separable_damped {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = c, require(separable))]
    fn energy(q: f64, p: f64, c: f64) -> f64 {
        p * p / 2.0 + q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 0.1));
    }
}

mod unknown_requirement {
    use geoint_runtime::prelude::*;

    #[hamiltonian(require(symplectic))]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

fn main() {}
