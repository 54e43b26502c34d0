//! Bodies that attract each other: their masses from T, and the attraction of each pair from V.

use super::super::polynomial::{Polynomial, is_free, is_momentum, times_powers};
use super::super::products::{factors, known_terms};
use super::NoPart;
use crate::analyze::{self, Parts};
use crate::ir::formula::squared;
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};
use crate::messages::{NO_ATTRACTION, NO_CENTRE, NO_MASS, NOT_BODIES, NOT_ONE_MASS};
use crate::parse::Shape;
use std::collections::BTreeSet;

/// T = Σ |pᵢ|²/2mᵢ and V = −Σ cᵢⱼ/|qᵢ − qⱼ| + other terms.
#[derive(Clone, Debug)]
pub(crate) struct Attraction {
    pub(crate) masses: Vec<Id>,
    pub(crate) pairs: Vec<Pair>,
    /// The other terms of V.
    pub(crate) others: Vec<Id>,
}

/// A term −c/|qᵢ − qⱼ|, i < j.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) bodies: [usize; 2],
    /// c.
    pub(crate) strength: Id,
    pub(crate) term: Id,
}

/// Returns the bodies of an energy. Each row of `shape` contains the coordinates of a body.
pub(crate) fn attraction(graph: &mut Graph, parts: &Parts, shape: &Shape) -> Result<Attraction, NoPart> {
    let [_, dimensions] = shape.extents[..] else {
        return Err(NoPart { term: parts.potential, why: NOT_BODIES });
    };
    let masses = masses(graph, parts.kinetic, shape.len() / dimensions, dimensions)?;
    let (pairs, others) = known_terms(graph, parts.potential, |graph, term| Pair::of(graph, term, dimensions));
    if pairs.is_empty() {
        return Err(NoPart { term: parts.potential, why: NO_ATTRACTION });
    }
    Ok(Attraction { masses, pairs, others })
}

/// Returns the mass of each body. The error is a term that does not fit to T = Σ |pᵢ|²/2mᵢ.
fn masses(graph: &mut Graph, kinetic: Id, bodies: usize, dimensions: usize) -> Result<Vec<Id>, NoPart> {
    let no = |term| NoPart { term, why: NOT_ONE_MASS };
    let powers = Polynomial::of(graph, kinetic, &is_momentum).ok_or(no(kinetic))?;
    for (monomial, coefficient) in powers.terms() {
        let square = monomial.values().eq([&Ratio::integer(2)]);
        if !square || graph.reads(coefficient).t {
            return Err(no(times_powers(graph, coefficient, monomial)));
        }
    }
    let square_of = |graph: &mut Graph, coefficient: Id, p: Symbol| {
        let p = graph.symbol(p);
        graph.build(coefficient * squared(p))
    };
    let mut masses = vec![];
    for body in 0..bodies {
        let momentum = |i: usize| Symbol::Momentum((body * dimensions + i) as u32);
        let first = powers.coefficient(graph, &[(momentum(0), 2)]);
        for p in (0..dimensions).map(momentum) {
            let coefficient = powers.coefficient(graph, &[(p, 2)]);
            let difference = graph.sub(coefficient, first);
            if graph.is_zero(coefficient) {
                return Err(NoPart { term: graph.symbol(p), why: NO_MASS });
            }
            if !analyze::identity(graph, difference).is_zero() {
                return Err(no(square_of(graph, coefficient, p)));
            }
        }
        masses.push(graph.build(1 / (2 * first)));
        let sum = graph.sum(&masses);
        if analyze::identity(graph, sum).is_zero() {
            return Err(NoPart { term: square_of(graph, first, momentum(0)), why: NO_CENTRE });
        }
    }
    Ok(masses)
}

/// Returns r² for a power that is 1/r. The base is r², or r as a call of `hypot` or `abs`.
fn distance_squared(graph: &mut Graph, base: Id, exponent: Ratio) -> Option<Id> {
    let two = Ratio::integer(2);
    match graph.node(base).clone() {
        _ if exponent == (Ratio { numerator: -1, denominator: 2 }) => Some(base),
        Node::Call(Function::Hypot, args) if exponent == Ratio::integer(-1) => {
            let squares = [args[0], args[1]].map(|x| graph.pow(x, two));
            Some(graph.sum(&squares))
        }
        Node::Call(Function::Abs, args) if exponent == Ratio::integer(-1) => Some(graph.pow(args[0], two)),
        _ => None,
    }
}

impl Pair {
    /// Returns a term as −c/|qᵢ − qⱼ|.
    fn of(graph: &mut Graph, term: Id, dimensions: usize) -> Option<Pair> {
        let is_state = |symbol: Symbol| symbol.is_coordinate() || symbol == Symbol::Time;
        let (c, rest) = graph.coefficient(term);
        let (mut strength, mut square) = (graph.number(c.neg()), None);
        for (base, exponent) in factors(graph, rest) {
            if is_free(graph, base, &is_state) {
                let factor = graph.pow(base, exponent);
                strength = graph.mul(strength, factor);
            } else if square.is_none() {
                square = Some(distance_squared(graph, base, exponent)?);
            } else {
                return None;
            }
        }
        let square = square?;
        let mut bodies = BTreeSet::new();
        for symbol in graph.symbols(square).into_iter().filter(|symbol| is_state(*symbol)) {
            let Symbol::Position(i) = symbol else { return None };
            bodies.insert(i as usize / dimensions);
        }
        let [i, j] = bodies.into_iter().collect::<Vec<_>>()[..] else { return None };
        let mut squares = vec![];
        for d in 0..dimensions {
            let [a, b] = [j, i].map(|body| graph.symbol(Symbol::Position((body * dimensions + d) as u32)));
            squares.push(graph.build(squared(a - b)));
        }
        let distance = graph.sum(&squares);
        let difference = graph.sub(square, distance);
        analyze::identity(graph, difference).is_zero().then_some(Pair { bodies: [i, j], strength, term })
    }
}
