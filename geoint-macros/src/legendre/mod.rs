//! From a Lagrangian L(q, v, s, t) to its energy H(q, p, s, t) = p·v − L with p = ∂L/∂v, where v follows from p in closed form.
//!
//! Velocities that no second derivative of L couples are parts of their own. In each L is quadratic, and then M is factored once, or one
//! term of a known conjugate with terms that are linear. What is made is one more energy: everything else follows from that.

mod conjugate;
mod friction;
mod quadratic;

use crate::analyze;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Partial, Symbol};
pub(crate) use friction::{NoFriction, friction};

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
    /// H.
    pub(crate) energy: Id,
    /// ∂H/∂p.
    pub(crate) velocities: Vec<Id>,
    /// What of L and H is not defined everywhere.
    pub(crate) partial: Vec<Partial>,
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
}

/// Why a Lagrangian has no energy here.
#[derive(Debug)]
pub(crate) enum Flaw {
    /// This velocity is read nowhere.
    Unread(u32),
    /// L is linear in all velocities: these are the momenta.
    Linear(Vec<Id>),
    /// L is linear in this velocity, and does not couple it to another one: this is its momentum.
    LinearIn(u32, Id),
    /// The mass matrix of these velocities is singular at every state.
    Singular(Vec<u32>),
    /// v is known to follow from p, but not by a formula of the table.
    NotClosed(Vec<u32>, Id),
}

/// H, and how it was found.
pub(crate) fn transform(
    graph: &mut Graph,
    lagrangian: Id,
    degrees: u32,
    written: &[Partial],
) -> Result<Legendre, Flaw> {
    let symbols: Vec<Symbol> = (0..degrees).map(Symbol::V).collect();
    let diff::Gradient { q: forces, v: momenta, .. } = diff::gradient(graph, lagrangian, degrees);
    let mass = masses(graph, &momenta, &symbols);
    regular(graph, &momenta, &mass)?;

    // What is divided by here must not vanish either.
    graph.take_partial();
    let mut parts = vec![];
    let (mut squares, mut kinetic) = (vec![], vec![]);
    let mut rest = lagrangian;
    let mut open = vec![];
    for velocities in blocks(graph, &mass) {
        if velocities.iter().any(|i| velocities.iter().any(|j| analyze::reads(graph, mass[*i as usize][*j as usize]).v))
        {
            open.push(velocities);
            continue;
        }
        let of = |i: &u32| *i as usize;
        let block: Vec<Vec<Id>> =
            velocities.iter().map(|i| velocities.iter().map(|j| mass[of(i)][of(j)]).collect()).collect();
        let shift: Vec<Id> = velocities.iter().map(|i| at_rest(graph, momenta[of(i)], |_| true)).collect();
        let reduced = reduced(graph, &velocities, &shift);
        let Some(mut form) = quadratic::inverse_form(graph, &block, &reduced) else {
            return Err(Flaw::Singular(velocities));
        };
        squares.append(&mut form);
        rest = at_rest(graph, rest, |i| velocities.contains(&i));
        parts.push(Part { velocities, kinetic: Kinetic::Quadratic { mass: block, shift } });
    }
    for velocities in open {
        let alone = at_rest(graph, rest, |i| !velocities.contains(&i));
        let conjugate::Conjugate { term, energy, rule } =
            conjugate::of(graph, alone, &velocities).ok_or_else(|| Flaw::NotClosed(velocities.clone(), alone))?;
        kinetic.push(energy);
        parts.push(Part { velocities, kinetic: Kinetic::Conjugate { term, rule } });
    }
    // What has a conjugate goes with its velocities.
    let without = if parts.iter().any(|part| matches!(part.kinetic, Kinetic::Conjugate { .. })) {
        let terms = conjugate::terms(graph, rest);
        let still: Vec<Id> = terms.into_iter().filter(|term| !analyze::reads(graph, *term).v).collect();
        graph.sum(&still)
    } else {
        rest
    };
    let potential = graph.neg(without);
    parts.sort_by_key(|part| part.velocities[0]);
    let squares = quadratic::sum(graph, &squares);
    kinetic.push(graph.scale(Number::HALF, squares));
    let kinetic = graph.sum(&kinetic);
    let energy = graph.add(kinetic, potential);
    let divided = graph.take_partial();
    graph.stop_recording();

    let velocities = diff::gradient(graph, energy, degrees).p;
    let mut partial = carried(graph, written, &velocities, &parts);
    let known: Vec<Id> = partial.iter().map(|partial| partial.node).collect();
    let new = divided.into_iter().filter(|node| !analyze::reads(graph, *node).v && !known.contains(node));
    partial.extend(new.map(|node| Partial { node, condition: None }));
    partial.dedup();
    Ok(Legendre { lagrangian, forces, momenta, parts, potential, energy, velocities, partial })
}

/// ∂²L/∂v², of equal entries one; free of v where it can be.
fn masses(graph: &mut Graph, momenta: &[Id], symbols: &[Symbol]) -> Vec<Vec<Id>> {
    let mut mass = diff::jacobian(graph, momenta, symbols);
    let affine = |graph: &Graph, momentum: Id| analyze::is_polynomial_in(graph, &[momentum], 1, is_velocity);
    for i in 0..mass.len() {
        for j in 0..=i {
            // A constant may have been written with velocities in it.
            let entry = if affine(graph, momenta[i]) { at_rest(graph, mass[i][j], |_| true) } else { mass[i][j] };
            (mass[i][j], mass[j][i]) = (entry, entry);
        }
    }
    mass
}

fn is_velocity(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::V(_))
}

/// A node for some velocities zero.
fn at_rest(graph: &mut Graph, node: Id, which: impl Fn(u32) -> bool) -> Id {
    let zero = |graph: &mut Graph, symbol| match symbol {
        Symbol::V(i) if which(i) => Some(graph.zero()),
        _ => None,
    };
    Substitution::new(zero).apply(graph, node)
}

/// p − a for the velocities of a part.
fn reduced(graph: &mut Graph, velocities: &[u32], shift: &[Id]) -> Vec<Id> {
    let mut momentum = |(i, a): (&u32, &Id)| {
        let p = graph.symbol(Symbol::P(*i));
        graph.sub(p, *a)
    };
    velocities.iter().zip(shift).map(&mut momentum).collect()
}

/// Refuses a Lagrangian some of whose velocities have no inertia.
fn regular(graph: &Graph, momenta: &[Id], mass: &[Vec<Id>]) -> Result<(), Flaw> {
    let massless = |i: &usize| mass[*i].iter().all(|entry| graph.is_zero(*entry));
    let all: Vec<usize> = (0..mass.len()).filter(massless).collect();
    let Some(first) = all.first() else { return Ok(()) };
    if let Some(unread) = all.iter().find(|i| graph.is_zero(momenta[**i])) {
        return Err(Flaw::Unread(*unread as u32));
    }
    Err(if all.len() == mass.len() {
        Flaw::Linear(momenta.to_vec())
    } else {
        Flaw::LinearIn(*first as u32, momenta[*first])
    })
}

/// The velocities that entries of M couple, directly or by others.
fn blocks(graph: &Graph, mass: &[Vec<Id>]) -> Vec<Vec<u32>> {
    let mut blocks: Vec<Vec<u32>> = vec![];
    for i in 0..mass.len() {
        let coupled = |block: &Vec<u32>| block.iter().any(|j| !graph.is_zero(mass[i][*j as usize]));
        let (mine, others): (Vec<_>, Vec<_>) = blocks.into_iter().partition(coupled);
        blocks = others;
        let mut block = mine.concat();
        block.push(i as u32);
        block.sort_unstable();
        blocks.push(block);
    }
    blocks.sort();
    blocks
}

/// What of L is not defined everywhere, at the velocities that belong to momenta. Terms with a conjugate are defined for all of theirs.
fn carried(graph: &mut Graph, written: &[Partial], velocities: &[Id], parts: &[Part]) -> Vec<Partial> {
    let conjugate = |i: u32| {
        let mut of = parts.iter().filter(|part| matches!(part.kinetic, Kinetic::Conjugate { .. }));
        of.any(|part| part.velocities.contains(&i))
    };
    let mut there = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::V(i) => Some(velocities[i as usize]),
        _ => None,
    });
    let mut partial = vec![];
    for Partial { node, condition } in written {
        let read = analyze::symbols(graph, *node);
        if !read.iter().any(|symbol| matches!(symbol, Symbol::V(i) if conjugate(*i))) {
            let condition = condition.map(|condition| there.apply(graph, condition));
            partial.push(Partial { node: there.apply(graph, *node), condition });
        }
    }
    partial
}
