//! Bodies that attract each other: their masses, read off T, and what is between each two of them, read off V.

use super::super::polynomial::{Polynomial, factors, is_free, is_momentum, times_powers};
use super::super::products::known_terms;
use super::NoPart;
use crate::analyze::{self, Parts};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
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

/// The bodies of an energy, of which `shape` has the coordinates: one a row.
pub(crate) fn attraction(graph: &mut Graph, parts: &Parts, shape: &Shape) -> Result<Attraction, NoPart> {
    let [_, dimensions] = shape.extents[..] else {
        return Err(NoPart { term: parts.potential, why: NOT_BODIES });
    };
    let masses = masses(graph, parts.kinetic, shape.len() / dimensions, dimensions)?;
    let (pairs, others) = known_terms(graph, parts.potential, |graph, term| {
        let (bodies, strength) = pair(graph, term, dimensions)?;
        Some(Pair { bodies, strength, term })
    });
    if pairs.is_empty() {
        return Err(NoPart { term: parts.potential, why: NO_ATTRACTION });
    }
    Ok(Attraction { masses, pairs, others })
}

/// The mass of each body; or the term by which T is something else.
fn masses(graph: &mut Graph, kinetic: Id, bodies: usize, dimensions: usize) -> Result<Vec<Id>, NoPart> {
    let no = |term| NoPart { term, why: NOT_ONE_MASS };
    let powers = Polynomial::of(graph, kinetic, &is_momentum).ok_or(no(kinetic))?;
    for (monomial, coefficient) in powers.clone().into_terms() {
        let square = monomial.len() == 1 && monomial.values().all(|power| *power == Ratio::integer(2));
        if !square || graph.reads(coefficient).t {
            return Err(no(times_powers(graph, coefficient, &monomial)));
        }
    }
    let mut masses = vec![];
    for body in 0..bodies {
        let of = |graph: &mut Graph, i: usize| {
            let p = Symbol::Momentum((body * dimensions + i) as u32);
            (powers.coefficient(graph, &[(p, 2)]), p)
        };
        let (first, p) = of(graph, 0);
        for i in 0..dimensions {
            let (coefficient, p) = of(graph, i);
            let difference = graph.sub(coefficient, first);
            let p = graph.symbol(p);
            if graph.is_zero(coefficient) {
                return Err(NoPart { term: p, why: NO_MASS });
            }
            if !analyze::identity(graph, difference).is_zero() {
                return Err(no(square_of(graph, coefficient, p)));
            }
        }
        let twice = graph.scale(Number::integer(2), first);
        masses.push(graph.recip(twice));
        let sum = graph.sum(&masses);
        if analyze::identity(graph, sum).is_zero() {
            let p = graph.symbol(p);
            return Err(NoPart { term: square_of(graph, first, p), why: NO_CENTRE });
        }
    }
    Ok(masses)
}

fn square_of(graph: &mut Graph, coefficient: Id, p: Id) -> Id {
    let square = graph.pow(p, Ratio::integer(2));
    graph.mul(coefficient, square)
}

/// r² of a power that is 1/r: of r², or of a distance in the plane or on a line.
fn distance_squared(graph: &mut Graph, base: Id, exponent: Ratio) -> Option<Id> {
    match graph.node(base).clone() {
        _ if exponent == (Ratio { numerator: -1, denominator: 2 }) => Some(base),
        Node::Call(Function::Hypot, args) if exponent == Ratio::integer(-1) => {
            let squares = [args[0], args[1]].map(|x| graph.pow(x, Ratio::integer(2)));
            Some(graph.sum(&squares))
        }
        Node::Call(Function::Abs, args) if exponent == Ratio::integer(-1) => {
            Some(graph.pow(args[0], Ratio::integer(2)))
        }
        _ => None,
    }
}

/// The two bodies and c of −c/|qᵢ − qⱼ|, if a term is that.
fn pair(graph: &mut Graph, term: Id, dimensions: usize) -> Option<([usize; 2], Id)> {
    let is_state = |symbol: Symbol| symbol.is_coordinate() || symbol == Symbol::Time;
    let (c, rest) = graph.coefficient(term);
    let mut strength = graph.number(c.neg());
    let mut square = None;
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
    let read: BTreeSet<usize> = graph
        .reachable(&[square])
        .into_iter()
        .map(|id| match graph.node(id) {
            Node::Symbol(Symbol::Position(i)) => Some(Some(*i as usize / dimensions)),
            Node::Symbol(symbol) if is_state(*symbol) => None,
            _ => Some(None),
        })
        .collect::<Option<Vec<_>>>()?
        .into_iter()
        .flatten()
        .collect();
    let [i, j] = read.into_iter().collect::<Vec<_>>()[..] else { return None };
    let mut squares = vec![];
    for d in 0..dimensions {
        let [a, b] = [j, i].map(|body| graph.symbol(Symbol::Position((body * dimensions + d) as u32)));
        let difference = graph.sub(a, b);
        squares.push(graph.pow(difference, Ratio::integer(2)));
    }
    let distance = graph.sum(&squares);
    let difference = graph.sub(square, distance);
    analyze::identity(graph, difference).is_zero().then_some(([i, j], strength))
}
