//! Small linear systems, of a size known to the compiler.

use crate::ablation;
use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::{Array, Square};

/// A pivot on the diagonal that is smaller than this is compared with the entries below it.
const SMALL: f64 = 1.0 / 8.0;

/// Solves `matrix·x = rhs` in place of `rhs`; destroys `matrix`.
///
/// Row i has the unit of unknown i: the matrix is 1 − g' for x = g(x). Up to four unknowns are solved for in the least time where determinants do not
/// cancel, else, as are more, by [`pivots`]. Returns whether the determinant is positive; `None` if a pivot vanishes or is not a finite number.
#[inline(always)]
pub(crate) fn solve<A: Array>(matrix: &mut Square<A>, rhs: &mut A, sizes: &Sizes<A>) -> Option<bool> {
    if const { ablation::CRAMER_TWO && A::LEN == 2 } {
        return of_two(A::entries::<A>(matrix), rhs.as_mut_slice());
    }
    if const { ablation::CRAMER_THREE && A::LEN == 3 }
        && let Some(positive) = of_three(A::entries::<A>(matrix), rhs.as_mut_slice())
    {
        return Some(positive);
    }
    if const { ablation::PAIRS && A::LEN == 4 } {
        let (mut rows, mut x) = (*matrix, *rhs);
        let positive = of_pairs(A::entries::<A>(&mut rows), x.as_mut_slice());
        let (x, positive) = if positive.is_some() { (x, positive) } else { pivots_apart(*matrix, *rhs, sizes) };
        *rhs = x;
        return positive;
    }
    pivots(matrix, rhs, sizes)
}

/// Out of line, with copies: where both ways write to one place in memory, what is solved for is read from there in other pieces than it was
/// written in, for which a processor waits.
#[cold]
#[inline(never)]
fn pivots_apart<A: Array>(mut matrix: Square<A>, mut rhs: A, sizes: &Sizes<A>) -> (A, Option<bool>) {
    let positive = pivots(&mut matrix, &mut rhs, sizes);
    (rhs, positive)
}

/// The same by elimination with partial pivoting.
///
/// Where entries of a column are compared, then in units of `sizes`, those of the unknowns: which of them is the pivot does not depend on units.
#[inline(always)]
pub(super) fn pivots<A: Array>(matrix: &mut Square<A>, rhs: &mut A, sizes: &Sizes<A>) -> Option<bool> {
    let n = A::LEN;
    let mut sizes = *sizes;
    let sizes = sizes.entries();
    let rows = A::entries::<A>(matrix);
    let b = rhs.as_mut_slice();
    let (mut positive, mut ordered) = (true, true);
    for k in 0..n {
        // On the diagonal an entry has no unit, and is near 1 in the matrix of a step that is not too long: it stays.
        if !ordered || rows[k].as_slice()[k].magnitude() < SMALL {
            // The largest entry comes up by exchanges of neighbours in the search: all indices are known to the compiler, so
            // that a small matrix stays in registers.
            for i in k + 1..n {
                let [below, pivot] = [i, k].map(|i| rows[i].as_slice()[k].magnitude());
                // An entry that has no size yet is no reason to keep a pivot of zero.
                if below * sizes[k].magnitude() > pivot * sizes[i].magnitude() || pivot == 0.0 && below > 0.0 {
                    rows.swap(k, i);
                    b.swap(k, i);
                    sizes.swap(k, i);
                    (positive, ordered) = (!positive, false);
                }
            }
        }
        let (upper, lower) = rows.split_at_mut(k + 1);
        let top = upper[k].as_mut_slice();
        let pivot = top[k].magnitude();
        if pivot == 0.0 || !is_finite(pivot) {
            return None;
        }
        positive ^= top[k].any_below(0.0);
        // One division a row.
        let reciprocal = A::Real::from_f64(1.0) / top[k];
        top[k] = reciprocal;
        for (i, row) in lower.iter_mut().enumerate() {
            let row = row.as_mut_slice();
            let factor = -(row[k] * reciprocal);
            for j in k + 1..n {
                row[j] = factor.multiply_add(top[j], row[j]);
            }
            b[k + 1 + i] = factor.multiply_add(b[k], b[k + 1 + i]);
        }
    }
    for k in (0..n).rev() {
        let row = rows[k].as_slice();
        let mut x = b[k];
        for j in k + 1..n {
            x = (-row[j]).multiply_add(b[j], x);
        }
        b[k] = x * row[k];
    }
    Some(positive)
}

/// The same in the least time, where the determinant is positive and its terms do not cancel: returns whether that is so. Elimination with
/// exchanges would be inlined as well. One unknown may be no number, where its pivot vanishes.
#[inline(always)]
pub(crate) fn solve_fast<A: Array>(matrix: &mut Square<A>, rhs: &mut A) -> bool {
    if const { !has_rule(A::LEN) } {
        return pivots(matrix, rhs, &Sizes::equal()) == Some(true);
    }
    let (rows, b) = (A::entries::<A>(matrix), rhs.as_mut_slice());
    match A::LEN {
        1 => {
            let pivot = rows[0].as_slice()[0];
            b[0] /= pivot;
            pivot.all_at_least_zero()
        }
        2 => of_two(rows, b) == Some(true),
        3 => of_three(rows, b) == Some(true),
        _ => of_pairs(rows, b) == Some(true),
    }
}

/// Whether so many unknowns have a rule of their own, which the ablation benchmark may switch off.
const fn has_rule(unknowns: usize) -> bool {
    match unknowns {
        0 | 1 => true,
        2 => ablation::CRAMER_TWO,
        3 => ablation::CRAMER_THREE,
        _ => ablation::PAIRS,
    }
}

/// The second term of the series r + Ar + A²r + … for the solution x of x = r + Ax, where `matrix` is 1 − A (C. Neumann, 1877): no division, and
/// nothing waits for a determinant.
#[inline(always)]
pub(crate) fn second_term<A: Array>(matrix: &Square<A>, r: &A) -> A {
    let mut term = *r;
    for (i, row) in A::entries_of::<A>(matrix).iter().enumerate() {
        for k in 0..A::LEN {
            // Of two unknowns the diagonal first: the sums of both are then paired.
            let j = if const { A::LEN == 2 } { (i + k) % A::LEN } else { k };
            let sum = &mut term.as_mut_slice()[i];
            *sum = (-row.as_slice()[j]).multiply_add(r.as_slice()[j], *sum);
        }
    }
    term
}

/// The determinant, by elimination with partial pivoting; destroys `matrix`.
pub(crate) fn determinant<A: Array>(matrix: &mut Square<A>) -> f64 {
    let rows = A::entries::<A>(matrix);
    let mut product = 1.0;
    for k in 0..A::LEN {
        for i in k + 1..A::LEN {
            if rows[i].as_slice()[k].magnitude() > rows[k].as_slice()[k].magnitude() {
                rows.swap(k, i);
                product = -product;
            }
        }
        let (upper, lower) = rows.split_at_mut(k + 1);
        let pivot = upper[k].as_slice()[k];
        product *= if pivot.any_below(0.0) { -pivot.magnitude() } else { pivot.magnitude() };
        if product == 0.0 {
            return product;
        }
        for row in lower {
            let factor = -(row.as_slice()[k] / pivot);
            row.add_scaled(factor, &upper[k]);
        }
    }
    product
}

/// In two operations: the optimiser makes a dozen of `f64::is_finite`.
#[inline(always)]
fn is_finite(x: f64) -> bool {
    0.0 * x == 0.0
}

/// Two unknowns, by Cramer's rule: one division in place of two that wait for each other.
#[inline(always)]
fn of_two<A: Array>(rows: &[A], b: &mut [A::Real]) -> Option<bool> {
    let ([a, b0], [c, d]) = ([0, 1].map(|j| rows[0].as_slice()[j]), [0, 1].map(|j| rows[1].as_slice()[j]));
    let determinant = a * d - b0 * c;
    let size = determinant.magnitude();
    if size == 0.0 || !is_finite(size) {
        return None;
    }
    let reciprocal = A::Real::from_f64(1.0) / determinant;
    (b[0], b[1]) = ((d * b[0] - b0 * b[1]) * reciprocal, (a * b[1] - c * b[0]) * reciprocal);
    Some(!determinant.any_below(0.0))
}

/// Two unknowns eliminated at a time, by Cramer's rule: half of the divisions that wait for each other. Nothing where the terms of a
/// determinant cancel, or it is small: exchanges lose less there.
#[inline(always)]
pub(super) fn of_pairs<A: Array>(rows: &mut [A], b: &mut [A::Real]) -> Option<bool> {
    let n = A::LEN;
    let mut positive = true;
    // Two rounds the compiler unrolls itself; of more it knows the indices only if they are written.
    let written = if n < 6 { 0 } else { 3 };
    if written > 0 {
        positive ^= eliminate_pair(rows, b, 0)?;
        positive ^= eliminate_pair(rows, b, 2)?;
        positive ^= eliminate_pair(rows, b, 4)?;
    }
    for k in (written..n / 2).map(|pair| 2 * pair) {
        positive ^= eliminate_pair(rows, b, k)?;
    }
    if n % 2 == 1 {
        let last = rows[n - 1].as_slice()[n - 1];
        let size = last.magnitude();
        if size == 0.0 || !is_finite(size) {
            return None;
        }
        positive ^= last.any_below(0.0);
        b[n - 1] /= last;
    }
    for k in (0..n / 2 * 2).rev() {
        let row = rows[k].as_slice();
        for j in k / 2 * 2 + 2..n {
            b[k] = (-row[j]).multiply_add(b[j], b[k]);
        }
    }
    Some(positive)
}

/// Eliminates unknowns k and k + 1. Whether their determinant is negative; nothing where its terms cancel.
#[inline(always)]
fn eliminate_pair<A: Array>(rows: &mut [A], b: &mut [A::Real], k: usize) -> Option<bool> {
    let n = A::LEN;
    let one = A::Real::from_f64(1.0);
    let (upper, lower) = rows.split_at_mut(k + 2);
    let (above, pair) = upper.split_at_mut(k + 1);
    let (top, next) = (above[k].as_mut_slice(), pair[0].as_mut_slice());
    let terms = [top[k] * next[k + 1], top[k + 1] * next[k]];
    let determinant = terms[0] - terms[1];
    let size = determinant.magnitude();
    let large = size > SMALL * (terms[0].magnitude() + terms[1].magnitude()) && size > SMALL * SMALL;
    if !large || !is_finite(size) {
        return None;
    }
    let negative = determinant.any_below(0.0);
    let reciprocal = one / determinant;
    let inverse = [next[k + 1], -top[k + 1], -next[k], top[k]].map(|entry| entry * reciprocal);
    let both = |x: A::Real, y: A::Real| {
        (inverse[0].multiply_add(x, inverse[1] * y), inverse[2].multiply_add(x, inverse[3] * y))
    };
    for j in k + 2..n {
        (top[j], next[j]) = both(top[j], next[j]);
    }
    (b[k], b[k + 1]) = both(b[k], b[k + 1]);
    for (i, row) in lower.iter_mut().enumerate() {
        let row = row.as_mut_slice();
        let factors = [-row[k], -row[k + 1]];
        for j in k + 2..n {
            row[j] = factors[0].multiply_add(top[j], factors[1].multiply_add(next[j], row[j]));
        }
        let i = k + 2 + i;
        b[i] = factors[0].multiply_add(b[k], factors[1].multiply_add(b[k + 1], b[i]));
    }
    Some(negative)
}

/// Three unknowns, by the adjugate: one division, where elimination has three that wait for each other. Nothing where the terms of the
/// determinant cancel: pivots lose less there.
#[inline(always)]
fn of_three<A: Array>(rows: &[A], b: &mut [A::Real]) -> Option<bool> {
    // Not by `map`, which leaves a loop through memory.
    let row = |i: usize| (rows[i].as_slice()[0], rows[i].as_slice()[1], rows[i].as_slice()[2]);
    let ((a, d, g), (e, f, k), (l, m, n)) = (row(0), row(1), row(2));
    let [x, y, z] = [f * n - k * m, k * l - e * n, e * m - f * l];
    let terms = [a * x, d * y, g * z];
    let determinant = terms[0] + (terms[1] + terms[2]);
    let sizes = terms.map(|term| term.magnitude());
    // What is no finite number is not large either.
    let large = determinant.magnitude() > SMALL * (sizes[0] + (sizes[1] + sizes[2]));
    if !large || !is_finite(determinant.magnitude()) {
        return None;
    }
    let reciprocal = A::Real::from_f64(1.0) / determinant;
    let [p, q, r] = [b[0], b[1], b[2]];
    let row = |u: A::Real, v: A::Real, w: A::Real| u.multiply_add(p, v.multiply_add(q, w * r)) * reciprocal;
    b[0] = row(x, g * m - d * n, d * k - g * f);
    b[1] = row(y, a * n - g * l, g * e - a * k);
    b[2] = row(z, d * l - a * m, a * f - d * e);
    Some(!determinant.any_below(0.0))
}
