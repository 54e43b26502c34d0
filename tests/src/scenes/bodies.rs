//! Rigid bodies in a field of forces, with unit quaternions and momenta in their own frame.

use crate::problems::Over;
use crate::scalars::Scalar;
use crate::scene::{Scene, field, poisson_defect};
use geoint_runtime::hamiltonian;
use nalgebra::{UnitQuaternion, Vector3};

/// A heavy body about a fixed point.
#[hamiltonian(attitude = r)]
pub fn heavy(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
    (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + (r * c).z
}

/// A body in a field whose pull grows along x.
#[hamiltonian(attitude = r)]
pub fn pulled(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
    let along = (r * c).x;
    (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + along * along - 0.4 * along
}

/// {r, mₖ} = r eₖ/2 and {mⱼ, mₗ} = Σ εⱼₖₗ mₖ, where quaternions come as (i, j, k, w).
fn structure(x: &[f64]) -> Vec<Vec<f64>> {
    let [i, j, k, w, a, b, c, _] = *x else { return vec![] };
    let turned = [[w, k, -j, -i], [-k, w, i, -j], [j, -i, w, -k]];
    let mut matrix = vec![vec![0.0; 8]; 8];
    for (l, turned) in turned.iter().enumerate() {
        for (n, turned) in turned.iter().enumerate() {
            matrix[n][4 + l] = turned / 2.0;
            matrix[4 + l][n] = -turned / 2.0;
        }
    }
    for (j, l, m) in [(0, 1, -c), (0, 2, b), (1, 2, -a)] {
        matrix[4 + j][4 + l] = m;
        matrix[4 + l][4 + j] = -m;
    }
    matrix
}

macro_rules! scenes {
    ($($scene:ident $System:ident { inertia: $inertia:expr, c: $c:expr };)*) => { $(
        #[doc = concat!("[`", stringify!($System), "`] from a start.")]
        #[derive(Clone, Copy, Debug)]
        pub struct $scene;

        impl Scene for $scene {
            type Over<R: Scalar> = $System<R>;
            const NAME: &'static str = stringify!($System);

            fn over<R: Scalar>() -> $System<R> {
                $System { inertia: $inertia.over(), c: Vector3::from($c.map(R::from_f64)) }
            }
            fn start() -> (f64, Vec<f64>) {
                (0.4, vec![0.0, 0.6, 0.0, 0.8, 0.5, 1.6, -1.2, 0.0])
            }
            fn rate<R: Scalar>(system: &$System<R>, t: R, x: &[R]) -> Vec<R> {
                field(system, t, x)
            }
            fn directions() -> Vec<Vec<f64>> {
                // The last number of a momentum is none.
                (0..8).map(|i| (0..8).map(|j| f64::from(u8::from(i == j && i < 7))).collect()).collect()
            }
            fn form_defect(_: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
                poisson_defect(images, &structure(before), &structure(after))
            }
        }
    )* };
}

scenes! {
    Heavies Heavy { inertia: [1.3, 2.1, 3.0], c: [0.3, -0.2, 0.7] };
    Pulls Pulled { inertia: [1.1, 2.4, 1.9], c: [0.6, 0.3, -0.4] };
}
