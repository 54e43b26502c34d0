//! From a Lagrangian L(q, v, s, t) to its energy H(q, p, s, t) = p·v − L with p = ∂L/∂v, where v follows from p in closed form.
//!
//! Velocities that no second derivative of L couples form separate parts. A part is quadratic in its velocities, and its mass matrix M is factored
//! once; or it is one term with a known conjugate plus terms that are linear in the velocities. All other derived functions follow from H.

mod conjugate;
mod definite;
mod first_order;
mod friction;
mod idle_coordinates;
mod inverse;
mod kinks;
mod mass;
mod parts;
mod quadratic;

use crate::analyze::liouville::{Logarithm, antiderivative};
use crate::diff;
use crate::ir::substitute::{Substitution, at_zero};
use crate::ir::{Graph, Id, Node, Symbol, UndefinedAt};
pub(crate) use definite::{Definite, definite};
pub(crate) use first_order::{Canonical, FirstOrder, FirstOrderFlaw, LARGEST_BLOCK, first_order};
pub(crate) use friction::{Friction, NoFriction, friction, rate};
pub(crate) use inverse::{Inverse, inverse};
use parts::Parts;

/// A Lagrangian with its derivatives and the route to its steps.
#[derive(Debug)]
pub(crate) struct Legendre {
    pub(crate) lagrangian: Id,
    /// ∂L/∂q.
    pub(crate) forces: Vec<Id>,
    /// p = ∂L/∂v.
    pub(crate) momenta: Vec<Id>,
    pub(crate) parts: Vec<Part>,
    /// The part of −L that reads no velocity.
    pub(crate) potential: Id,
    /// M = ∂²L/∂v², symmetric, and free of velocities where L is quadratic.
    pub(crate) mass: Vec<Vec<Id>>,
    /// ∂L/∂v at rest.
    pub(crate) shift: Vec<Id>,
    pub(crate) route: Route,
    /// The partial nodes of L and H.
    pub(crate) partial: Vec<UndefinedAt>,
    /// The divisors of H. One of them vanishes where M is singular.
    pub(crate) divisors: Vec<Id>,
    /// Whether M is negative definite for all values of the parameters.
    pub(crate) concave: bool,
    /// The function f(q, t), if the terms of L that are linear in v are ∂f/∂q·v.
    pub(crate) gauge: Option<Id>,
    /// The rate γ of friction γMv.
    pub(crate) friction: Option<Id>,
}

/// The function from which steps are derived.
#[derive(Debug)]
pub(crate) enum Route {
    /// The energy H, with the velocities ∂H/∂p.
    Energy { energy: Id, velocities: Vec<Id> },
    /// L itself with velocities as unknowns. The obstacle is an entry of M that makes H long, or a term without a known conjugate.
    Velocities { obstacle: Id },
}

/// Velocities that L couples, in order, and their relation to momenta.
#[derive(Debug)]
pub(crate) struct Part {
    pub(crate) velocities: Vec<u32>,
    pub(crate) kinetic: Kinetic,
}

/// The form of L in the velocities of a part.
#[derive(Debug)]
pub(crate) enum Kinetic {
    /// vᵀMv/2 + a·v.
    Quadratic { mass: Vec<Vec<Id>>, shift: Vec<Id> },
    /// A term with a known conjugate, and the rule in words.
    Conjugate { term: Id, rule: &'static str },
    /// A term that is not quadratic and has no known conjugate.
    Open(Id),
}

/// The reason why a Lagrangian has no energy.
#[derive(Debug)]
pub(crate) enum Flaw {
    /// L does not read this velocity.
    Unread(u32),
    /// The momentum of this velocity jumps where velocities change.
    Jumps(u32, Id),
    /// L is linear in all velocities, with these momenta.
    Linear(Vec<Id>),
    /// L is linear in this velocity and does not couple it to another velocity. The node is its momentum.
    LinearIn(u32, Id),
    /// The mass matrix of these velocities is singular at every state, in this direction.
    Singular(Vec<u32>, Vec<Id>),
    /// The velocities are functions of the momenta, but no formula for them is known because of this term.
    NotClosed(Vec<u32>, Id),
}

/// Derives the energy of a Lagrangian, or finds the obstacle. With `needs_energy`, H is derived even if it is long, and a term without a known
/// conjugate is an error. `written` lists the partial nodes of L.
pub(crate) fn transform(
    graph: &mut Graph,
    lagrangian: Id,
    degrees: u32,
    needs_energy: bool,
    written: &[UndefinedAt],
) -> Result<Legendre, Flaw> {
    let symbols: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
    let diff::Gradient { q: forces, v: momenta, .. } = diff::gradient(graph, lagrangian, degrees);
    if let Some(i) = (0..momenta.len()).find(|i| kinks::jumps(graph, momenta[*i])) {
        return Err(Flaw::Jumps(i as u32, momenta[i]));
    }
    let mass = mass::masses(graph, &momenta, &symbols);
    mass::regular(graph, &momenta, &mass)?;
    let simple = mass::simplified(graph, &mass);
    mass::regular(graph, &momenta, &simple)?;
    let shift: Vec<Id> = momenta.iter().map(|momentum| at_rest(graph, *momentum)).collect();

    // Record the divisors of H. They must not vanish, either.
    graph.take_partial();
    let Parts { parts, kinetic, potential, obstacle } =
        parts::parts(graph, lagrangian, &momenta, &simple, &shift, needs_energy)?;
    let energy = graph.add(kinetic, potential);
    let divided = graph.take_partial();
    graph.stop_recording();

    let open = parts.iter().find_map(|part| match part.kinetic {
        Kinetic::Open(term) => Some((&part.velocities, term)),
        _ => None,
    });
    if let (Some((velocities, term)), true) = (open, needs_energy) {
        return Err(Flaw::NotClosed(velocities.clone(), term));
    }
    let mass = mass::choose(graph, &simple, &mass);
    let (route, partial) = match open.map(|(_, term)| term).or(obstacle).filter(|_| !needs_energy) {
        Some(obstacle) => (Route::Velocities { obstacle }, without_velocities(graph, written)),
        None => {
            let velocities = diff::gradient(graph, energy, degrees).p;
            let mut partial = at_velocities(graph, written, &velocities, &parts);
            let divided = divided.iter().copied().filter(|node| !graph.reads(*node).v);
            add_unconditional(&mut partial, divided);
            partial.dedup();
            (Route::Energy { energy, velocities }, partial)
        }
    };
    let concave = mass::is_negative(graph, &mass);
    let gauge = gauge(graph, &shift);
    Ok(Legendre {
        lagrangian,
        forces,
        momenta,
        parts,
        potential,
        mass,
        shift,
        route,
        partial,
        divisors: divisors(graph, &divided),
        concave,
        gauge,
        friction: None,
    })
}

/// Returns f with ∂f/∂q = a, if a(q, t) is a gradient and not zero.
fn gauge(graph: &mut Graph, shift: &[Id]) -> Option<Id> {
    let zero = shift.iter().all(|a| graph.is_zero(*a));
    if zero || shift.iter().any(|a| graph.reads(*a).s) {
        return None;
    }
    let positions: Vec<Symbol> = (0..shift.len() as u32).map(Symbol::Position).collect();
    let (gauge, _) = antiderivative(graph, &positions, shift, Logarithm::OfMagnitude).ok()?;
    Some(gauge)
}

/// Returns the partial nodes of L, or of a force, that can be checked without velocities.
pub(crate) fn without_velocities(graph: &Graph, written: &[UndefinedAt]) -> Vec<UndefinedAt> {
    let free = |id: &Id| !graph.reads(*id).v;
    let mut partial = written.to_vec();
    partial.retain(|UndefinedAt { node, condition }| free(node) && condition.iter().all(free));
    partial
}

/// Adds nodes that are always computed to a list of partial nodes, unless the list already contains them.
fn add_unconditional(partial: &mut Vec<UndefinedAt>, nodes: impl Iterator<Item = Id>) {
    let known: Vec<Id> = partial.iter().map(|partial| partial.node).collect();
    let new = nodes.filter(|node| !known.contains(node));
    partial.extend(new.map(|node| UndefinedAt { node, condition: None }));
}

/// Returns the divisors of the nodes that are quotients.
fn divisors(graph: &Graph, nodes: &[Id]) -> Vec<Id> {
    let divisor = |id: &Id| match graph.node(*id) {
        Node::Power(base, exponent) if exponent.numerator < 0 => Some(*base),
        _ => None,
    };
    nodes.iter().filter_map(divisor).collect()
}

/// Returns a node at zero velocities.
fn at_rest(graph: &mut Graph, node: Id) -> Id {
    at_zero(graph, node, is_velocity)
}

/// Returns whether a symbol is a velocity.
fn is_velocity(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Velocity(_))
}

/// Returns the partial nodes of L at the velocities that belong to momenta. Terms with a conjugate are left out, because these velocities lie in
/// their domain.
fn at_velocities(graph: &mut Graph, written: &[UndefinedAt], velocities: &[Id], parts: &[Part]) -> Vec<UndefinedAt> {
    let conjugate = |i: u32| {
        let mut of = parts.iter().filter(|part| matches!(part.kinetic, Kinetic::Conjugate { .. }));
        of.any(|part| part.velocities.contains(&i))
    };
    let mut there = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Velocity(i) => Some(velocities[i as usize]),
        _ => None,
    });
    let mut partial = vec![];
    for UndefinedAt { node, condition } in written {
        if !graph.reads_any(*node, |symbol| matches!(symbol, Symbol::Velocity(i) if conjugate(i))) {
            let condition = condition.map(|condition| there.apply(graph, condition));
            partial.push(UndefinedAt { node: there.apply(graph, *node), condition });
        }
    }
    partial
}
