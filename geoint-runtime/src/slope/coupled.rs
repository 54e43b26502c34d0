//! Linear flows in many degrees of freedom: exp(A) − 1, and its product with a vector.
//!
//! The increment of a state is computed instead of the state, so a short flow has the same relative accuracy as a long one.

use crate::scalar::Real;

/// The number of terms of the longest series. It is even.
const MOST_TERMS: u32 = 16;

/// Returns exp(A) − 1 as an array of columns.
///
/// `entries` holds the entries of A with their places, counted column by column, in ascending order. The method is a Taylor series for A/2ˢ, followed by
/// s doublings exp(2A) − 1 = 2D + D² with D = exp(A) − 1. The result is NaN if A is too large or not finite.
pub fn flow_matrix<R: Real, const N: usize>(entries: &[(usize, R)]) -> [[R; N]; N] {
    let zero = R::from_f64(0.0);
    let mut rest = entries;
    let columns: [&[(usize, R)]; N] = core::array::from_fn(|j| {
        let (own, others) = rest.split_at(rest.iter().take_while(|(place, _)| place / N == j).count());
        rest = others;
        own
    });
    // Column sums of |A| and |A|². The latter do not depend on the units of positions and momenta.
    let sizes = columns.map(|column| column.iter().map(|(_, entry)| entry.magnitude()).sum::<f64>());
    let squares =
        columns.map(|column| column.iter().map(|(place, entry)| entry.magnitude() * sizes[place % N]).sum::<f64>());
    // Too large, or not finite.
    if !sizes.iter().chain(&squares).all(|size| *size < f64::MAX.sqrt()) {
        return [[R::from_f64(f64::NAN); N]; N];
    }
    let square = squares.into_iter().fold(0.0, f64::max);
    // Returns whether the next term of a series of A/2ˢ is below rounding. After 16 terms the condition is A·(A²)⁸/17! ≤ ε A.
    let is_lost = |part: f64, terms: u32| {
        let power = (0..terms / 2).fold(1.0, |power, _| power * square * part * part);
        power <= R::epsilon() * (1..=terms + 1).map(f64::from).product::<f64>()
    };
    let (mut part, mut doublings) = (1.0, 0);
    while !is_lost(part, MOST_TERMS) {
        part /= 2.0;
        doublings += 1;
    }
    let terms = (2..MOST_TERMS).step_by(2).find(|terms| is_lost(part, *terms)).unwrap_or(MOST_TERMS);
    // Two buffers: `change` is computed from `before`, then both are swapped.
    let [mut even, mut odd] = [[[zero; N]; N]; 2];
    let (mut change, mut before) = (&mut even, &mut odd);
    // Horner's rule 1 + D ← 1 + (1 + D) A/k, from the last term to the first, by columns. The last 1 is omitted.
    let one = R::from_f64(1.0);
    (0..N).for_each(|i| change[i][i] = one);
    for k in (1..=terms).rev() {
        core::mem::swap(&mut before, &mut change);
        let weight = R::from_f64(part) / R::from_f64(f64::from(k));
        for (column, own) in change.iter_mut().zip(columns) {
            let mut sum = [zero; N];
            for (place, entry) in own {
                let (row, entry) = (place % N, *entry * weight);
                for i in 0..N {
                    sum[i] = before[row][i].multiply_add(entry, sum[i]);
                }
            }
            *column = sum;
        }
        if k > 1 {
            (0..N).for_each(|i| change[i][i] += one);
        }
    }
    // Each doubling of A doubles the error of an angle. Rotation is detected in the diagonal of D, which does not depend on units. Without any
    // correct digit of an angle, the result is NaN.
    let mut unknown = R::epsilon();
    for _ in 0..doublings {
        core::mem::swap(&mut before, &mut change);
        if (0..N).any(|i| before[i][i].magnitude() > 0.125) {
            unknown *= 2.0;
        }
        for (to, column) in change.iter_mut().zip(before.iter()) {
            let mut sum = column.map(|x| x + x);
            for (weight, from) in column.iter().zip(before.iter()) {
                for i in 0..N {
                    sum[i] = from[i].multiply_add(*weight, sum[i]);
                }
            }
            *to = sum;
        }
    }
    if unknown < 1.0 { *change } else { [[R::from_f64(f64::NAN); N]; N] }
}

/// Returns the product of a matrix, stored by columns, and a vector. Blocks of up to 16 rows fit into the registers of the processor.
#[inline(always)]
pub fn flow_change<R: Real, const N: usize>(matrix: &[R], x: [R; N]) -> [R; N] {
    let (mut all, mut first) = ([R::from_f64(0.0); N], 0);
    macro_rules! rows {
        ($($count:literal)*) => { $(
            while N - first >= $count {
                all[first..first + $count].copy_from_slice(&rows::<R, N, $count>(matrix, &x, first));
                first += $count;
            }
        )* };
    }
    rows!(16 8 4 2 1);
    all
}

/// Returns `ROWS` rows of the product. Small blocks use two partial sums, which shortens the chain of dependent operations.
#[inline(always)]
fn rows<R: Real, const N: usize, const ROWS: usize>(matrix: &[R], x: &[R; N], first: usize) -> [R; ROWS] {
    let mut sums = [[R::from_f64(0.0); ROWS]; 2];
    for (j, (column, x)) in matrix.chunks_exact(N).zip(x).enumerate() {
        let sum = &mut sums[if ROWS < 16 { j % 2 } else { 0 }];
        for (sum, entry) in sum.iter_mut().zip(&column[first..first + ROWS]) {
            *sum = entry.multiply_add(*x, *sum);
        }
    }
    core::array::from_fn(|i| if ROWS < 16 { sums[0][i] + sums[1][i] } else { sums[0][i] })
}

/// Concatenates numbers and matrices to one array.
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
