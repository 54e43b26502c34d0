//! From a Lagrangian L(q, v, s, t) to its energy H(q, p, s, t) = p·v − L with p = ∂L/∂v, where v follows from p in closed form.
//!
//! Velocities that no second derivative of L couples are parts of their own. In each L is quadratic, and then M is factored once, or one
//! term of a known conjugate with terms that are linear. What is made is one more energy: everything else follows from that.

mod conjugate;
mod first_order;
mod friction;
mod invariant;
mod quadratic;

use crate::analyze;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Partial, Symbol};
pub(crate) use first_order::{Canonical, FirstOrder, NotRegular, first_order};
pub(crate) use friction::{Friction, NoFriction, friction, rate};

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
    /// L is linear in all velocities: these are the momenta.
    Linear(Vec<Id>),
    /// L is linear in this velocity, and does not couple it to another one: this is its momentum.
    LinearIn(u32, Id),
    /// The mass matrix of these velocities is singular at every state, in this direction.
    Singular(Vec<u32>, Vec<Id>),
    /// v is known to follow from p, but not by a formula of the table.
    NotClosed(Vec<u32>, Id),
}

/// From so many velocities on that a full mass matrix couples, H costs more than L with its velocities as unknowns: twice as much with 3,
/// five times with 6.
const FULL: usize = 3;

/// From what steps are derived, and what was found on the way. `closed` asks for H.
pub(crate) fn transform(
    graph: &mut Graph,
    lagrangian: Id,
    (degrees, closed): (u32, bool),
    written: &[Partial],
) -> Result<Legendre, Flaw> {
    let symbols: Vec<Symbol> = (0..degrees).map(Symbol::V).collect();
    let diff::Gradient { q: forces, v: momenta, .. } = diff::gradient(graph, lagrangian, degrees);
    let mass = masses(graph, &momenta, &symbols);
    regular(graph, &momenta, &mass)?;
    let simple = simplified(graph, &mass);
    regular(graph, &momenta, &simple)?;
    let shift: Vec<Id> = momenta.iter().map(|momentum| at_rest(graph, *momentum, |_| true)).collect();

    // What is divided by here must not vanish either.
    graph.take_partial();
    let Parts { parts, kinetic, potential, long } = self::parts(graph, lagrangian, (&simple, &shift))?;
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
    let mass = choose(graph, &simple, &mass);
    let (route, partial) = match open.map(|(_, term)| term).or(long).filter(|_| !closed) {
        Some(long) => (Route::Velocities(long), at_points(graph, written)),
        None => {
            let velocities = diff::gradient(graph, energy, degrees).p;
            let mut partial = carried(graph, written, &velocities, &parts);
            let known: Vec<Id> = partial.iter().map(|partial| partial.node).collect();
            let new = divided.into_iter().filter(|node| !analyze::reads(graph, *node).v && !known.contains(node));
            partial.extend(new.map(|node| Partial { node, condition: None }));
            partial.dedup();
            (Route::Energy(energy, velocities), partial)
        }
    };
    let concave = is_negative(graph, &mass);
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
        concave,
        gauge,
        friction: None,
    })
}

/// f with ∂f/∂q = a, if a(q, t) is a gradient, and not zero.
fn gauge(graph: &mut Graph, shift: &[Id]) -> Option<Id> {
    let zero = shift.iter().all(|a| graph.is_zero(*a));
    if zero || shift.iter().any(|a| analyze::reads(graph, *a).s) {
        return None;
    }
    let positions: Vec<Symbol> = (0..shift.len() as u32).map(Symbol::Q).collect();
    let found =
        analyze::liouville::antiderivative(graph, (&positions, shift), analyze::liouville::Logarithm::OfMagnitude);
    found.ok().map(|(gauge, _)| gauge)
}

/// Whether a diagonal matrix is known to be negative definite.
fn is_negative(graph: &mut Graph, mass: &[Vec<Id>]) -> bool {
    (0..mass.len()).all(|i| {
        let opposite = graph.neg(mass[i][i]);
        (0..mass.len()).all(|j| i == j || graph.is_zero(mass[i][j])) && analyze::is_positive(graph, opposite)
    })
}

/// M without coordinates on which its entries do not depend.
fn simplified(graph: &mut Graph, mass: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let mut simple = mass.to_vec();
    for i in 0..mass.len() {
        for j in 0..=i {
            let entry =
                if analyze::reads(graph, mass[i][j]).v { mass[i][j] } else { invariant::simplified(graph, mass[i][j]) };
            (simple[i][j], simple[j][i]) = (entry, entry);
        }
    }
    simple
}

/// Entries of the first matrix where they read no state, else of the second.
fn choose(graph: &Graph, simple: &[Vec<Id>], written: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let entry = |(simple, written): (&Id, &Id)| if analyze::reads(graph, *simple).state() { *written } else { *simple };
    simple.iter().zip(written).map(|(simple, written)| simple.iter().zip(written).map(entry).collect()).collect()
}

/// L taken apart.
struct Parts {
    parts: Vec<Part>,
    /// What is known of H in the momenta.
    kinetic: Id,
    potential: Id,
    /// An entry of M for which H would be long.
    long: Option<Id>,
}

fn parts(graph: &mut Graph, lagrangian: Id, (mass, shift): (&[Vec<Id>], &[Id])) -> Result<Parts, Flaw> {
    let (mut parts, mut squares, mut kinetic) = (vec![], vec![], vec![]);
    let (mut rest, mut others, mut long) = (lagrangian, vec![], None);
    for velocities in blocks(graph, mass) {
        let picked = |row: &[Id]| velocities.iter().map(|i| row[*i as usize]).collect::<Vec<Id>>();
        let block: Vec<Vec<Id>> = velocities.iter().map(|i| picked(&mass[*i as usize])).collect();
        if block.iter().flatten().any(|entry| analyze::reads(graph, *entry).v) {
            others.push(velocities);
            continue;
        }
        let shift = picked(shift);
        let reduced = reduced(graph, &velocities, &shift);
        match quadratic::inverse_form(graph, &block, &reduced) {
            Ok(mut form) => squares.append(&mut form),
            Err(quadratic::NoForm::Singular(combination)) => return Err(singular(graph, velocities, combination)),
            Err(quadratic::NoForm::NoPivot(entry)) => long = Some(entry),
        }
        if block.len() >= FULL {
            long = long.or_else(|| block.iter().flatten().copied().find(|entry| moves(graph, *entry)));
        }
        rest = at_rest(graph, rest, |i| velocities.contains(&i));
        parts.push(Part { velocities, kinetic: Kinetic::Quadratic { mass: block, shift } });
    }
    let squares = quadratic::sum(graph, &squares);
    kinetic.push(graph.scale(Number::HALF, squares));
    let conjugates = !others.is_empty();
    for velocities in others {
        let alone = at_rest(graph, rest, |i| !velocities.contains(&i));
        let found = match conjugate::of(graph, alone, &velocities) {
            Some(conjugate::Conjugate { term, energy, rule }) => {
                kinetic.push(energy);
                Kinetic::Conjugate { term, rule }
            }
            None => {
                let picked = |i: &u32| velocities.iter().map(|j| mass[*i as usize][*j as usize]).collect();
                let block: Vec<Vec<Id>> = velocities.iter().map(picked).collect();
                let none = graph.zero();
                let momenta = reduced(graph, &velocities, &vec![none; block.len()]);
                if let Err(quadratic::NoForm::Singular(combination)) = quadratic::inverse_form(graph, &block, &momenta)
                {
                    return Err(singular(graph, velocities, combination));
                }
                Kinetic::Open(alone)
            }
        };
        parts.push(Part { velocities, kinetic: found });
    }
    // What has a conjugate goes with its velocities.
    if conjugates {
        let mut still = conjugate::terms(graph, rest);
        still.retain(|term| !analyze::reads(graph, *term).v);
        rest = graph.sum(&still);
    }
    parts.sort_by_key(|part| part.velocities[0]);
    let (kinetic, potential) = (graph.sum(&kinetic), graph.neg(rest));
    Ok(Parts { parts, kinetic, potential, long })
}

/// w·p = 0 at every state says that wᵀM = 0.
fn singular(graph: &mut Graph, velocities: Vec<u32>, combination: Id) -> Flaw {
    let momenta: Vec<Symbol> = velocities.iter().map(|i| Symbol::P(*i)).collect();
    let direction = diff::jacobian(graph, &[combination], &momenta).concat();
    Flaw::Singular(velocities, direction)
}

/// Whether a node reads the state or time.
fn moves(graph: &Graph, id: Id) -> bool {
    let reads = analyze::reads(graph, id);
    reads.state() || reads.t
}

/// What of L, or of a force, is not defined everywhere and can be looked at without velocities.
pub(crate) fn at_points(graph: &Graph, written: &[Partial]) -> Vec<Partial> {
    let still = |id: &Id| !analyze::reads(graph, *id).v;
    let mut partial = written.to_vec();
    partial.retain(|Partial { node, condition }| still(node) && condition.iter().all(still));
    partial
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
    if all.len() == mass.len() && momenta.iter().any(|momentum| !graph.is_zero(*momentum)) {
        return Err(Flaw::Linear(momenta.to_vec()));
    }
    if let Some(unread) = all.iter().find(|i| graph.is_zero(momenta[**i])) {
        return Err(Flaw::Unread(*unread as u32));
    }
    Err(Flaw::LinearIn(*first as u32, momenta[*first]))
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
