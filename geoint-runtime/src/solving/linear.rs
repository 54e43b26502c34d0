//! Solves small linear systems M x = b, whose size the compiler knows.
//!
//! In the equation of a step, M is the derivative of r(x) = x − g(x). Its diagonal has no units. In most methods M is near the identity for short steps.
//! Cramer's rule solves for two unknowns, the adjugate for three, and the elimination of pairs for more. These rules do not exchange rows, and take few
//! divisions that wait for each other. The rules for three and more unknowns fail where terms cancel. Elimination with exchanges then loses fewer digits.
//!
//! Solvers return the sign of the determinant, because a negative sign shows that a step passes a singular point. Limit: the condition of M is not estimated.

use crate::ablation;
use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::{Array, Square};

/// A smaller pivot on the diagonal is compared with the entries below it. Pivots of short steps are near 1. A pivot of 1/8 beside entries of 1 may lose three
/// bits. A larger threshold would search more columns.
const PIVOT_THRESHOLD: f64 = 1.0 / 8.0;

/// A determinant below this part of the sum of the magnitudes of its terms has cancelled, and may have lost more than three bits.
const CANCELLATION: f64 = 1.0 / 8.0;

/// The sign of a determinant: `true` if it is positive, and `false` if it is negative.
pub(crate) type IsPositive = bool;

/// The opposite sign: `true` if a determinant is negative.
type IsNegative = bool;

/// Solves `matrix·x = rhs`, writes x to `rhs`, and may overwrite `matrix`.
///
/// Precondition: row i has the unit of unknown i, and `sizes` are the sizes of the unknowns. Two, three and four unknowns have fast rules. If the rule for
/// three or four unknowns fails, [`pivots`] solves for them. It always solves for one, and for more than four.
///
/// Returns `Some` with the sign of the determinant. Returns `None` if a pivot or determinant vanishes or is not finite: `rhs` is then invalid.
#[inline(always)]
pub(crate) fn solve<A: Array>(matrix: &mut Square<A>, rhs: &mut A, sizes: &Sizes<A>) -> Option<IsPositive> {
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

/// Solves by [`pivots`], out of line. Returns the solution and the result of [`pivots`]. Copies keep the caller's solution in registers: a shared place in
/// memory would be read in other pieces than it was written in, and stall the processor.
#[cold]
#[inline(never)]
fn pivots_apart<A: Array>(mut matrix: Square<A>, mut rhs: A, sizes: &Sizes<A>) -> (A, Option<IsPositive>) {
    let positive = pivots(&mut matrix, &mut rhs, sizes);
    (rhs, positive)
}

/// Solves `matrix·x = rhs` by elimination with threshold pivoting, writes x to `rhs`, and overwrites `matrix`.
///
/// A pivot on the diagonal of at least [`PIVOT_THRESHOLD`] stays. After the first exchange, each column is searched. Entries of a column are compared relative
/// to the sizes of their rows: row i has the size of unknown i. The choice of the pivot therefore does not depend on units.
///
/// Returns `Some` with the sign of the determinant. Returns `None` if a pivot vanishes or is not finite.
#[inline(always)]
pub(super) fn pivots<A: Array>(matrix: &mut Square<A>, rhs: &mut A, sizes: &Sizes<A>) -> Option<IsPositive> {
    let n = A::LEN;
    let mut sizes = *sizes;
    let sizes = sizes.entries();
    let rows = A::entries::<A>(matrix);
    let b = rhs.as_mut_slice();
    let (mut positive, mut ordered) = (true, true);
    for k in 0..n {
        if !ordered || rows[k].as_slice()[k].magnitude() < PIVOT_THRESHOLD {
            // The search exchanges rows until the largest entry is on top. The compiler then knows all indices and keeps a small matrix in registers.
            for i in k + 1..n {
                let [below, pivot] = [i, k].map(|i| rows[i].as_slice()[k].magnitude());
                // A pivot of zero is replaced even if sizes are still zero.
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
        // The reciprocal stays in place of the pivot, for the substitution below.
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

/// Solves `matrix·x = rhs` without exchanges of rows, writes x to `rhs`, and may overwrite `matrix`.
///
/// Returns `true` if the rule succeeds and the determinant is positive. After `false`, `rhs` is invalid, and the caller solves the equation in another way: a
/// fallback to exchanges would be inlined as well. Limits: two unknowns are not checked for cancellation. For one unknown, a zero matrix also returns `true`,
/// and the solution is infinite or NaN.
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

/// Returns whether systems of this many unknowns have a rule without exchanges. The ablation benchmark may switch off a rule.
const fn has_rule(unknowns: usize) -> bool {
    match unknowns {
        0 | 1 => true,
        2 => ablation::CRAMER_TWO,
        3 => ablation::CRAMER_THREE,
        _ => ablation::PAIRS,
    }
}

/// Returns the determinant by elimination with partial pivoting, and overwrites `matrix`. Limits: entries of a column are compared without regard to their
/// units, and the product of the pivots may underflow or overflow.
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

/// Returns whether `x` is finite, in two operations. The optimiser makes a dozen of `f64::is_finite`.
#[inline(always)]
fn is_finite(x: f64) -> bool {
    0.0 * x == 0.0
}

/// Solves for two unknowns by Cramer's rule, with one division, and writes them to `b`. Returns `Some` with the sign of the determinant. Returns `None` if the
/// determinant vanishes or is not finite. Limit: cancellation of its two terms is not detected.
#[inline(always)]
fn of_two<A: Array>(rows: &[A], b: &mut [A::Real]) -> Option<IsPositive> {
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

/// Eliminates two unknowns at a time by Cramer's rule, and writes the solution to `b`. This halves the number of divisions that wait for each other. Returns
/// `Some` with the sign of the determinant of the system. Returns `None`, with invalid `rows` and `b`, if [`eliminate_pair`] fails, or if the pivot of an odd
/// last unknown vanishes or is not finite.
#[inline(always)]
pub(super) fn of_pairs<A: Array>(rows: &mut [A], b: &mut [A::Real]) -> Option<IsPositive> {
    let n = A::LEN;
    let mut positive = true;
    // The compiler unrolls two rounds by itself. Three rounds are written out if there are as many, so that it knows their indices.
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

/// Eliminates unknowns k and k + 1. Returns the sign of their determinant. Returns `None` if the determinant is at most [`PIVOT_THRESHOLD`]², the threshold for
/// two pivots, if its terms cancel, or if it is not finite.
#[inline(always)]
fn eliminate_pair<A: Array>(rows: &mut [A], b: &mut [A::Real], k: usize) -> Option<IsNegative> {
    let n = A::LEN;
    let one = A::Real::from_f64(1.0);
    let (upper, lower) = rows.split_at_mut(k + 2);
    let (above, pair) = upper.split_at_mut(k + 1);
    let (top, next) = (above[k].as_mut_slice(), pair[0].as_mut_slice());
    let terms = [top[k] * next[k + 1], top[k + 1] * next[k]];
    let determinant = terms[0] - terms[1];
    let size = determinant.magnitude();
    let large =
        size > CANCELLATION * (terms[0].magnitude() + terms[1].magnitude()) && size > PIVOT_THRESHOLD * PIVOT_THRESHOLD;
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

/// Solves for three unknowns by the adjugate, with one division in place of three that wait for each other, and writes them to `b`. Returns `Some` with the
/// sign of the determinant. Returns `None`, and leaves `b` unchanged, if the terms of the determinant cancel, or if it is not finite.
///
/// Limit: cancellation within a minor, such as M₂₂M₃₃ − M₂₃M₃₂, is not detected. The solution then loses as many digits as the minor.
#[inline(always)]
fn of_three<A: Array>(rows: &[A], b: &mut [A::Real]) -> Option<IsPositive> {
    // The entries are written out, because `map` would leave a loop through memory.
    let row = |i: usize| (rows[i].as_slice()[0], rows[i].as_slice()[1], rows[i].as_slice()[2]);
    let ((a, d, g), (e, f, k), (l, m, n)) = (row(0), row(1), row(2));
    let [x, y, z] = [f * n - k * m, k * l - e * n, e * m - f * l];
    let terms = [a * x, d * y, g * z];
    let determinant = terms[0] + (terms[1] + terms[2]);
    let sizes = terms.map(|term| term.magnitude());
    // A determinant that is not finite does not count as large.
    let large = determinant.magnitude() > CANCELLATION * (sizes[0] + (sizes[1] + sizes[2]));
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
