mod lagrangian_action_kicks {
    use geoint_runtime::prelude::*;

    #[lagrangian]
    fn arm(q: [f64; 3], v: [f64; 3], s: f64, m: f64) -> f64 {
        let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
        m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) - 0.1 * s
    }

    fn uses() {
        let system = Arm { m: 0.7 };
        let start = system.at([0.3, -0.2, 0.5], [0.0; 3], 0.0);
        let _ = system.integrator(StormerVerlet, 0.1, start).advance(9);
        let _ = system.integrator(ContactSplitting, 0.1, start).advance(9);
    }
}

mod lagrangian_action_without_conjugate {
    use geoint_runtime::{methods::*, prelude::*};

    #[lagrangian]
    fn stiff(q: f64, v: f64, s: f64, c: f64) -> f64 {
        0.5 * v * v + 0.25 * v.powi(4) - 0.5 * q * q - c * s
    }

    fn uses() {
        let system = Stiff { c: 0.1 };
        let _ = system.integrator(ContactGauss::<2>, 0.1, system.at(0.1, 0.2, 0.0)).advance(9);
        let _ = system.integrator(ContactDiscreteGradient, 0.1, system.at(0.1, 0.2, 0.0)).advance(9);
    }
}

mod lagrangian_force_with_action {
    use geoint_runtime::{methods::*, prelude::*};

    #[lagrangian(force = 0.3 * t.sin())]
    fn driven(q: f64, v: f64, s: f64, t: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q - 0.1 * s
    }

    fn uses() {
        let _ = Driven.integrator(ContactSplitting, 0.1, Driven.at(1.0, 0.0, 0.0)).advance(9);
        let _ = Driven.integrator(ContactGauss::<2>, 0.1, Driven.at(1.0, 0.0, 0.0)).advance(9);
        let _ = Driven.integrator(StormerVerlet, 0.1, Driven.at(1.0, 0.0, 0.0)).advance(9);
    }
}

mod lagrangian_energy_methods_of_velocities {
    use geoint_runtime::prelude::*;

    #[lagrangian]
    fn stiff(q: f64, v: f64) -> f64 {
        0.5 * v * v + 0.25 * v.powi(4) - 0.5 * q * q
    }

    fn uses() -> Result<(), StepError> {
        let mut sim = Stiff.integrator(DiscreteGradient, 0.1, Stiff.at(0.1, 0.2));
        sim.advance(10)
    }
}

mod lagrangian_kicks_of_a_full_mass_matrix {
    use geoint_runtime::prelude::*;

    #[lagrangian]
    fn chain(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
        m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) + q[0].cos()
    }

    fn uses() -> Result<(), StepError> {
        let system = Chain { m: 0.7 };
        let mut sim = system.integrator(StormerVerlet, 0.1, system.at([0.1, 0.2, 0.3], [0.0; 3]));
        sim.advance(10)
    }
}

fn main() {}
