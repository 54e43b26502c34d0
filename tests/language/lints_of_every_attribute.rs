//! Every attribute: a lint that is silent for the function is silent for what is made of it, and all else is quiet.
// What is forbidden cannot be allowed by generated code either.
#![forbid(missing_docs, unreachable_pub, unsafe_code)]
#![deny(
    warnings,
    missing_debug_implementations,
    missing_copy_implementations,
    rust_2018_idioms,
    unused,
    unused_qualifications,
    unused_lifetimes,
    unused_results,
    trivial_casts,
    trivial_numeric_casts,
    single_use_lifetimes,
    let_underscore_drop
)]
mod snake {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(H = A * x[0] * x[0] + x[1] * x[1]))]
    #[allow(non_snake_case)]
    fn field(x: [f64; 2], A: f64) -> [f64; 2] {
        [x[1], -A * x[0]]
    }

    #[vector_field(keeps(E = A * x[0] * x[0] + x[1] * x[1]))]
    #[expect(non_snake_case)]
    fn field2(x: [f64; 2], A: f64) -> [f64; 2] {
        [x[1], -A * x[0]]
    }

    #[lagrangian]
    #[expect(non_snake_case)]
    fn Spring(q: f64, v: f64, M: f64) -> f64 {
        M * v * v / 2.0 - q * q
    }

    #[lagrangian(rayleigh = C * v * v / 2.0)]
    #[expect(non_snake_case)]
    fn Spring2(q: f64, v: f64, M: f64, C: f64) -> f64 {
        M * v * v / 2.0 - q * q
    }

    #[lagrangian(q = Q, v = V, t = T)]
    #[allow(non_snake_case)]
    fn herglotz(Q: [f64; 2], V: [f64; 2], s: f64, T: f64, Gamma: f64) -> f64 {
        V[0] * V[0] + V[1] * V[1] - Q[0] * Q[1] * T - Gamma * s
    }

    #[contact_hamiltonian(q = Q, p = P, s = S, t = T)]
    #[expect(non_snake_case)]
    fn contact(Q: [f64; 2], P: [f64; 2], S: f64, T: f64, Gamma: f64) -> f64 {
        P[0] * P[0] + P[1] * P[1] - Q[0] * Q[1] * T + Gamma * S
    }

    #[hamiltonian(x = M, structure = so3)]
    #[expect(non_snake_case)]
    fn top(M: [f64; 3], I: [f64; 3]) -> f64 {
        M[0] * M[0] / I[0] + M[1] * M[1] / I[1] + M[2] * M[2] / I[2]
    }

    #[hamiltonian(q = Q, p = P, constraint = [Q[0] * Q[0] + Q[1] * Q[1] - L * L])]
    #[expect(non_snake_case)]
    fn rod(Q: [f64; 2], P: [f64; 2], L: f64, G: f64) -> f64 {
        P[0] * P[0] + P[1] * P[1] + G * Q[1]
    }

    #[energy_function]
    #[expect(non_snake_case)]
    fn Bessel(X: f64) -> f64 {
        let Y = X * X;
        Y.cos()
    }

    /// Old.
    #[deprecated(note = "new")]
    #[energy_function]
    fn old_one(x: f64) -> f64 {
        x * x
    }

    #[hamiltonian(with(Bessel, old_one), damping = C)]
    #[allow(non_snake_case, deprecated)]
    fn uses(q: f64, p: f64, C: f64) -> f64 {
        let Z = Bessel(q);
        p * p + Z + old_one(q)
    }

    #[hamiltonian(attitude = R, m = M)]
    #[expect(non_snake_case)]
    fn body(R: UnitQuaternion<f64>, M: Vector3<f64>, I: Vector3<f64>) -> f64 {
        M.x * M.x / I.x + M.y * M.y / I.y + M.z * M.z / I.z + R.k
    }

    #[hamiltonian(coordinates = jacobi)]
    #[expect(non_snake_case)]
    fn planets(q: [[f64; 2]; 2], p: [[f64; 2]; 2], M: [f64; 2], G: f64) -> f64 {
        (p[0][0] * p[0][0] + p[0][1] * p[0][1]) / (2.0 * M[0]) + (p[1][0] * p[1][0] + p[1][1] * p[1][1]) / (2.0 * M[1])
            - G * M[0] * M[1] / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }

    #[lagrangian]
    #[expect(non_snake_case)]
    fn animals(q: [f64; 2], v: [f64; 2], A: f64) -> f64 {
        A * q[1].ln() * v[0] / q[0] - q[0] - q[1] + q[0].ln() + q[1].ln()
    }

    /// Letters of the book in fields and functions.
    pub(super) fn all() {
        let f = Field { A: 2.0 };
        let _e = f.H(&FlowState::new([1.0, 2.0]));
        let f = Field2 { A: 2.0 };
        let _e = f.E(&FlowState::new([1.0, 2.0]));
        let _x = (
            Spring { M: 1.0 },
            Spring2 { M: 1.0, C: 1.0 },
            Herglotz { Gamma: 0.1 },
            Contact { Gamma: 0.1 },
            Rod { L: 1.0, G: 1.0 },
        );
        let _x = (Top { I: [1.0; 3] }, Uses { C: 1.0 }, Planets { M: [1.0; 2], G: 1.0 }, Animals { A: 1.0 });
        let _x = Body { I: Vector3::new(1.0, 2.0, 3.0) };
    }
}

mod forbids {
    #![forbid(deprecated, non_snake_case, non_camel_case_types)]
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    #[energy_function]
    fn well(x: f64) -> f64 {
        x * x
    }

    #[hamiltonian(with(well), damping = c)]
    fn swing(q: f64, p: f64, c: f64) -> f64 {
        p * p + well(q)
    }

    #[hamiltonian(attitude = r)]
    fn body(r: UnitQuaternion<f64>, m: Vector3<f64>, u: UnitQuaternion<f64>) -> f64 {
        m.norm_squared() + r.k * u.k
    }

    pub(super) fn all() {
        let _x = (Swing { c: 0.1 }, Body::<f64> { u: UnitQuaternion::identity() });
    }
}

/// Everything is public, has a doc, and must be used.
pub mod public {
    use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
    use geoint_runtime::prelude::*;

    /// F.
    #[vector_field(keeps(first = x[0] * x[0] + x[1] * x[1]))]
    #[must_use]
    pub fn field(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }

    /// L.
    #[lagrangian(force = [0.1 * t, v[0]], rayleigh = v[0] * v[0])]
    #[must_use]
    pub fn spring(q: [f64; 2], v: [f64; 2], t: f64, m: f64) -> f64 {
        m * v[0] * v[0] / 2.0 + m * v[1] * v[1] - q[0] * q[0] * q[1]
    }

    /// Action.
    #[lagrangian]
    #[must_use]
    pub fn action(q: f64, v: f64, s: f64, m: f64) -> f64 {
        m * v * v / 2.0 - q * q - 0.1 * s
    }

    /// Contact.
    #[contact_hamiltonian]
    #[must_use]
    pub fn contact(q: f64, p: f64, s: f64, m: f64) -> f64 {
        p * p / m + q * q + 0.1 * s
    }

    /// Lift.
    #[contact_hamiltonian(lift)]
    #[must_use]
    pub fn lift(q: f64, p: f64, _s: f64, m: f64) -> f64 {
        p * q * m
    }

    /// Top.
    #[hamiltonian(x = m, structure = so3)]
    #[must_use]
    pub fn top(m: [f64; 3], i: [f64; 3]) -> f64 {
        m[0] * m[0] / i[0] + m[1] * m[1] / i[1] + m[2] * m[2] / i[2]
    }

    /// Rod.
    #[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
    #[must_use]
    pub fn rod(q: [f64; 2], p: [f64; 2], l: f64) -> f64 {
        p[0] * p[0] + p[1] * p[1] + q[1]
    }

    /// Function.
    #[energy_function]
    #[must_use]
    pub fn bessel(x: f64) -> f64 {
        x.cos()
    }

    /// Body.
    #[hamiltonian(attitude = r)]
    #[must_use]
    pub fn body(r: UnitQuaternion<f64>, m: Vector3<f64>, i: Vector3<f64>) -> f64 {
        m.x * m.x / i.x + m.y * m.y / i.y + m.z * m.z / i.z + r.k
    }

    /// Old.
    #[hamiltonian]
    #[must_use]
    #[deprecated(note = "old")]
    pub fn unit(q: f64, p: f64) -> f64 {
        q * q + p * p
    }
    /// Old.
    #[vector_field]
    #[must_use]
    #[deprecated(note = "old")]
    pub fn unit_field(x: f64) -> f64 {
        x
    }
    /// Old.
    #[lagrangian(name = OldL)]
    #[must_use]
    #[deprecated(note = "old")]
    pub fn unit_l(q: [f64; 2], v: [f64; 2], g: [f64; 2]) -> f64 {
        v[0] * v[0] + v[1] * v[1] - g[0] * q[0] * q[1] - g[1]
    }
    /// Old.
    #[hamiltonian(attitude = r, name = OldBody)]
    #[must_use]
    #[deprecated(note = "old")]
    pub fn unit_body(r: UnitQuaternion<f64>, m: Vector3<f64>, i: Vector3<f64>, u: UnitQuaternion<f64>) -> f64 {
        m.x * m.x / i.x + m.y * m.y / i.y + m.z * m.z / i.z + r.k * u.k
    }
}

#[test]
fn compiles() {
    snake::all();
    forbids::all();
}
