mod damping_from_body {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = 0.1 * swell)]
    fn energy(q: f64, p: f64) -> f64 {
        let swell = 1.0 + q * q;
        p * p / 2.0 + q * q * swell
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod damping_indefinite {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = [[0.1, 0.2], [0.2, 0.3]])]
    fn energy(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] * q[1]
    }

    fn uses() {
        println!("{}", energy([0.5, 0.1], [1.0, 0.2]));
    }
}

mod damping_integer {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = 1)]
    fn energy(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod damping_negative {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = [0.1, -0.3])]
    fn energy(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] * q[1]
    }

    fn uses() {
        println!("{}", energy([0.5, 0.1], [1.0, 0.2]));
    }
}

mod damping_not_symmetric {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = [[c, c / 2.0], [c / 3.0, c]])]
    fn energy(q: [f64; 2], p: [f64; 2], c: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] * q[1]
    }

    fn uses() {
        println!("{}", energy([0.5, 0.1], [1.0, 0.2], 0.1));
    }
}

mod damping_wrong_length {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = [c, c, 0.0])]
    fn energy(q: [f64; 2], p: [f64; 2], c: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] * q[1]
    }

    fn uses() {
        println!("{}", energy([0.5, 0.1], [1.0, 0.2], 0.1));
    }
}

mod force {
    use geoint_runtime::prelude::*;

    #[hamiltonian(force = [1.0, 2.0, 3.0])]
    fn wrong_length(q: [f64; 2], p: [f64; 2]) -> f64 {
        p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]
    }

    #[hamiltonian(force = -v)]
    fn taken(q: f64, p: f64, v: f64) -> f64 {
        p * p + v * q * q
    }

    #[lagrangian(force = t.cos(), require(conservative))]
    fn required(q: f64, v: f64, t: f64) -> f64 {
        v * v - q * q
    }

    #[hamiltonian(force = -v * v.abs())]
    fn kicked(q: f64, p: f64, m: f64) -> f64 {
        p * p / (2.0 * m) + q.powi(4)
    }

    fn uses() {
        let _ = Kicked { m: 1.0 }.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0)).advance(1);
    }
}

mod verlet_on_damped {
    use geoint_runtime::prelude::*;

    #[hamiltonian(damping = c)]
    fn shock(q: f64, p: f64, c: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0
    }

    fn uses() {
        Shock { c: 0.1 }.integrator(StormerVerlet, 0.01, State::new(0.5, 1.0));
    }
}

fn main() {}
