//! H = A + B: a part with an exact flow, and a rest that is a kick.
//!
//! Nothing is assumed to be small: that A + B is H is proven, and which part is to be solved exactly follows from the attribute, or is the
//! kinetic energy with the oscillators in V.

mod attraction;
mod bodies;
mod frame;
mod heliocentric;
mod jacobi;

use super::families::piece;
use super::flow::{Flow, Space, may_end};
use super::linear_motion::{is_whole, linear_motion};
use super::polynomial::{Monomial, Polynomial, degree, is_momentum, times_powers};
use super::time::Clock;
use crate::analyze::{self, Split, Structure};
use crate::diff;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};
use crate::lower::Place;
use crate::messages::{NO_EXACT_PART, NO_FLOW_OF_EXACT_PART, NOT_A_KICK, NOT_ONE_MASS, NOT_TWO_PARTS};
use crate::parse::{Coordinates, Energy};
use attraction::attraction;
use heliocentric::HELIOCENTRIC;
use jacobi::JACOBI;
use std::ops::Range;

/// A and B, in the coordinates in which methods move.
#[derive(Clone, Debug)]
pub(crate) struct Perturbed {
    /// A.
    pub(crate) exact: Id,
    /// B without what is in `jump`: it reads positions and time.
    pub(crate) kick: Id,
    /// The other part of B.
    pub(crate) jump: Option<Jump>,
    pub(crate) flow: Flow,
    pub(crate) clock: Clock,
    /// Parts of the flow of A that may end within a step, each with the coordinates that it moves.
    pub(crate) parts: Vec<(OwnMotion, Range<usize>)>,
    /// What is known of the flow of A: the rule, and what it is for.
    pub(crate) known: Vec<String>,
    /// ∂A/∂p, if A is of degree 2 in p with constant coefficients of its squares: then \[B, \[A, B\]\] is a kick. Else the term in the way.
    pub(crate) velocity: Result<Vec<Id>, Id>,
    pub(crate) inner: Option<Inner>,
}

/// What a part of a flow is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OwnMotion {
    /// By its energy.
    Energy(Id),
    /// The orbit of a body.
    Orbit(usize),
}

/// A part of the kinetic energy that moves positions alone.
#[derive(Clone, Debug)]
pub(crate) struct Jump {
    pub(crate) energy: Id,
    /// Of each coordinate, in words of what has the place of momenta.
    pub(crate) velocity: Vec<Id>,
    /// Whether kicks leave it as it is and it leaves kicks as they are, so that both together are the flow of B.
    pub(crate) commutes: bool,
}

/// Coordinates other than those of the state.
#[derive(Clone, Debug)]
pub(crate) struct Inner {
    pub(crate) name: &'static str,
    /// Each of them, by those of the state.
    pub(crate) enter: Vec<(Symbol, Id)>,
    /// The state, by them.
    pub(crate) leave: Vec<(Symbol, Id)>,
    /// What has the place of each momentum is that momentum times this.
    pub(crate) weights: Vec<Id>,
    pub(crate) masses: Vec<Id>,
    /// Masses, each with a sum of masses that it is divided by.
    pub(crate) shares: Vec<[Id; 2]>,
}

/// Why there is no such part: the term, and what is wrong with it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoPart {
    pub(crate) term: Id,
    pub(crate) why: &'static str,
}

/// A and B, or why there are none.
pub(crate) type Division = Result<Perturbed, NoPart>;

/// A and B: as the attribute says, or T with the oscillators in V, and the rest.
pub(crate) fn divided(
    graph: &mut Graph,
    structure: &Structure,
    energy: &Energy,
    groups: Option<&[(Id, Place)]>,
) -> Division {
    let degrees = energy.degrees();
    if let Some(groups) = groups {
        return match groups {
            [(exact, _), (rest, _)] => of_parts(graph, *exact, *rest, degrees),
            _ => Err(NoPart { term: structure.energy, why: NOT_TWO_PARTS }),
        };
    }
    let parts = match &structure.split {
        Split::Separable(parts) => parts,
        Split::Coupled(term) if energy.options.coordinates.is_some() => {
            return Err(NoPart { term: *term, why: NOT_ONE_MASS });
        }
        Split::Coupled(term) => return coupled(graph, structure.energy, *term, degrees),
    };
    if let Some((coordinates, _)) = energy.options.coordinates {
        let frame = match coordinates {
            Coordinates::Jacobi => JACOBI,
            Coordinates::Heliocentric => HELIOCENTRIC,
        };
        let shape = &energy.coordinates.shape;
        let attraction = attraction(graph, parts, shape)?;
        return Ok(bodies::perturbed(graph, &frame, &attraction, shape));
    }
    // All that is quadratic, or where that has no flow the squares of single positions.
    for single in [false, true] {
        let (bound, rest) = oscillators(graph, parts.potential, single);
        if graph.is_zero(bound) {
            return Err(NoPart { term: parts.potential, why: NO_EXACT_PART });
        }
        let exact = graph.add(parts.kinetic, bound);
        let found = of_parts(graph, exact, rest, degrees);
        if found.is_ok() || single {
            return found;
        }
    }
    Err(NoPart { term: parts.potential, why: NO_EXACT_PART })
}

/// The quadratic terms and whatever else reads momenta, and the rest.
fn coupled(graph: &mut Graph, energy: Id, term: Id, degrees: u32) -> Division {
    let terms = analyze::terms(graph, energy);
    let space = Space { degrees, action: false };
    let (bound, _) = linear_motion(graph, &terms, space).ok_or(NoPart { term, why: NO_EXACT_PART })?;
    let (exact, rest): (Vec<Id>, Vec<Id>) =
        terms.into_iter().partition(|term| bound.contains(term) || graph.reads(*term).p);
    let [exact, rest] = [exact, rest].map(|terms| graph.sum(&terms));
    if graph.is_zero(rest) {
        return Err(NoPart { term, why: NO_EXACT_PART });
    }
    of_parts(graph, exact, rest, degrees)
}

/// A with its flow and B, if they have flows.
fn of_parts(graph: &mut Graph, exact: Id, rest: Id, degrees: u32) -> Division {
    let reads = graph.reads(rest);
    if reads.p || reads.s {
        return Err(NoPart { term: rest, why: NOT_A_KICK });
    }
    let found = piece(graph, exact, Space { degrees, action: false })
        .ok_or(NoPart { term: exact, why: NO_FLOW_OF_EXACT_PART })?;
    let ends = may_end(graph, exact, &found.flow.all());
    Ok(Perturbed {
        exact,
        kick: rest,
        jump: None,
        clock: found.clock,
        known: vec![format!("{}: {} ({})", found.family.name, found.family.energies, found.family.source)],
        velocity: velocity(graph, exact, degrees),
        parts: if ends { vec![(OwnMotion::Energy(exact), 0..degrees as usize)] } else { vec![] },
        flow: found.flow,
        inner: None,
    })
}

/// ∂A/∂p, if A is of degree 2 in p with constant coefficients of its squares.
fn velocity(graph: &mut Graph, exact: Id, degrees: u32) -> Result<Vec<Id>, Id> {
    let Some(powers) = Polynomial::of(graph, exact, &is_momentum) else { return Err(exact) };
    for (monomial, coefficient) in powers.into_terms() {
        let whole = monomial.values().all(|power| power.is_integer() && power.numerator > 0);
        let degree: i128 = monomial.values().map(|power| power.numerator).sum();
        let reads = graph.reads(coefficient);
        if !whole || degree > 2 || degree == 2 && (reads.q || reads.t) {
            return Err(times_powers(graph, coefficient, &monomial));
        }
    }
    Ok(diff::gradient(graph, exact, degrees).p)
}

/// The terms of a potential that are quadratic with constant coefficients, of single positions or of any; and the others.
fn oscillators(graph: &mut Graph, potential: Id, single: bool) -> (Id, Id) {
    let mut terms = analyze::single_terms(graph, potential);
    let bound = terms.extract_if(.., |term| is_oscillator(graph, *term, single)).collect::<Vec<_>>();
    (graph.sum(&bound), graph.sum(&terms))
}

fn is_oscillator(graph: &mut Graph, term: Id, single: bool) -> bool {
    let Some(powers) = Polynomial::of(graph, term, &|symbol| symbol.is_coordinate() || symbol == Symbol::Time) else {
        return false;
    };
    let two = Some(Ratio::integer(2));
    let of_degree = |monomial: &Monomial| degree(monomial.values().copied());
    let allowed = |monomial: &Monomial| {
        let whole = is_whole(monomial) && !monomial.contains_key(&Symbol::Time);
        whole && if single { monomial.len() == 1 && of_degree(monomial) == two } else { of_degree(monomial) <= two }
    };
    powers.has_only(allowed) && powers.terms().any(|(monomial, _)| of_degree(monomial) == two)
}

/// Half of a number.
fn halved(graph: &mut Graph, x: Id) -> Id {
    graph.scale(Number::HALF, x)
}
