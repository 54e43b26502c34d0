//! Compares elimination in pairs with elimination with exchanges. The tests have a file of their own, because the benchmark `linear` compiles `linear.rs` once
//! more.

use super::linear::{of_pairs, pivots, solve};
use super::size::Sizes;
use crate::space::{Array, Square};

/// Returns the identity plus pseudorandom entries between −0.3 and 0.3.
fn near_one<const N: usize>(seed: f64) -> [[f64; N]; N] {
    let random = |i: usize, j: usize| 0.3 * libm::sin(seed + 7.3 * i as f64 + 3.1 * (j * j) as f64);
    core::array::from_fn(|i| core::array::from_fn(|j| random(i, j) + if i == j { 1.0 } else { 0.0 }))
}

/// Returns the sign of the determinant (true if positive) and the solution of [`of_pairs`].
fn in_pairs<const N: usize>(mut matrix: [[f64; N]; N], mut b: [f64; N]) -> Option<(bool, [f64; N])>
where
    [f64; N]: Array<Real = f64>,
{
    of_pairs(&mut matrix, &mut b).map(|positive| (positive, b))
}

/// Asserts that both eliminations find the known solution of 50 systems, and the same sign of the determinant.
fn agree<const N: usize>()
where
    [f64; N]: Array<Real = f64>,
{
    for seed in 0..50 {
        let mut matrix = near_one::<N>(f64::from(seed));
        // Both signs of the determinant.
        if seed % 3 == 0 {
            matrix[N - 2].iter_mut().for_each(|entry| *entry *= -1.0);
        }
        let x: [f64; N] = core::array::from_fn(|i| libm::cos(i as f64));
        let b = matrix.map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum());
        let mut square: Square<[f64; N]> = <[f64; N]>::fill(<[f64; N]>::zero());
        <[f64; N]>::entries::<[f64; N]>(&mut square).copy_from_slice(&matrix);
        let expected = pivots::<[f64; N]>(&mut square, &mut b.clone(), &Sizes::equal());
        let (positive, found) = in_pairs(matrix, b).expect("pivots are large");
        assert_eq!(Some(positive), expected);
        assert!(found.iter().zip(&x).all(|(found, x)| (found - x).abs() < 1e-13), "{found:?}");
    }
}

#[test]
fn pairs_are_elimination() {
    agree::<4>();
    agree::<5>();
    agree::<6>();
    agree::<7>();
}

#[test]
fn pairs_that_cancel_are_left_to_exchanges() {
    let one: [[f64; 4]; 4] = core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from(i == j))));
    let (mut cancels, mut small, mut unknown) = (one, one, one);
    (cancels[0][1], cancels[1][0]) = (1.0, 1.0 - 1e-9);
    (small[2][2], small[3][3]) = (1e-3, 1e-3);
    unknown[3][2] = f64::NAN;
    for matrix in [cancels, small, unknown] {
        assert_eq!(in_pairs(matrix, [1.0; 4]), None, "{matrix:?}");
    }
    // A diagonal of zeros does not cancel: the determinants of the pairs are 1 and 4.
    let turned = [[0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, -2.0], [0.0, 0.0, 2.0, 0.0]];
    assert_eq!(in_pairs(turned, [1.0, 2.0, 4.0, 6.0]), Some((true, [-2.0, 1.0, 3.0, -2.0])));
}

#[test]
fn four_unknowns_are_solved_for_where_pairs_cancel() {
    let mut cancels: [[f64; 4]; 4] = near_one(1.0);
    // In `first`, the first pair cancels. In `cancels`, the second pair is small after the first one has been eliminated.
    let first = [[1.0, 1.0, 0.0, 0.5], [1.0, 1.0, 0.25, 0.0], [0.0, 0.5, 1.0, 0.0], [0.25, 0.0, 0.0, 1.0]];
    (cancels[2], cancels[3]) = ([0.0, 0.0, 0.0, 1e-3], [0.0, 0.0, 1e-3, 0.0]);
    let x = [1.0, -2.0, 3.0, 0.5];
    for matrix in [first, cancels] {
        let b = matrix.map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum());
        assert_eq!(in_pairs(matrix, b), None);
        let mut square: Square<[f64; 4]> = <[f64; 4]>::fill(<[f64; 4]>::zero());
        <[f64; 4]>::entries::<[f64; 4]>(&mut square).copy_from_slice(&matrix);
        let mut found = b;
        assert!(solve::<[f64; 4]>(&mut square, &mut found, &Sizes::equal()).is_some());
        assert!(found.iter().zip(&x).all(|(found, x)| (found - x).abs() < 1e-12), "{found:?}");
    }
}
