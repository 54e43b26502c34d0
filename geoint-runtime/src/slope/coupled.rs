//! Linear flows in many degrees of freedom: exp(A) − 1, and what it adds to a vector.
//!
//! Without the 1 nothing is rounded to the size of the state: short flows are as accurate as long ones.

use crate::scalar::Real;

/// The longest series, an even number of terms.
const MOST_TERMS: u32 = 16;

/// exp(A) − 1 as an array of columns, of a matrix with these entries, each with its place column by column, in order: a series for A/2ˢ, and
/// exp(2A) − 1 = 2D + D² for D = exp(A) − 1.
pub fn flow_matrix<R: Real, const N: usize>(entries: &[(usize, R)]) -> [[R; N]; N] {
    let zero = R::from_f64(0.0);
    let mut rest = entries;
    let columns: [&[(usize, R)]; N] = core::array::from_fn(|j| {
        let (own, others) = rest.split_at(rest.iter().take_while(|(place, _)| place / N == j).count());
        rest = others;
        own
    });
    // Of A, and of A², which the units of momenta do not enter.
    let sizes = columns.map(|column| column.iter().map(|(_, entry)| entry.magnitude()).sum::<f64>());
    let squares =
        columns.map(|column| column.iter().map(|(place, entry)| entry.magnitude() * sizes[place % N]).sum::<f64>());
    // Too large, or no number.
    if !sizes.iter().chain(&squares).all(|size| *size < f64::MAX.sqrt()) {
        return [[R::from_f64(f64::NAN); N]; N];
    }
    let square = squares.into_iter().fold(0.0, f64::max);
    // Whether the next term of a series of A/2ˢ is lost: of 16 terms, if A·(A²)⁸/17! < ε A.
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
    // Two matrices take turns: what is computed, and what it follows from.
    let [mut even, mut odd] = [[[zero; N]; N]; 2];
    let (mut change, mut before) = (&mut even, &mut odd);
    // 1 + D ← 1 + (1 + D) A/k, from the last term to the first, a column in registers; the last 1 is left out.
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
    // What of an angle is not known becomes twice as much wherever it is doubled. That something turns is seen in the diagonal, which is the
    // same in all units.
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

/// A matrix, by columns, times a vector: as many rows at a time as a processor without wider vectors has registers for.
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

/// Some rows of that. Two sums side by side wait half as long, where there are few.
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
