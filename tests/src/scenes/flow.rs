//! Flows x' = S(x) ∇H: species, a free body, and Lorenz's core, of which S has no Poisson bracket.

use crate::problems::Over;
use crate::scalars::Scalar;
use crate::scene::{Scene, field, poisson_defect};
use geoint_runtime::hamiltonian;

/// Predators and prey.
#[hamiltonian(structure = [[0.0, -x[0] * x[1]], [x[0] * x[1], 0.0]])]
pub fn two_species(x: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()
}

/// Volterra's lattice, open.
#[hamiltonian(structure = |i, j| if j == i + 1 { x[i] * x[j] } else { 0.0 })]
pub fn five_species(x: [f64; 5], w: f64) -> f64 {
    w * x.iter().sum::<f64>()
}

/// A free body in angular velocities.
#[hamiltonian(structure = |i, j| {
    let k = 3 - i - j;
    (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
})]
pub fn spinning(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| inertia[i] * x[i] * x[i] / 2.0).sum()
}

macro_rules! scenes {
    ($($scene:ident $System:ident { $($field:ident: $value:expr),* } from $x:expr, |$y:ident| $structure:expr;)*) => { $(
        #[doc = concat!("[`", stringify!($System), "`] from a start.")]
        #[derive(Clone, Copy, Debug)]
        pub struct $scene;

        impl Scene for $scene {
            type Over<R: Scalar> = $System<R>;
            const NAME: &'static str = stringify!($System);

            fn over<R: Scalar>() -> $System<R> {
                $System { $($field: $value.over()),* }
            }
            fn start() -> (f64, Vec<f64>) {
                (0.4, $x.to_vec())
            }
            fn rate<R: Scalar>(system: &$System<R>, t: R, x: &[R]) -> Vec<R> {
                field(system, t, x)
            }
            fn form_defect(_: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
                let structure = |$y: &[f64]| skew($y.len(), $structure);
                poisson_defect(images, &structure(before), &structure(after))
            }
        }
    )* };
}

/// A matrix from its entries above the diagonal.
fn skew(n: usize, above: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    let entry = |i: usize, j: usize| match i.cmp(&j) {
        std::cmp::Ordering::Less => above(i, j),
        std::cmp::Ordering::Equal => 0.0,
        std::cmp::Ordering::Greater => -above(j, i),
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

scenes! {
    TwoSpeciesMeet TwoSpecies { a: 2.0, b: 1.0, c: 1.3 } from [1.0, 0.5], |x| |i, j| -x[i] * x[j];
    FiveSpeciesMeet FiveSpecies { w: 1.2 } from [1.0, 0.5, 0.8, 1.2, 0.6], |x| |i, j| if j == i + 1 { x[i] * x[j] } else { 0.0 };
    Spins Spinning { inertia: [1.3, 2.0, 3.1] } from [0.5, 0.8, -0.4], |x| |i, j| {
        let (k, inertia) = (3 - i - j, [1.3, 2.0, 3.1]);
        (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
    };
}
