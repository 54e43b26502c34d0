//! Proof of an identity by evaluation at points of a finite field, for nodes that are too long to be multiplied out.
//!
//! A nonzero polynomial of degree D over a field with p elements vanishes at a random point with probability at most D/p (R. Zippel,
//! EUROSAM 1979, 216; J. T. Schwartz, J. ACM 27 (1980) 701). Symbols are random residues. Functions are random unknowns, which are independent
//! except for the relations in `functions`. A node that vanishes under these rules is zero wherever it is defined.
//!
//! Roots take all combinations of signs at every point. The product over the combinations is a polynomial, whose degree is bounded in `degree`.
//! A point at which some root does not exist is drawn again. Two primes are used, since one may divide all coefficients. Seeds are fixed, so
//! builds are reproducible.

mod arguments;
mod choices;
mod degree;
mod evaluate;
mod functions;
mod polynomial;
mod prime;
mod rank;
mod span;

use super::{OpenBoundaries, Why};
use crate::ir::{Graph, Id};
use choices::Question;
use evaluate::{Evaluation, Halt, Plan, SquareRoots};
pub(super) use polynomial::Polynomial;
pub(super) use prime::{Element, PRIMES, Prime};
pub(crate) use rank::Dependent;
pub(super) use rank::dependent;
pub(super) use span::Span;

/// The error bound of a proof by points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bound {
    /// An upper bound of the degree of the polynomial that vanishes at all points.
    pub(crate) degree: u64,
    pub(crate) points: u32,
    /// An expression that is not an identity passes with a probability of at most 2⁻ᵇⁱᵗˢ.
    pub(crate) bits: u32,
}

/// The number of points with each of two primes.
const POINTS: u32 = 2;

/// The largest number of draws with a prime. A draw fails where a root does not exist.
const DRAWS: u64 = 64;

/// The largest number of combinations of roots and conditions at a point.
const COMBINATIONS: usize = 4096;

/// No points are evaluated if each would prove fewer bits than this.
const FEWEST_BITS: u32 = 16;

/// Proves that a node is zero off the open boundaries, or returns the reason why not.
pub(super) fn residues(graph: &Graph, root: Id, open: &OpenBoundaries) -> Result<Bound, Why> {
    let plan = Plan::new(graph, &[root]).ok_or(Why::TooLong)?;
    // Most identities do not depend on the values of the roots. They need no combinations of signs.
    match decided(&plan, root, open, SquareRoots::Independent) {
        Err(Why::Relation | Why::Branch) if plan.has_roots() => decided(&plan, root, open, SquareRoots::BothSigns),
        result => result,
    }
}

fn decided(plan: &Plan<'_>, root: Id, open: &OpenBoundaries, square_roots: SquareRoots) -> Result<Bound, Why> {
    let (mut is_zero_always, mut is_refuted) = (true, false);
    let bound = visit_points(plan, &[root], square_roots, &mut |point| {
        let sides = sides(point, root, open)?;
        is_zero_always &= sides.iter().all(|side| !side.has_nonzero);
        is_refuted |= sides.iter().any(|side| !side.has_zero);
        if is_refuted { Err(Halt::Refuted) } else { Ok(()) }
    });
    match bound {
        Some(bound) if is_zero_always => Ok(bound),
        Some(_) => Err(Why::Branch),
        None if is_refuted => Err(Why::Relation),
        None => Err(Why::TooLong),
    }
}

/// The values of a node for one combination of signs in conditions, over all signs of roots.
struct Side {
    signs: Vec<(Question, u8)>,
    has_zero: bool,
    has_nonzero: bool,
}

fn sides(point: &mut Evaluation<'_>, root: Id, open: &OpenBoundaries) -> Result<Vec<Side>, Halt> {
    let mut sides: Vec<Side> = vec![];
    visit_combinations(point, &mut |evaluation| {
        if evaluation.is_on_any(open) {
            return Ok(());
        }
        let is_zero = evaluation.number(root)?.is_zero();
        let signs = evaluation.choices.signs();
        match sides.iter_mut().find(|side| side.signs == signs) {
            Some(side) if is_zero => side.has_zero = true,
            Some(side) => side.has_nonzero = true,
            None => sides.push(Side { signs, has_zero: is_zero, has_nonzero: !is_zero }),
        }
        Ok(())
    })?;
    Ok(sides)
}

/// Visits random points until there are enough with two primes. `None` if there are too few points, or the visitor stops.
fn visit_points(
    plan: &Plan<'_>,
    roots: &[Id],
    square_roots: SquareRoots,
    visit: &mut impl FnMut(&mut Evaluation<'_>) -> Result<(), Halt>,
) -> Option<Bound> {
    let degree = plan.degree(roots).max(1.0);
    let (mut primes, mut bits) = (0, 0);
    for prime in PRIMES {
        // The visited point may be any of the draws, so their probabilities add up.
        let bits_of_point = (prime.value as f64 / (2.0 * DRAWS as f64 * degree)).log2().floor();
        if bits_of_point < f64::from(FEWEST_BITS) {
            return None;
        }
        let mut points = 0;
        for draw in 0..DRAWS {
            match visit(&mut Evaluation::new(plan, prime, pseudorandom(draw), square_roots)) {
                Ok(()) => points += 1,
                Err(Halt::Redraw) => {}
                // A division by zero at a random point is a division by zero everywhere, for some choices.
                Err(_) => return None,
            }
            if points == POINTS {
                primes += 1;
                bits += POINTS * bits_of_point as u32;
                break;
            }
        }
        if primes == 2 {
            return Some(Bound { degree: degree as u64, points: 2 * POINTS, bits });
        }
    }
    None
}

/// Visits all combinations of choices at a point.
fn visit_combinations(
    point: &mut Evaluation<'_>,
    visit: &mut impl FnMut(&Evaluation<'_>) -> Result<(), Halt>,
) -> Result<(), Halt> {
    let mut start = 0;
    for _ in 0..COMBINATIONS {
        point.run(start)?;
        visit(point)?;
        match point.choices.advance() {
            Some(changed) => start = changed,
            None => return Ok(()),
        }
    }
    Err(Halt::GiveUp)
}

/// A permutation of words with pseudorandom values (G. L. Steele, D. Lea & C. H. Flood, OOPSLA 2014, SplitMix).
pub(super) fn pseudorandom(word: u64) -> u64 {
    let word = word.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}
