//! H = A + B: A has an exact flow, and the rest B is a kick.
//!
//! The user's attribute selects A, or A is the kinetic energy with the oscillators of V. A + B = H is proven. Neither part has to be small.

mod attraction;
mod bodies;
mod frame;
mod heliocentric;
mod jacobi;

use super::families::piece;
use super::flow::{Flow, Space, may_end};
use super::linear_motion::linear_motion;
use super::polynomial::{Monomial, Polynomial, degree, is_momentum, is_whole, times_powers};
use super::time::Clock;
use crate::analyze::{self, Split, Structure};
use crate::diff;
use crate::ir::{Graph, Id, Ratio, Symbol};
use crate::lower::Place;
use crate::messages::{NO_EXACT_PART, NO_FLOW_OF_EXACT_PART, NOT_A_KICK, NOT_ONE_MASS, NOT_TWO_PARTS};
use crate::parse::{Coordinates, Energy};
use attraction::attraction;
use heliocentric::HELIOCENTRIC;
use jacobi::JACOBI;
use std::ops::Range;

/// A and B, in the coordinates in which the method moves.
#[derive(Clone, Debug)]
pub(crate) struct Perturbed {
    /// A.
    pub(crate) exact: Id,
    /// B without `jump`. It reads positions and time.
    pub(crate) kick: Id,
    /// The part of B that moves positions.
    pub(crate) jump: Option<Jump>,
    /// The flow of A.
    pub(crate) flow: Flow,
    pub(crate) clock: Clock,
    /// Parts of the flow of A that may end within a step, with the coordinates that each part moves.
    pub(crate) parts: Vec<(OwnMotion, Range<usize>)>,
    /// The rule for the flow of A, with its energies and source, for reports.
    pub(crate) known: Vec<String>,
    /// ∂A/∂p, if A has degree 2 in p and its quadratic coefficients are constant. Then \[B, \[A, B\]\] is a kick. Otherwise, a term that violates the
    /// condition.
    pub(crate) velocity: Result<Vec<Id>, Id>,
    /// The coordinates of the method, if they are not the coordinates of the state.
    pub(crate) inner: Option<Inner>,
}

/// The name of a part of a flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OwnMotion {
    /// The flow of an energy.
    Energy(Id),
    /// The orbit of a body.
    Orbit(usize),
}

/// A part of the kinetic energy that moves positions only.
#[derive(Clone, Debug)]
pub(crate) struct Jump {
    pub(crate) energy: Id,
    /// The velocity of each coordinate, as a function of the inner velocities.
    pub(crate) velocity: Vec<Id>,
    /// Whether jump and kick commute, so that their composition is the flow of B.
    pub(crate) commutes: bool,
}

/// Inner coordinates of a method. Velocities take the place of momenta.
#[derive(Clone, Debug)]
pub(crate) struct Inner {
    pub(crate) name: &'static str,
    /// The inner coordinates as functions of the state.
    pub(crate) enter: Vec<(Symbol, Id)>,
    /// The state as functions of the inner coordinates.
    pub(crate) leave: Vec<(Symbol, Id)>,
    /// The quotients of inner velocities and inner momenta.
    pub(crate) weights: Vec<Id>,
    pub(crate) masses: Vec<Id>,
    /// Pairs of a mass and the sum of masses by which it is divided.
    pub(crate) shares: Vec<[Id; 2]>,
}

/// The reason why H has no such parts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoPart {
    pub(crate) term: Id,
    /// The message about the term.
    pub(crate) why: &'static str,
}

/// A and B, or the reason why they do not exist.
pub(crate) type Division = Result<Perturbed, NoPart>;

/// Divides H as the user's attribute says, or else into T with the oscillators of V and the rest.
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
    // If the flow with all quadratic terms is not known, A contains only the squares of single positions.
    let mut found = Err(NoPart { term: parts.potential, why: NO_EXACT_PART });
    for oscillators in [Oscillators::Coupled, Oscillators::Single] {
        let mut rest = analyze::single_terms(graph, parts.potential);
        let bound: Vec<Id> = rest.extract_if(.., |term| oscillators.contain(graph, *term)).collect();
        let [bound, rest] = [bound, rest].map(|terms| graph.sum(&terms));
        if graph.is_zero(bound) {
            return Err(NoPart { term: parts.potential, why: NO_EXACT_PART });
        }
        let exact = graph.add(parts.kinetic, bound);
        found = of_parts(graph, exact, rest, degrees);
        if found.is_ok() {
            break;
        }
    }
    found
}

/// Divides a coupled H into A, which contains the linear motion and all other terms that read momenta, and the rest.
fn coupled(graph: &mut Graph, energy: Id, term: Id, degrees: u32) -> Division {
    let none = NoPart { term, why: NO_EXACT_PART };
    let terms = analyze::terms(graph, energy);
    let bound = linear_motion(graph, &terms, Space { degrees, action: false }).ok_or(none)?.terms;
    let (exact, rest): (Vec<Id>, Vec<Id>) =
        terms.into_iter().partition(|term| bound.contains(term) || graph.reads(*term).p);
    let [exact, rest] = [exact, rest].map(|terms| graph.sum(&terms));
    if graph.is_zero(rest) {
        return Err(none);
    }
    of_parts(graph, exact, rest, degrees)
}

/// Returns A = `exact` with its flow and B = `rest`, if A has a known flow and B is a kick.
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

/// Returns ∂A/∂p, if A has degree 2 in p and its quadratic coefficients are constant. The error is a term that violates the condition.
fn velocity(graph: &mut Graph, exact: Id, degrees: u32) -> Result<Vec<Id>, Id> {
    let Some(powers) = Polynomial::of(graph, exact, &is_momentum) else { return Err(exact) };
    for (monomial, coefficient) in powers.into_terms() {
        let degree: i128 = monomial.values().map(|power| power.numerator).sum();
        let reads = graph.reads(coefficient);
        if !is_whole(&monomial) || degree > 2 || degree == 2 && (reads.q || reads.t) {
            return Err(times_powers(graph, coefficient, &monomial));
        }
    }
    Ok(diff::gradient(graph, exact, degrees).p)
}

/// The quadratic terms of a potential that join the kinetic energy.
#[derive(Clone, Copy, PartialEq)]
enum Oscillators {
    /// All terms of degree 2, with lower powers.
    Coupled,
    /// Squares of single positions.
    Single,
}

impl Oscillators {
    /// Returns whether a term belongs to the oscillators. Its coefficients must not read time.
    fn contain(self, graph: &mut Graph, term: Id) -> bool {
        let counts = |symbol: Symbol| symbol.is_coordinate() || symbol == Symbol::Time;
        let Some(powers) = Polynomial::of(graph, term, &counts) else { return false };
        let two = Some(Ratio::integer(2));
        let allowed = |monomial: &Monomial| {
            let fits = match self {
                Oscillators::Coupled => degree(monomial) <= two,
                Oscillators::Single => monomial.len() == 1 && degree(monomial) == two,
            };
            fits && is_whole(monomial) && !monomial.contains_key(&Symbol::Time)
        };
        powers.has_only(allowed) && powers.terms().any(|(monomial, _)| degree(monomial) == two)
    }
}
