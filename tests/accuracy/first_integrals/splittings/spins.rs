//! Spins that are coupled by scalar products: each pair turns about its sum, exactly.

use geoint_runtime::Real;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::Pieces;
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::{Double, Dual, Scalar};

#[hamiltonian(structure = |i, j| if i / 3 != j / 3 { 0.0 } else if j == i + 2 { -x[i + 1] } else if i % 3 == 0 { x[i + 2] } else { x[i - 1] })]
fn exchange(x: [f64; 6], j: f64) -> f64 {
    j * (x[0] * x[3] + x[1] * x[4] + x[2] * x[5])
}

/// Four in a row, written term by term, in a field.
#[hamiltonian(structure = |i, j| if i / 3 != j / 3 { 0.0 } else if j == i + 2 { -x[i + 1] } else if i % 3 == 0 { x[i + 2] } else { x[i - 1] })]
fn row(x: [f64; 12], j: f64, b: f64) -> f64 {
    let mut energy = b * (x[2] + x[5] + x[8] + x[11]);
    for i in 0..9 {
        energy += j * x[i] * x[i + 3];
    }
    energy
}

const START: [f64; 6] = [0.5, 0.3, -0.2, 0.1, 0.9, 0.4];

fn step<R: Scalar>(x: [R; 6], h: R) -> [R; 6] {
    let mut sim = Integrator::new(Exchange { j: R::from_f64(0.7) }, PoissonSplitting, h, FlowState::new(x));
    sim.step().expect("a step");
    sim.state().x
}

/// x' = Σ J Sᵢ × Sⱼ with the sign of the bracket: {x, y} = z.
fn field<R: Scalar>(x: &[R]) -> Vec<R> {
    let j = R::from_f64(0.7);
    let cross = |a: &[R], b: &[R]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let (a, b) = x.split_at(3);
    cross(b, a).into_iter().chain(cross(a, b)).map(|rate| j * rate).collect()
}

#[test]
fn a_pair_is_one_piece() {
    assert_eq!(<Exchange<f64> as Pieces<PoissonSplitting>>::PIECES.len(), 1);
    // Three pieces: the field, two bonds that do not meet, and the bond between them.
    assert_eq!(<Row<f64> as Pieces<PoissonSplitting>>::PIECES.len(), 3);
}

#[test]
fn its_flow_is_the_solution() {
    for (start, h) in [
        (START, 0.3),
        (START, -0.3),
        (START, 4.0),
        (START.map(|x| 1e-7 * x), 0.3),
        ([0.3, -0.2, 0.7, -0.3, 0.2, -0.7], 0.9),
    ] {
        let found = step(start, h);
        let real = Double::from;
        let exact = extrapolated(|_, x: &[Double]| field(x), real(0.0), start.map(real).to_vec(), real(h), 8);
        let size = start.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (x, exact) in found.iter().zip(&exact) {
            let error = (real(*x) - *exact).magnitude() / size;
            assert!(error < 4.0 * f64::EPSILON * (1.0 + h.abs()), "{start:?}, h = {h}: {error:e}");
        }
        let rate = step(start.map(Dual::from), Dual::variable(h));
        for (x, rate) in rate.iter().zip(field(&found)) {
            assert!((x.derivative() - rate).abs() < 1e-15 * (1.0 + h.abs()), "h = {h}");
        }
        // M S(x) Mᵀ is S at the end.
        let columns: Vec<Vec<f64>> = (0..6)
            .map(|j| {
                let mut x = start.map(Dual::from);
                x[j] = Dual::variable(start[j]);
                step(x, Dual::from(h)).iter().map(|x| x.derivative()).collect()
            })
            .collect();
        let bracket = |x: &[f64; 6], i: usize, j: usize| match (i / 3 == j / 3, (3 + j - i % 3) % 3) {
            (true, 1) => x[i / 3 * 3 + (i + 2) % 3],
            (true, 2) => -x[i / 3 * 3 + (i + 1) % 3],
            _ => 0.0,
        };
        for a in 0..6 {
            for b in 0..6 {
                let mut moved = 0.0;
                for i in 0..6 {
                    for j in 0..6 {
                        moved += columns[i][a] * bracket(&start, i, j) * columns[j][b];
                    }
                }
                let gap = moved - bracket(&found, a, b);
                assert!(gap.abs() < 1e-13, "h = {h}, {a}, {b}: {gap:e}");
            }
        }
    }
}

/// A field turns spins by the same angle at every step: cos²θ + sin²θ, rounded, would be another number than 1 each time, by some 1e-17.
#[test]
fn lengths_of_spins_have_no_trend() {
    let start: [f64; 12] = [0.5, 0.3, -0.2, 0.1, 0.9, 0.4, -0.3, 0.2, 0.8, -0.5, 0.5, 0.5];
    let mut sim = Row { j: 0.7, b: 0.5 }.integrator(PoissonSplitting, 0.05, FlowState::new(start));
    sim.advance(30_000).expect("steps");
    let square = |x: &[f64; 12], k: usize| x[3 * k..3 * k + 3].iter().map(|x| x * x).sum::<f64>();
    for k in 0..4 {
        let change = square(&sim.state().x, k) / square(&start, k) - 1.0;
        assert!(change.abs() < 3e-13, "{k}: {change:e}");
    }
}

/// A bond keeps the sum of its two spins. Without a field, steps therefore keep the sum of all spins.
#[test]
fn a_row_keeps_its_sum() {
    let start: [f64; 12] = [0.5, 0.3, -0.2, 0.1, 0.9, 0.4, -0.3, 0.2, 0.8, -0.5, 0.5, 0.5];
    let system = Row { j: 0.7, b: 0.0 };
    let mut sim = system.integrator(Suzuki4.of(PoissonSplitting), 0.1, FlowState::new(start));
    sim.advance(300).expect("steps");
    let x = sim.state().x;
    for d in 0..3 {
        let sum = |x: &[f64; 12]| (0..4).map(|k| x[3 * k + d]).sum::<f64>();
        assert!((sum(&x) - sum(&start)).abs() < 1e-13);
    }
    let energy = |x: &[f64; 12]| system.hamiltonian(0.0, x, &());
    assert!((energy(&x) - energy(&start)).abs() < 1e-5 && x != start);
}
