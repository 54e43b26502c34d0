//! Linear flows in many degrees of freedom: exp(A) − 1, and what it adds to a vector.
//!
//! Without the 1 nothing is rounded to the size of the state: short flows are as accurate as long ones.

use crate::scalar::Real;

/// Terms of the series.
const TERMS: u32 = 16;

/// exp(A) − 1 as an array of columns, of a matrix with these entries, each with its place column by column: a series for A/2ˢ, and
/// exp(2A) − 1 = 2D + D² for D = exp(A) − 1.
pub fn flow_matrix<R: Real, const N: usize>(entries: &[(usize, R)]) -> [[R; N]; N] {
    let zero = R::from_f64(0.0);
    let mut columns = [0.0; N];
    for (place, entry) in entries {
        columns[place / N] += entry.magnitude();
    }
    let norm = columns.into_iter().fold(0.0, f64::max);
    // Too large, or no number.
    if norm.is_nan() || norm >= f64::MAX.sqrt() {
        return [[R::from_f64(f64::NAN); N]; N];
    }
    // The next term of the series is lost: z¹⁷/17! < ε z.
    let (mut part, mut doublings) = (1.0, 0);
    let factorial = (1..=TERMS + 1).map(f64::from).product::<f64>();
    while (0..TERMS).fold(1.0, |power, _| power * norm * part) > R::epsilon() * factorial {
        part /= 2.0;
        doublings += 1;
    }
    // D ← (D + 1) A/k, from the last term to the first.
    let mut change = [[zero; N]; N];
    for k in (1..=TERMS).rev() {
        let mut product = [[zero; N]; N];
        let weight = R::from_f64(part) / R::from_f64(f64::from(k));
        for (place, entry) in entries {
            let (column, row, entry) = (place / N, place % N, *entry * weight);
            for i in 0..N {
                product[column][i] = change[row][i].multiply_add(entry, product[column][i]);
            }
            product[column][row] += entry;
        }
        change = product;
    }
    for _ in 0..doublings {
        let mut doubled = change.map(|column| column.map(|x| x + x));
        for (to, column) in doubled.iter_mut().zip(&change) {
            for (weight, from) in column.iter().zip(&change) {
                for i in 0..N {
                    to[i] = from[i].multiply_add(*weight, to[i]);
                }
            }
        }
        change = doubled;
    }
    change
}

/// A matrix, by columns, times a vector. Two sums side by side wait half as long.
#[inline(always)]
pub fn flow_change<R: Real, const N: usize>(matrix: &[R], x: [R; N]) -> [R; N] {
    let (mut even, mut odd) = ([R::from_f64(0.0); N], [R::from_f64(0.0); N]);
    for (columns, x) in matrix.chunks(2 * N).zip(x.chunks(2)) {
        let (first, second) = columns.split_at(N);
        for i in 0..N {
            even[i] = first[i].multiply_add(x[0], even[i]);
        }
        if let [_, x] = x {
            for i in 0..N {
                odd[i] = second[i].multiply_add(*x, odd[i]);
            }
        }
    }
    core::array::from_fn(|i| even[i] + odd[i])
}

/// Numbers and matrices in a row.
pub fn joined<R: Real, const N: usize>(parts: &[&[R]]) -> [R; N] {
    let mut all = [R::from_f64(0.0); N];
    let mut rest = &mut all[..];
    for part in parts {
        let (own, others) = rest.split_at_mut(part.len());
        own.copy_from_slice(part);
        rest = others;
    }
    all
}
