//! How large are the terms of which the right-hand side of x = g(x) consists?
//!
//! The rounding of g is ε times its terms, which may be far larger than g: forces between neighbours cancel. The terms are not known
//! to a solver, but how g bends shows them. Over the length L on which a term changes by all of itself, its derivative does so
//! too: where g' changes by a part ρ of it over a distance d, that is ρ = d/L, and the term is g'L = g'd/ρ. Where g does not bend,
//! there is nothing but what it is linear in.

use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::{Array, Square};

/// A derivative that has changed by this part of it shows how far its terms reach.
const BENT: f64 = 1.0 / 1024.0;

/// A derivative that has changed by more than this part of it says nothing any more.
const ALL: f64 = 0.25;

/// Distances at which bending is searched for: powers of 4, from the last digit of the unknowns on.
const DISTANCES: u32 = 60;

/// The terms of one equation, which are looked for where corrections do not shrink.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terms<A> {
    /// Sizes without them.
    others: Sizes<A>,
    known: Known,
}

/// Where terms were looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Known {
    Nowhere,
    /// Where an iteration was stuck: perhaps far from where it ended.
    OnTheWay,
    AtTheSolution,
}

impl<A: Array> Terms<A> {
    pub(crate) fn new(sizes: &Sizes<A>) -> Self {
        Terms { others: *sizes, known: Known::Nowhere }
    }

    /// Whether terms were looked for. They say how large rounding of g is, not of x: from then on residuals are judged, not
    /// corrections. Where g is steep a correction may be far below the rounding of g while x is far from a solution.
    #[inline(always)]
    pub(crate) fn are_known(&self) -> bool {
        self.known != Known::Nowhere
    }

    /// The sizes without them, for whatever comes after an iteration that has found no solution.
    #[inline(always)]
    pub(crate) fn without(&self) -> Sizes<A> {
        self.others
    }

    /// Whether an iteration that has ended was judged by its own terms.
    #[inline(always)]
    pub(crate) fn are_valid(&self) -> bool {
        self.known != Known::OnTheWay
    }

    /// Includes the terms of g near `x` in the sizes, in place of those from before in this iteration.
    ///
    /// `kind` says which unknowns have one unit: they are moved by as much as the largest of them. `matrix` writes 1 − g' at a point,
    /// or is false if there is none.
    #[cold]
    pub(crate) fn include(
        &mut self,
        sizes: &mut Sizes<A>,
        (origin, x): (&A, &A),
        solved: bool,
        kind: impl Fn(usize) -> usize,
        matrix: impl FnMut(&A, &mut Square<A>) -> bool,
    ) {
        *sizes = self.others;
        sizes.include(origin, x);
        self.known = if solved { Known::AtTheSolution } else { Known::OnTheWay };
        sizes.include(&A::zero(), &terms(sizes, x, kind, matrix));
    }
}

/// The terms of g near `x`.
fn terms<A: Array>(
    sizes: &Sizes<A>,
    x: &A,
    kind: impl Fn(usize) -> usize,
    mut matrix: impl FnMut(&A, &mut Square<A>) -> bool,
) -> A {
    let minus = A::Real::from_f64(-1.0);
    let mut direction = A::zero();
    for (i, d) in direction.as_mut_slice().iter_mut().enumerate() {
        let unit = (0..A::LEN).filter(|j| kind(*j) == kind(i)).map(|j| sizes.of(j)).fold(0.0, f64::max);
        // By different parts of that, so that differences of neighbours change.
        let golden = 0.618_033_988_749_894_9 * (i + 1) as f64;
        *d = A::Real::from_f64(unit * (0.5 + (golden - libm::floor(golden))));
    }
    // Σⱼ |aⱼ dⱼ|.
    let product = |a: &A| -> f64 {
        a.as_slice().iter().zip(direction.as_slice()).map(|(a, d)| a.magnitude() * d.magnitude()).sum()
    };
    let (mut here, mut there) = (A::fill(A::zero()), A::fill(A::zero()));
    let (mut terms, mut rows) = (A::zero(), A::fill(Row::Unknown));
    let mut distance = A::Real::epsilon();
    for step in 0..DISTANCES {
        let mut moved = *x;
        moved.add_scaled(A::Real::from_f64(distance), &direction);
        if !matrix(&moved, &mut there) {
            break;
        }
        for (i, row) in A::entries::<A>(&mut there).iter_mut().enumerate() {
            row.as_mut_slice()[i] += minus;
        }
        let rows = A::entries(&mut rows);
        for (i, (from, to)) in A::entries_of::<A>(&here).iter().zip(A::entries_of::<A>(&there)).enumerate() {
            let mut change = *to;
            change.add_scaled(minus, from);
            let (slope, change) = (product(from), product(&change));
            let term = slope * (slope * distance / change);
            // What overflows shows nothing.
            if step == 0 || rows[i] == Row::Bent || slope == 0.0 || !term.is_finite() {
                continue;
            }
            let straight = change < BENT * slope;
            rows[i] = match rows[i] {
                _ if straight => Row::Straight,
                // Rounding of the derivative.
                Row::Unknown if change > ALL * slope => Row::Unknown,
                _ if change > ALL * slope => Row::Bent,
                row => row,
            };
            let terms = &mut terms.as_mut_slice()[i];
            // A derivative that jumps shows no length.
            if !straight && rows[i] != Row::Bent && term > terms.magnitude() {
                *terms = A::Real::from_f64(term);
            }
        }
        if rows.iter().all(|row| *row == Row::Bent) {
            break;
        }
        here = there;
        distance *= 4.0;
    }
    terms
}

/// What is known of a row of g'.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Row {
    Unknown,
    /// It does not change by more than rounding over distances so far.
    Straight,
    /// It has changed by all of itself.
    Bent,
}
