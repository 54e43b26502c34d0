mod action_in_hamiltonian {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn swing(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * s
    }
}

mod lagrangian {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn lagrangian(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - m * q[1]
    }

    fn uses() {
        println!("{}", lagrangian([0.5; 2], [1.0; 2], 2.0));
    }
}

mod momenta_missing {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, w: f64) -> f64 {
        w * w + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod one_argument_two_roles {
    use geoint_runtime::prelude::*;

    #[hamiltonian(q = p, p = p)]
    fn energy(p: f64) -> f64 {
        p * p
    }

    fn uses() {
        println!("{}", energy(0.5));
    }
}

mod position_is_called_p {
    use geoint_runtime::prelude::*;

    #[hamiltonian(q = p)]
    fn energy(p: f64, x: f64) -> f64 {
        p * p + x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod positions_missing {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(x: f64, p: f64) -> f64 {
        p * p + x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod role_of_nobody {
    use geoint_runtime::prelude::*;

    #[hamiltonian(q = x)]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod shapes_differ {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; 3], p: [f64; 2]) -> f64 {
        p[0] * p[0] + p[1] * p[1] + q[0] + q[1] + q[2]
    }

    fn uses() {
        println!("{}", energy([0.5; 3], [1.0; 2]));
    }
}

mod time_and_position {
    use geoint_runtime::prelude::*;

    #[hamiltonian(t = q)]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod time_as_array {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, t: [f64; 2]) -> f64 {
        p * p + q * t[0]
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, [0.0; 2]));
    }
}

mod time_as_position {
    use geoint_runtime::prelude::*;

    #[hamiltonian(q = t)]
    fn energy(t: f64, p: f64) -> f64 {
        p * p + t * t
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod vector_field {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn lorenz(q: [f64; 3], sigma: f64, rho: f64, beta: f64) -> [f64; 3] {
        [sigma * (q[1] - q[0]), q[0] * (rho - q[2]) - q[1], q[0] * q[1] - beta * q[2]]
    }

    fn uses() {
        println!("{:?}", lorenz([1.0; 3], 10.0, 28.0, 2.7));
    }
}

mod nothing_is_called_q_or_p {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn pendulum(theta: f64, omega: f64) -> f64 {
        omega * omega / 2.0 - theta.cos()
    }

    fn uses() {
        println!("{}", pendulum(0.5, 1.0));
    }
}

mod nothing_is_called_q_or_v {
    use geoint_runtime::prelude::*;

    #[lagrangian]
    fn pendulum(theta: f64, omega: f64) -> f64 {
        omega * omega / 2.0 + theta.cos()
    }

    fn uses() {
        println!("{}", pendulum(0.5, 1.0));
    }
}

mod velocity_of_x {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(x: f64, v: f64) -> f64 {
        v * v / 2.0 + x * x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod velocity_of_x_with_an_action {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn energy(x: f64, v: f64, s: f64) -> f64 {
        v * v / 2.0 + x * x + 0.1 * s
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 0.0));
    }
}

mod velocity_and_action {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, xdot: f64, s: f64) -> f64 {
        xdot * xdot / 2.0 + q * q + 0.1 * s
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 0.0));
    }
}

fn main() {}

mod position_called_x {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn spring(x: f64, px: f64, k: f64) -> f64 {
        px * px / 2.0 + k * x * x / 2.0
    }
}
