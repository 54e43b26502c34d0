//! One system of every form, in both scalars.

/// A parameter of another scalar.
pub(super) trait Over<T> {
    fn over(self) -> T;
}

impl Over<f64> for f64 {
    fn over(self) -> f64 {
        self
    }
}

impl Over<f32> for f64 {
    fn over(self) -> f32 {
        self as f32
    }
}

impl<T, const N: usize> Over<[T; N]> for [f64; N]
where
    f64: Over<T>,
{
    fn over(self) -> [T; N] {
        self.map(Over::over)
    }
}

macro_rules! systems {
    ($module:ident, $real:ident) => {
        pub(super) mod $module {
            use geoint_runtime::prelude::*;
            use nalgebra::{UnitQuaternion, Vector3};

            #[contact_hamiltonian]
            pub(crate) fn damped(q: [$real; 2], p: [$real; 2], s: $real, m: $real, k: $real, gamma: $real) -> $real {
                (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / q[0].hypot(q[1]) + gamma * s
            }

            /// A pendulum whose length is a constraint.
            #[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
            pub(crate) fn bound(q: [$real; 3], p: [$real; 3], m: $real, l: $real, g: $real) -> $real {
                (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2]
            }

            #[hamiltonian(coordinates = jacobi)]
            pub(crate) fn planets(q: [[$real; 2]; 3], p: [[$real; 2]; 3], m: [$real; 3], g: $real) -> $real {
                let mut energy = 0.0;
                for i in 0..3 {
                    energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
                    for j in 0..i {
                        energy -= g * m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
                    }
                }
                energy
            }

            /// A charge in a field, and bound.
            #[hamiltonian]
            pub(crate) fn charge(q: [$real; 2], p: [$real; 2], m: $real, b: $real, k: $real) -> $real {
                let u = [p[0] + 0.5 * b * q[1], p[1] - 0.5 * b * q[0]];
                (u[0] * u[0] + u[1] * u[1]) / (2.0 * m) + k * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
            }

            #[hamiltonian(structure = so3)]
            pub(crate) fn top(x: [$real; 3], inertia: [$real; 3]) -> $real {
                (x[0] * x[0] / inertia[0] + x[1] * x[1] / inertia[1] + x[2] * x[2] / inertia[2]) / 2.0
            }

            #[vector_field(keeps(wealth = d * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
            pub(crate) fn predators(x: [$real; 2], a: $real, b: $real, c: $real, d: $real) -> [$real; 2] {
                [x[0] * (a - b * x[1]), x[1] * (d * x[0] - c)]
            }

            /// Two masses on rods.
            #[lagrangian]
            pub(crate) fn rods(q: [$real; 2], v: [$real; 2], m: $real, l: $real, g: $real) -> $real {
                let coupling = v[0] * v[1] * (q[0] - q[1]).cos();
                m * l * l * (v[0] * v[0] + 0.5 * v[1] * v[1] + coupling) + m * g * l * (2.0 * q[0].cos() + q[1].cos())
            }

            /// Linear in velocities.
            #[lagrangian]
            pub(crate) fn vortices(q: [$real; 2], v: [$real; 2], k: $real, w: $real, l: $real) -> $real {
                k * q[0] * v[1] - w * (1.0 + (q[0] * q[0] + 3.0 * q[1] * q[1]) / (l * l)).ln()
            }

            #[hamiltonian(attitude = r)]
            pub(crate) fn heavy_body(
                r: UnitQuaternion<$real>,
                m: Vector3<$real>,
                inertia: [$real; 3],
                weight: $real,
            ) -> $real {
                let spin = m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2];
                spin / 2.0 + weight * (r * Vector3::new(0.3, -0.2, 0.7)).z
            }
        }
    };
}

systems!(double, f64);
systems!(single, f32);
