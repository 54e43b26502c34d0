//! From a Lagrangian L(q, v, s, t) to its energy H(q, p, s, t) = p·v − L with p = ∂L/∂v, where v follows from p in closed form.
//!
//! Velocities that no second derivative of L couples are parts of their own. In each L is quadratic, and then M is factored once, or one
//! term of a known conjugate with terms that are linear. What is made is one more energy: everything else follows from that.

mod conjugate;
mod definite;
mod first_order;
mod friction;
mod invariant;
mod kinks;
mod mass;
mod parts;
mod quadratic;

use crate::analyze;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Partial, Symbol};
pub(crate) use definite::{Definite, definite};
pub(crate) use first_order::{Canonical, FirstOrder, NotRegular, first_order};
pub(crate) use friction::{Friction, NoFriction, friction, rate};
use parts::Parts;

/// What belongs to a Lagrangian.
#[derive(Debug)]
pub(crate) struct Legendre {
    pub(crate) lagrangian: Id,
    /// ∂L/∂q.
    pub(crate) forces: Vec<Id>,
    /// ∂L/∂v.
    pub(crate) momenta: Vec<Id>,
    pub(crate) parts: Vec<Part>,
    /// What of −L reads no velocity.
    pub(crate) potential: Id,
    /// M, symmetric, and free of velocities where L is quadratic.
    pub(crate) mass: Vec<Vec<Id>>,
    /// ∂L/∂v at rest.
    pub(crate) shift: Vec<Id>,
    pub(crate) route: Route,
    /// What of L and H is not defined everywhere.
    pub(crate) partial: Vec<Partial>,
    /// What H is divided by. It vanishes where M is singular.
    pub(crate) divisors: Vec<Id>,
    /// Whether M is negative definite, whatever the parameters are.
    pub(crate) concave: bool,
    /// f(q, t), if what is linear in v is ∂f/∂q·v.
    pub(crate) gauge: Option<Id>,
    /// γ of friction γMv.
    pub(crate) friction: Option<Id>,
}

/// What steps are derived from.
#[derive(Debug)]
pub(crate) enum Route {
    /// H, with ∂H/∂p.
    Energy(Id, Vec<Id>),
    /// L itself, with velocities as unknowns: H would be long by this entry of M, or has no formula because of this term.
    Velocities(Id),
}

/// Velocities that L couples, in order, and how they follow from momenta.
#[derive(Debug)]
pub(crate) struct Part {
    pub(crate) velocities: Vec<u32>,
    pub(crate) kinetic: Kinetic,
}

/// What L is in the velocities of a part.
#[derive(Debug)]
pub(crate) enum Kinetic {
    /// vᵀMv/2 + a·v.
    Quadratic { mass: Vec<Vec<Id>>, shift: Vec<Id> },
    /// A term of the table of conjugates, and its rule.
    Conjugate { term: Id, rule: &'static str },
    /// Not quadratic, and of no known conjugate.
    Open(Id),
}

/// Why a Lagrangian has no energy here.
#[derive(Debug)]
pub(crate) enum Flaw {
    /// This velocity is read nowhere.
    Unread(u32),
    /// The momentum of this velocity jumps where velocities change.
    Jumps(u32, Id),
    /// L is linear in all velocities: these are the momenta.
    Linear(Vec<Id>),
    /// L is linear in this velocity, and does not couple it to another one: this is its momentum.
    LinearIn(u32, Id),
    /// The mass matrix of these velocities is singular at every state, in this direction.
    Singular(Vec<u32>, Vec<Id>),
    /// v is known to follow from p, but not by a formula of the table.
    NotClosed(Vec<u32>, Id),
}

/// From what steps are derived, and what was found on the way. `closed` asks for H.
pub(crate) fn transform(
    graph: &mut Graph,
    lagrangian: Id,
    (degrees, closed): (u32, bool),
    written: &[Partial],
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
    let shift: Vec<Id> = momenta.iter().map(|momentum| at_rest(graph, *momentum, |_| true)).collect();

    // What is divided by here must not vanish either.
    graph.take_partial();
    let Parts { parts, kinetic, potential, long } =
        parts::parts(graph, lagrangian, (&momenta, &simple, &shift), closed)?;
    let energy = graph.add(kinetic, potential);
    let divided = graph.take_partial();
    graph.stop_recording();

    let open = parts.iter().find_map(|part| match part.kinetic {
        Kinetic::Open(term) => Some((&part.velocities, term)),
        _ => None,
    });
    if let (Some((velocities, term)), true) = (open, closed) {
        return Err(Flaw::NotClosed(velocities.clone(), term));
    }
    // What is free of the state is; the rest of M goes best with the terms of L, which share its functions.
    let mass = mass::choose(graph, &simple, &mass);
    let (route, partial) = match open.map(|(_, term)| term).or(long).filter(|_| !closed) {
        Some(long) => (Route::Velocities(long), at_points(graph, written)),
        None => {
            let velocities = diff::gradient(graph, energy, degrees).p;
            let mut partial = carried(graph, written, &velocities, &parts);
            let known: Vec<Id> = partial.iter().map(|partial| partial.node).collect();
            let new = divided.iter().filter(|node| !graph.reads(**node).v && !known.contains(node));
            partial.extend(new.map(|node| Partial { node: *node, condition: None }));
            partial.dedup();
            (Route::Energy(energy, velocities), partial)
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

/// f with ∂f/∂q = a, if a(q, t) is a gradient, and not zero.
fn gauge(graph: &mut Graph, shift: &[Id]) -> Option<Id> {
    let zero = shift.iter().all(|a| graph.is_zero(*a));
    if zero || shift.iter().any(|a| graph.reads(*a).s) {
        return None;
    }
    let positions: Vec<Symbol> = (0..shift.len() as u32).map(Symbol::Position).collect();
    let found =
        analyze::liouville::antiderivative(graph, &positions, shift, analyze::liouville::Logarithm::OfMagnitude);
    found.ok().map(|(gauge, _)| gauge)
}

/// What of L, or of a force, is not defined everywhere and can be looked at without velocities.
pub(crate) fn at_points(graph: &Graph, written: &[Partial]) -> Vec<Partial> {
    let free = |id: &Id| !graph.reads(*id).v;
    let mut partial = written.to_vec();
    partial.retain(|Partial { node, condition }| free(node) && condition.iter().all(free));
    partial
}

/// The divisors of nodes that are quotients.
fn divisors(graph: &Graph, nodes: &[Id]) -> Vec<Id> {
    let divisor = |id: &Id| match graph.node(*id) {
        Node::Power(base, exponent) if exponent.numerator < 0 => Some(*base),
        _ => None,
    };
    nodes.iter().filter_map(divisor).collect()
}

/// A node for some velocities zero.
fn at_rest(graph: &mut Graph, node: Id, which: impl Fn(u32) -> bool) -> Id {
    let zero = |graph: &mut Graph, symbol| match symbol {
        Symbol::Velocity(i) if which(i) => Some(graph.zero()),
        _ => None,
    };
    Substitution::new(zero).apply(graph, node)
}

/// What of L is not defined everywhere, at the velocities that belong to momenta. Terms with a conjugate are defined for all of theirs.
fn carried(graph: &mut Graph, written: &[Partial], velocities: &[Id], parts: &[Part]) -> Vec<Partial> {
    let conjugate = |i: u32| {
        let mut of = parts.iter().filter(|part| matches!(part.kinetic, Kinetic::Conjugate { .. }));
        of.any(|part| part.velocities.contains(&i))
    };
    let mut there = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Velocity(i) => Some(velocities[i as usize]),
        _ => None,
    });
    let mut partial = vec![];
    for Partial { node, condition } in written {
        let read = graph.symbols(*node);
        if !read.iter().any(|symbol| matches!(symbol, Symbol::Velocity(i) if conjugate(*i))) {
            let condition = condition.map(|condition| there.apply(graph, condition));
            partial.push(Partial { node: there.apply(graph, *node), condition });
        }
    }
    partial
}
