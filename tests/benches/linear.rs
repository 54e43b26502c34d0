//! Our own elimination beside nalgebra's LU: what a Newton iteration pays for its linear system.
//!
//! `cargo bench -p geoint-benches --bench linear` prints the table of ratios. The systems are random, near the identity as
//! 1 − h·J is, and not near it, so that pivots move.

mod paired;
#[allow(dead_code, reason = "elimination has three of these switches")]
#[path = "../../geoint-runtime/src/ablation.rs"]
mod ablation;
// The elimination is private to the runtime; its files are compiled here once more, with the modules that they name.
#[allow(dead_code, unreachable_pub, reason = "sizes have more uses than elimination, in public interfaces too")]
#[path = "../../geoint-runtime/src/solving"]
mod solving {
    pub(crate) mod linear;
    pub(crate) mod size;
}

use geoint_runtime::private::slope;
use geoint_runtime::space::{Array, Square};
use geoint_runtime::{scalar, space};
use nalgebra::{Const, DimMin, SMatrix, SVector};
use paired::{Pair, Ratio, Run};
use solving::{linear, size::Sizes};
use std::hint::black_box;

/// Different systems in turn, so that the processor cannot learn the pivots by heart.
const SYSTEMS: usize = 64;

fn main() {
    if std::env::args().any(|arg| arg == "--test" || arg == "--list") {
        return;
    }
    println!("\n{:<40} ratio  quartiles       ns/solve", "elimination / nalgebra's LU");
    for (kind, spread) in [("1 + small", 0.05), ("any", 10.0)] {
        row(&pair::<2>(kind, spread));
        row(&pair::<4>(kind, spread));
        row(&pair::<12>(kind, spread));
    }
}

fn row(pair: &Pair) {
    let difference = pair.difference(1000);
    assert!(difference < 1e-9, "{}: results differ by {difference:.1e}", pair.name);
    let Ratio { median, quartiles: [low, high], nanoseconds: [ours, theirs] } = pair.ratio();
    println!("{:<40} {median:.3}  {low:.3} … {high:.3}  {ours:.1} / {theirs:.1}", pair.name);
}

fn pair<const N: usize>(kind: &str, spread: f64) -> Pair
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
    [f64; N]: Array<Real = f64, Map<[f64; N]> = [[f64; N]; N]>,
{
    let systems = systems::<N>(spread);
    let ours: Run = Box::new({
        let systems = systems.clone();
        move |n| {
            let mut sum = [0.0; N];
            for i in 0..n {
                let (matrix, rhs) = &systems[i as usize % SYSTEMS];
                let (mut matrix, mut x): (Square<[f64; N]>, _) = black_box((*matrix, *rhs));
                assert!(linear::solve::<[f64; N]>(&mut matrix, &mut x, &Sizes::equal()).is_some());
                sum = std::array::from_fn(|k| sum[k] + x[k]);
            }
            sum.to_vec()
        }
    });
    let theirs: Run = Box::new(move |n| {
        let mut sum = SVector::<f64, N>::zeros();
        for i in 0..n {
            let (matrix, rhs) = &systems[i as usize % SYSTEMS];
            let (matrix, rhs) = black_box((*matrix, *rhs));
            // nalgebra stores columns.
            let matrix = SMatrix::<f64, N, N>::from_fn(|i, j| matrix[i][j]);
            sum += matrix.lu().solve(&SVector::from(rhs)).expect("a regular matrix");
        }
        sum.as_slice().to_vec()
    });
    Pair { name: format!("{N} × {N}, {kind}"), subject: ours, unit: theirs }
}

/// The identity and random numbers between −spread and spread.
fn systems<const N: usize>(spread: f64) -> Vec<([[f64; N]; N], [f64; N])> {
    let mut seed = 1_u64;
    let mut random = move || {
        // Knuth's linear congruential generator; its high bits are good enough.
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut system = || {
        let matrix =
            std::array::from_fn(|i| std::array::from_fn(|j| spread * random() + if i == j { 1.0 } else { 0.0 }));
        (matrix, std::array::from_fn(|_| random()))
    };
    (0..SYSTEMS).map(|_| system()).collect()
}
