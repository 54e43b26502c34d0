//! Fields with first integrals, which methods keep without knowing a structure.

use crate::scalars::Scalar;
use crate::scene::{Scene, field};
use geoint_runtime::space::Array;
use geoint_runtime::system::FirstIntegrals;
use geoint_runtime::{PhaseSpace, vector_field};

/// A free body in angular velocities.
#[vector_field(keeps(
    energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
    momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
))]
pub fn turning(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// Volterra's lattice, open, with three integrals.
#[vector_field(keeps(sum = x.iter().sum::<f64>(), odd = x[0].ln() + x[2].ln() + x[4].ln(), third = {
    let squares: f64 = x.iter().map(|x| x * x).sum();
    squares / 2.0 + (0..4).map(|i| x[i] * x[i + 1]).sum::<f64>()
}))]
pub fn lattice(x: [f64; 5], w: f64) -> [f64; 5] {
    [w * x[0] * x[1], w * x[1] * (x[2] - x[0]), w * x[2] * (x[3] - x[1]), w * x[3] * (x[4] - x[2]), -w * x[4] * x[3]]
}

macro_rules! scenes {
    ($($scene:ident $System:ident { $($field:ident: $value:expr),* } from $x:expr;)*) => { $(
        #[doc = concat!("[`", stringify!($System), "`] from a start.")]
        #[derive(Clone, Copy, Debug)]
        pub struct $scene;

        impl Scene for $scene {
            type Over<R: Scalar> = $System<R>;
            const NAME: &'static str = stringify!($System);

            fn over<R: Scalar>() -> $System<R> {
                $System { $($field: R::from_f64($value)),* }
            }
            fn start() -> (f64, Vec<f64>) {
                (0.4, $x.to_vec())
            }
            fn rate<R: Scalar>(system: &$System<R>, t: R, x: &[R]) -> Vec<R> {
                field(system, t, x)
            }
            /// These scenes have no form.
            fn form_defect(_: &[Vec<f64>], _: &[Vec<f64>], _: &[f64], _: &[f64]) -> f64 {
                f64::NAN
            }
            fn kept(x: &[f64]) -> Option<Vec<f64>> {
                let (mut z, mut values) = (<$System as PhaseSpace>::Phase::zero(), vec![]);
                z.as_mut_slice().copy_from_slice(x);
                values.extend_from_slice(Self::over::<f64>().integrals(0.4, &z).as_slice());
                Some(values)
            }
        }
    )* };
}

scenes! {
    Turns Turning { a: 1.3, b: 2.0, c: 3.1 } from [0.5, 0.8, -0.4];
    Chains Lattice { w: 1.2 } from [1.0, 0.5, 0.8, 1.2, 0.6];
}
