mod body_rotations_of_a_full_tensor {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
        m.norm_squared() / (2.0 * i) + 0.1 * m.x * m.y + r.w * r.k
    }

    fn uses() {
        let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.1, 0.2, 0.3));
        let _ = Top { i: 1.0 }.integrator(FiveRotations, 0.1, start);
    }
}

mod body_under_discrete_gradient {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
        m.norm_squared() / (2.0 * i) + r.w * r.k
    }

    fn uses() {
        let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.1, 0.2, 0.3));
        let _ = Top { i: 1.0 }.integrator(DiscreteGradient, 0.1, start);
    }
}

mod body_under_projection {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
        m.norm_squared() / (2.0 * i) + r.w * r.k
    }

    fn uses() {
        let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.1, 0.2, 0.3));
        let _ = Top { i: 1.0 }.integrator(Projection(RK4, Energy), 0.1, start);
    }
}

mod rotations_of_no_body {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn pendulum(q: f64, p: f64, m: f64) -> f64 {
        p * p / (2.0 * m) - q.cos()
    }

    fn uses() {
        let _ = Pendulum { m: 1.0 }.integrator(FiveRotations, 0.1, State::new(1.0, 0.0));
    }
}

fn main() {}
