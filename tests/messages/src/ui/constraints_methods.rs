mod constraint_under_fourthorderdiscretegradient {
    use geoint_runtime::prelude::*;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(FourthOrder(DiscreteGradient), 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

mod constraint_under_gauss2 {
    use geoint_runtime::prelude::*;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(Gauss::<2>, 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

mod constraint_under_rk4 {
    use geoint_runtime::prelude::*;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(RK4, 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

mod constraint_under_steps_that_adapt {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.adaptive(Rattle, 1e-6, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

mod constraint_under_stormerverlet {
    use geoint_runtime::prelude::*;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(StormerVerlet, 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

mod constraint_under_suzuki4ofimplicitmidpoint {
    use geoint_runtime::prelude::*;

    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    fn pendulum(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 1.4 + 6.9 * q[1] / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(Suzuki4.of(ImplicitMidpoint), 0.1, State::new([0.6, -0.8], [0.0, 0.0]));
    }
}

mod rattle_without_constraints {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn pendulum(q: f64, p: f64, l: f64) -> f64 {
        p * p / 1.4 - 6.9 * q.cos() / l
    }

    fn uses() {
        let _ = Pendulum { l: 1.0 }.integrator(Rattle, 0.1, State::new(0.6, 0.0));
    }
}

fn main() {}
