//! Proof of an identity by its value at points of a finite field, for what is too long to be multiplied out.
//!
//! A polynomial of degree D that is not zero vanishes at a random point of a field with p elements with probability D/p at most
//! (R. Zippel, EUROSAM 1979, 216; J. T. Schwartz, J. ACM 27 (1980) 701). Symbols are random residues, functions unknowns that are
//! independent but for the relations in `functions`, so that what vanishes is zero wherever it is defined. Roots have all
//! combinations of signs at every point: the product over them is a polynomial, of which the degree is known. Points that lack a root for
//! some combination are drawn again. Two primes, since one may divide all coefficients. Seeds are fixed: builds are reproducible.

mod arguments;
mod choices;
mod degree;
mod evaluate;
mod functions;
mod prime;
mod rank;
mod span;

use super::OpenBoundaries;
use crate::ir::{Graph, Id};
use choices::Question;
use evaluate::{Evaluation, Halt, Plan, mixed};
use prime::{Element, PRIMES, Prime};
pub(super) use rank::rank;
pub(super) use span::Residues;

/// How sure a proof by points is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bound {
    /// The degree of the polynomial that vanishes at all points, or more.
    pub(crate) degree: u64,
    pub(crate) points: u32,
    /// What is no identity passes with a probability of at most 2⁻ᵇⁱᵗˢ.
    pub(crate) bits: u32,
}

/// What points say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Zero for all signs of roots, and on all sides of conditions.
    Zero(Bound),
    /// Zero for some signs of roots only: √(x²) = x.
    Branch,
    /// It does not follow from the relations that are known here.
    NotZero,
    /// It is too long, or has too many roots and conditions.
    GivenUp,
}

/// So many points with each prime.
const POINTS: u32 = 2;

/// So many draws for one point, and primes for roots that are not there.
const DRAWS: u64 = 64;

/// So many combinations of roots and conditions at a point.
const COMBINATIONS: usize = 4096;

/// A point that proves less than this many bits is not worth its time.
const FEWEST_BITS: u32 = 16;

/// Decides whether a node is zero off the open boundaries.
pub(super) fn residues(graph: &Graph, root: Id, open: &OpenBoundaries) -> Verdict {
    let Some(plan) = Plan::new(graph, &[root]) else { return Verdict::GivenUp };
    // Most identities hold whatever the roots are: then combinations need not be tried.
    match decided(&plan, root, open, true) {
        Verdict::NotZero | Verdict::Branch if plan.has_roots() => decided(&plan, root, open, false),
        verdict => verdict,
    }
}

fn decided(plan: &Plan<'_>, root: Id, open: &OpenBoundaries, free_roots: bool) -> Verdict {
    let mut all = Seen::default();
    let points = visit_points(plan, &[root], free_roots, &mut |point| {
        let seen = seen(point, root, open)?;
        all = Seen { zeros: all.zeros || seen.zeros, others: all.others || seen.others, none: all.none || seen.none };
        // Nothing more can be learned.
        Ok(!seen.none)
    });
    match points {
        Some(bound) if !all.others => Verdict::Zero(bound),
        Some(_) if !all.none => Verdict::Branch,
        None if !all.none => Verdict::GivenUp,
        _ => Verdict::NotZero,
    }
}

/// What is seen at points.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    zeros: bool,
    others: bool,
    /// For some signs of conditions, no choice of roots gives zero.
    none: bool,
}

fn seen(point: &mut Evaluation<'_>, root: Id, open: &OpenBoundaries) -> Result<Seen, Halt> {
    let mut seen = Seen::default();
    // Whether zero is reached, for each combination of conditions.
    let mut sides: Vec<(Vec<(Question, u8)>, bool)> = vec![];
    visit_combinations(point, &mut |evaluation| {
        if evaluation.is_on_any(open) {
            return Ok(());
        }
        let zero = evaluation.number(root)?.is_zero();
        let signs = evaluation.choices.signs();
        match sides.iter_mut().find(|(other, _)| *other == signs) {
            Some((_, any)) => *any |= zero,
            None => sides.push((signs, zero)),
        }
        seen.zeros |= zero;
        seen.others |= !zero;
        Ok(())
    })?;
    seen.none = sides.iter().any(|(_, any)| !any);
    Ok(seen)
}

/// Visits points until there are enough with two primes, or the visitor wants no more; `None` if there are not enough.
fn visit_points(
    plan: &Plan<'_>,
    roots: &[Id],
    free_roots: bool,
    visit: &mut impl FnMut(&mut Evaluation<'_>) -> Result<bool, Halt>,
) -> Option<Bound> {
    let degree = plan.degree(roots).max(1.0);
    let (mut primes, mut bits) = (0, 0);
    for prime in PRIMES {
        // Any of the draws may be the one that counts.
        let each = (prime.value as f64 / (2.0 * DRAWS as f64 * degree)).log2().floor();
        if each < f64::from(FEWEST_BITS) {
            return None;
        }
        let mut points = 0;
        for draw in 0..DRAWS {
            let mut evaluation = Evaluation::new(plan, prime, mixed(draw), free_roots);
            match visit(&mut evaluation) {
                Ok(true) => points += 1,
                // What divides by zero at a point does so everywhere, for some choices.
                Ok(false) | Err(Halt::GiveUp | Halt::Undefined) => return None,
                Err(Halt::Redraw) => {}
            }
            if points == POINTS {
                break;
            }
        }
        if points == POINTS {
            primes += 1;
            bits += POINTS * each as u32;
        }
        if primes == 2 {
            return Some(Bound { degree: degree as u64, points: 2 * POINTS, bits });
        }
    }
    None
}

/// Visits all combinations at a point.
fn visit_combinations(
    point: &mut Evaluation<'_>,
    visit: &mut impl FnMut(&Evaluation<'_>) -> Result<(), Halt>,
) -> Result<(), Halt> {
    let mut start = 0;
    for _ in 0..COMBINATIONS {
        point.run(start)?;
        visit(point)?;
        match point.choices.next() {
            Some(next) => start = next,
            None => return Ok(()),
        }
    }
    Err(Halt::GiveUp)
}

/// A number that looks random, the same in every run.
pub(super) fn noise(word: u64) -> u64 {
    mixed(word)
}
