mod bodies_coupled {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn tops(r: [UnitQuaternion<f64>; 2], m: [Vector3<f64>; 2], i: f64) -> f64 {
        (m[0].norm_squared() + m[1].norm_squared()) / (2.0 * i) + m[0].dot(&m[1]) + (r[0].inverse() * r[1]).w
    }
}

mod body_as_position {
    use geoint_runtime::nalgebra::UnitQuaternion;
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn top(q: UnitQuaternion<f64>, p: UnitQuaternion<f64>) -> f64 {
        p.w * p.w + q.w * q.w
    }
}

mod body_attitude_of_another_type {
    use geoint_runtime::nalgebra::Vector3;
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: [f64; 4], m: Vector3<f64>) -> f64 {
        m.norm_squared() + r[0]
    }
}

mod body_centres {
    use geoint_runtime::prelude::*;
    use nalgebra::{UnitQuaternion, Vector3};

    /// Momenta are missing.
    #[hamiltonian(attitude = r)]
    fn thrown(r: UnitQuaternion<f64>, m: Vector3<f64>, q: Vector3<f64>) -> f64 {
        m.norm_squared() + q.z + r.w
    }

    /// Two bodies have two centres.
    #[hamiltonian(attitude = r)]
    fn one_centre(r: [UnitQuaternion<f64>; 2], m: [Vector3<f64>; 2], q: Vector3<f64>, p: Vector3<f64>) -> f64 {
        m[0].norm_squared() + m[1].norm_squared() + p.norm_squared() + q.z + r[0].w
    }

    /// Rolling couples both momenta.
    #[hamiltonian(attitude = r)]
    fn rolling(r: UnitQuaternion<f64>, m: Vector3<f64>, q: Vector3<f64>, p: Vector3<f64>, mass: f64) -> f64 {
        m.norm_squared() / 2.0 + p.norm_squared() / (2.0 * mass) + m.x * p.y + q.z + r.w
    }
}

mod body_coupled {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
        m.norm_squared() / (2.0 * i) + (r * m).z
    }
}

mod body_damped {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r, damping = 0.1)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>) -> f64 {
        m.norm_squared() + r.w
    }
}

mod body_inertia_of_time {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, t: f64) -> f64 {
        m.norm_squared() / (2.0 + t.sin()) + r.k
    }
}

mod body_momentum_alone {
    use geoint_runtime::prelude::*;

    #[hamiltonian(m = l)]
    fn top(q: f64, p: f64, l: f64) -> f64 {
        p * p / (2.0 * l) + q * q
    }
}

mod body_momentum_of_another_float {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f32>) -> f64 {
        r.w * r.w + f64::from(m.x)
    }
}

mod body_momentum_of_another_type {
    use geoint_runtime::nalgebra::UnitQuaternion;
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn tops(r: [UnitQuaternion<f64>; 2], m: [f64; 6]) -> f64 {
        m[0] * m[0] + r[0].w + r[1].w
    }
}

mod body_not_quadratic {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
        m.norm_squared() / (2.0 * i) + 0.1 * m.x.powi(4) + r.k
    }
}

mod body_unknown_method {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, m: Vector3<f64>) -> f64 {
        m.norm_squared() + r.angle()
    }
}

mod body_without_momentum {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[hamiltonian(attitude = r)]
    fn top(r: UnitQuaternion<f64>, l: Vector3<f64>) -> f64 {
        l.norm_squared() + r.w
    }
}

fn main() {}
